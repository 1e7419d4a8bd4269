#include "harness/studies/frontier/frontier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "harness/studies/frontier/frontier_pages.h"
#include "tests/harness/runs/small_plan.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

/// Without degenerate pairs Lemke's algorithm takes a pivot per active pair and one for z0: a limit
/// of 3 is a line that is known exactly. best-first, without one, solves all; the liar nothing.
FrontierPlan exact_plan() {
  FrontierPlan plan;
  plan.grid = {"semidefinite:degenerate=0", parse_axis("n=8,10", "--x"),
               parse_axis("active=1,2,3,4", "--y")};
  plan.limits.solvers = make_solvers({"lemke:max_pivots=3", "best-first", "liar"});
  plan.limits.timeout = std::chrono::seconds(60);
  plan.count = 4;
  plan.max_count = 8;
  return plan;
}

/// Semidefinite problems that a solver with few pivots solves by luck: cells that are neither 0 nor
/// 1.
FrontierPlan noisy_plan() {
  FrontierPlan plan;
  plan.grid = {"semidefinite:n=8", parse_axis("degenerate=1,2", "--x"),
               parse_axis("active=1,2,3,4", "--y")};
  plan.limits.solvers = make_solvers({"lemke:max_pivots=5", "best-first"});
  plan.limits.timeout = std::chrono::seconds(60);
  plan.count = 4;
  plan.max_count = 16;
  return plan;
}

std::optional<Frontier> run_in(const std::string& directory, const FrontierPlan& plan,
                               Existing existing, std::size_t pairs) {
  std::atomic<bool> interrupted = false;
  return run_frontier(
      directory, plan, existing, [](const std::string&) {},
      [&](const Progress& progress) { interrupted = pairs > 0 && progress.done >= pairs; },
      interrupted);
}

/// The frontier of exact_plan(), found once for all tests.
const Frontier& exact_frontier() {
  static const Frontier found = [] {
    const TemporaryDirectory directory;
    return *run_in(directory.file("r"), exact_plan(), Existing::refuse, 0);
  }();
  return found;
}

class FrontierRun : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return directory_.file(name); }
  /// Gives up after so many pairs, unless 0.
  std::optional<Frontier> run(const std::string& name, const FrontierPlan& plan,
                              Existing existing = Existing::refuse, std::size_t pairs = 0) {
    return run_in(at(name), plan, existing, pairs);
  }

 private:
  const TemporaryDirectory directory_;
};

TEST_F(FrontierRun, FindsTheLineWhereALimitIsReached) {
  const Frontier& found = exact_frontier();
  ASSERT_EQ(found.rows.size(), 3u);
  for (const FrontierColumn& column : found.rows[0].columns) {
    ASSERT_EQ(column.line.kind, ShareLine::Kind::crossing);
    EXPECT_FALSE(column.line.rising);
    EXPECT_EQ(column.cells[1].solved, 4);
    EXPECT_EQ(column.cells[2].solved, 0);
    EXPECT_EQ(column.cells[2].verdicts.at(Verdict::limit), 4);
    EXPECT_DOUBLE_EQ(column.line.u, 2.5);
    EXPECT_EQ(column.cells[2].drawn, 4) << "decided at once";
    EXPECT_FALSE(column.cells[2].pivots.has_value());
    EXPECT_EQ(column.cells[1].pivots, 3);
  }
  for (const FrontierColumn& column : found.rows[1].columns)
    EXPECT_EQ(column.line.kind, ShareLine::Kind::above);
  for (const FrontierColumn& column : found.rows[2].columns) {
    EXPECT_EQ(column.line.kind, ShareLine::Kind::below);
    EXPECT_EQ(column.cells[0].verdicts.at(Verdict::wrong), 4);
  }
}

TEST_F(FrontierRun, CountsCrashesAndHangsAsNotSolved) {
  FrontierPlan plan = exact_plan();
  plan.grid.y = parse_axis("active=1,2", "--y");
  const auto expect_all = [&](const std::string& solver, Verdict verdict) {
    plan.limits.solvers = make_solvers({solver});
    const Frontier found = *run(solver, plan);
    for (const FrontierColumn& column : found.rows.at(0).columns) {
      EXPECT_EQ(column.line.kind, ShareLine::Kind::below);
      EXPECT_TRUE(column.settled);
      EXPECT_EQ(column.cells[0].verdicts.at(verdict), 4);
    }
  };
  expect_all("crasher", Verdict::crash);
  plan.limits.timeout = std::chrono::milliseconds(20);
  expect_all("sleeper", Verdict::timeout);
}

TEST_F(FrontierRun, AddsDrawsWhereTheShareIsOpenAndOnlyForTheSolverThatWantsThem) {
  const FrontierPlan plan = noisy_plan();
  const Frontier found = *run("r", plan);
  Index most = 0;
  for (const FrontierColumn& column : found.rows[0].columns)
    for (const FrontierCell& cell : column.cells) most = std::max(most, cell.drawn);
  EXPECT_GT(most, plan.count);
  EXPECT_LE(most, plan.max_count);
  for (const FrontierColumn& column : found.rows[1].columns) {
    EXPECT_EQ(column.line.kind, ShareLine::Kind::above);
    for (const FrontierCell& cell : column.cells) EXPECT_EQ(cell.drawn, plan.count);
  }
  for (const FrontierColumn& column : found.rows[0].columns) {
    const std::vector<SharePoint> points = share_points(plan.grid.y, column);
    const std::vector<bool> wanted = more_wanted(column.line, points, plan.width());
    for (std::size_t y = 0; y < wanted.size(); ++y)
      EXPECT_TRUE(!wanted[y] || column.cells[y].drawn == plan.max_count);
  }
}

TEST_F(FrontierRun, ResumedAfterInterruptionsComesToTheSameEnd) {
  const Frontier whole = *run("whole", noisy_plan());
  for (const std::size_t pairs : {1u, 5u, 40u})
    EXPECT_FALSE(run("r", noisy_plan(), Existing::resume, pairs).has_value());
  const Frontier resumed = *run("r", noisy_plan(), Existing::resume);
  EXPECT_EQ(described({whole, {}}).json, described({resumed, {}}).json);
  EXPECT_EQ(read_run(at("r")).size(), read_run(at("whole")).size()) << "no pair twice";
  const std::string rows = read_text(at("r/rows.jsonl"));
  EXPECT_EQ(described({*run("r", noisy_plan(), Existing::resume), {}}).csv,
            described({whole, {}}).csv);
  EXPECT_EQ(read_text(at("r/rows.jsonl")), rows) << "nothing was left to do";
}

TEST_F(FrontierRun, RefusesToResumeAnotherQuestion) {
  EXPECT_FALSE(run("r", exact_plan(), Existing::refuse, 1).has_value());
  FrontierPlan other = exact_plan();
  other.seed = 2;
  EXPECT_THROW(run("r", other, Existing::resume), std::invalid_argument);
  EXPECT_THROW(run("r", exact_plan()), std::invalid_argument);
}

TEST_F(FrontierRun, RefusesKnobsBeforeItWritesAnything) {
  FrontierPlan plan = exact_plan();
  plan.grid.y = parse_axis("active=1,100", "--y");
  EXPECT_THROW(run("r", plan), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(at("r")));
}

TEST_F(FrontierRun, ASecondSeedReproducesWhatIsExactAndCanContradict) {
  const Frontier& first = exact_frontier();
  FrontierPlan plan = exact_plan();
  plan.seed = 2;
  const Frontier second = *run("b", plan);
  const std::vector<SeedAgreement> same = seed_agreements(first, second);
  ASSERT_EQ(same.size(), 3u);
  EXPECT_EQ(same[0].agree, 2);
  EXPECT_EQ(same[0].lines, 2);
  EXPECT_EQ(same[0].within, 2);
  EXPECT_EQ(same[1].agree, 2);
  EXPECT_EQ(same[1].lines, 0);

  Frontier contradicting = second;
  contradicting.rows[0] = second.rows[2];  // the liar's
  EXPECT_EQ(seed_agreements(first, contradicting)[0].agree, 0);
}

TEST_F(FrontierRun, IsToldInTextCsvAndJson) {
  const Frontier& found = exact_frontier();
  const std::string text = described({found, found}).text;
  EXPECT_NE(text.find("2.5 [2.02, 2.98]"), std::string::npos) << text;
  EXPECT_NE(text.find("2 of 2 (2 of 2)"), std::string::npos) << text;
  EXPECT_NE(text.find("liar"), std::string::npos) << text;
  EXPECT_NE(text.find("agree in 6 of 6 columns; of 2 lines that both find"), std::string::npos)
      << text;

  const std::string csv = described({found, {}}).csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 2 * 4);
  EXPECT_NE(csv.find("liar,1,10,4,4,4,0,0.0000,0.4899,,wrong 4\n"), std::string::npos) << csv;

  const nlohmann::json json = described({found, {}}).json;
  EXPECT_EQ(json.at("rows")[0].at("columns")[1].at("line"), "crossing");
  EXPECT_EQ(json.at("rows")[0].at("columns")[1].at("y"), 2.5);
  EXPECT_EQ(json.at("rows")[2].at("columns")[0].at("line"), "below");
  EXPECT_FALSE(json.contains("check"));
}

TEST_F(FrontierRun, IsDrawnWithAPanelPerSolverAndANoteWhereThereIsNoLine) {
  const Frontier& found = exact_frontier();
  const Figure figure = described({found, {}}).figure;
  const auto note_of = [&](const std::string& solver) {
    for (const Panel& panel : figure.panels)
      if (panel.title == solver) return panel.series.back().marks.at(0).text;
    return std::string("no panel");
  };
  EXPECT_EQ(note_of("liar"), "no line: below 1/2 in every column");
  EXPECT_EQ(note_of("lemke:max_pivots=3"), "line in every column");
  EXPECT_NO_THROW(draw_figure(at("frontier.svg"), figure));
  EXPECT_NE(read_text(at("frontier.svg")).find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace lcp
