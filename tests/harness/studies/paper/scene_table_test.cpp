#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "harness/studies/paper/reproduce.h"
#include "harness/studies/paper/table_pictures.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"
#include "tests/harness/studies/paper/reproduction_test.h"

namespace lcp {
namespace {

namespace fs = std::filesystem;

/// A simulation of two links that ended with both at x (m), after as many steps of 1 ms.
LoopColumn made_up(const PaperColumn& solver, const std::string& scene, double x, Index steps) {
  LoopColumn column;
  column.question = {scene, solver.solver, solver.acceptance, {}};
  LoopSummary& summary = column.summary;
  summary.dt = 1e-3;
  summary.duration = 0.02;
  summary.steps = summary.total_frames = steps;
  if (steps < 20) summary.broken = "flew apart";
  for (Index i = 0; i <= steps; ++i)
    summary.trail.push_back({{x * static_cast<double>(i) / 20, 0, 0}, {0, 0, 0}});
  return column;
}

/// Table III with one solver more, whose simulations all come to their end; length 2 m.
struct MadeUp {
  MadeUp() {
    plan.solvers.push_back({"lemke", "lemke", "lemke", by_paper, 600});
    columns.lengths = {2, 2, 2, 2};
    for (const PaperColumn& solver : plan.solvers) {
      columns.in_loop.emplace_back();
      for (const PaperScene& place : plan.scenes)
        columns.in_loop.back().push_back(made_up(solver, place.scene, 0, 20));
    }
  }
  LoopSummary& summary(std::size_t solver, std::size_t scene) {
    return columns.in_loop[solver][scene].summary;
  }
  PaperTable table() const { return set_together(plan, columns); }
  std::string text() const { return render(page_of(table()), TableFormat::text); }

  PaperPlan plan = paper_plan(3, false);
  PaperColumns columns;
};

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Of a line of CSV, commas in quotes aside.
Index fields(const std::string& line) {
  Index count = 1;
  bool quoted = false;
  for (const char c : line) {
    quoted ^= c == '"';
    count += c == ',' && !quoted;
  }
  return count;
}

TEST(ScenePlans, HaveThePublishedColumnsAndRows) {
  const PaperPlan plan = paper_plan(3, false);
  ASSERT_EQ(plan.scenes.size(), published().table(3).columns.size());
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    EXPECT_EQ(plan.scenes[i].name, published().table(3).columns[i]);
    EXPECT_EQ(make_scene(plan.scenes[i].scene).setup.duration,
              published().table(3).value("duration", plan.scenes[i].name));
  }
  for (const std::string& key : plan.rows) {
    EXPECT_NO_THROW(paper_quantity(key));
    EXPECT_TRUE(published().table(3).value(key, "ring")) << key;
  }
  for (const std::string& key : plan.own_rows) EXPECT_NO_THROW(paper_quantity(key));
  for (const PaperColumn& solver : plan.solvers) EXPECT_FALSE(solver.limit) << solver.name;
}

TEST(ScenePlans, WithAllSolversHoldEveryRowOfTheRegistryOnce) {
  const PaperPlan plan = paper_plan(3, true, 60);
  for (const Row& row : registry())
    EXPECT_EQ(std::count_if(plan.solvers.begin(), plan.solvers.end(),
                            [&](const PaperColumn& each) { return each.solver == row.info.name; }),
              1)
        << row.info.name;
  ASSERT_GT(plan.solvers.size(), 2u);
  for (std::size_t i = 2; i < plan.solvers.size(); ++i) {
    const PaperColumn& column = plan.solvers[i];
    EXPECT_EQ(column.limit, 60);
    if (column.solver == "lemke") {
      EXPECT_EQ(column.acceptance, by_paper);
    }
    if (column.solver == "lexicographic-revised") {
      EXPECT_EQ(column.acceptance, Acceptance{});
    }
  }
}

TEST(SceneTables, ARowHasALinePerSolverWithStarsWhereTheyAreFar) {
  MadeUp made;
  made.summary(0, 2).lcp_ms = 35.0 * 1.9;  // published 35.0
  made.summary(1, 2).lcp_ms = 35.0 * 2.1;
  const std::vector<PaperLine> found = lines_of(made.table(), paper_quantity("lcp_time_ms"));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].label, "published");
  EXPECT_EQ(found[0].cells[2].value, 35.0);
  EXPECT_EQ(found[1].label, "proposed");
  EXPECT_FALSE(found[1].cells[2].far);
  EXPECT_EQ(found[2].label, "best-first");
  EXPECT_TRUE(found[2].cells[2].far);
}

TEST(SceneTables, ThePictureHasAPanelPerRowAndALineOfItPerScene) {
  const DotPage page = picture_of(MadeUp().table());
  ASSERT_EQ(page.legend.size(), 3u);
  EXPECT_EQ(page.legend[0].name, "published");
  EXPECT_EQ(page.legend[1].name, "proposed");
  EXPECT_EQ(page.legend[2].name, "best-first");
  EXPECT_EQ(page.legend[2].look.colour, look_of_solver("best-first").colour);
  ASSERT_EQ(page.panels.size(), paper_plan(3, false).rows.size());
  for (const DotPanel& panel : page.panels) EXPECT_EQ(panel.rows, published().table(3).columns);
}

TEST(SceneTables, RowsOfOursHaveNoPublishedLine) {
  const PaperTable table = MadeUp().table();
  const std::vector<PaperLine> found = lines_of(table, paper_quantity("nodes"));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].label, "proposed");
  EXPECT_TRUE(lines_of(table, paper_quantity("gap_end")).empty()) << "no loops";
}

TEST(SceneTables, TheRatioOfTimesIsThatOfTotals) {
  EXPECT_NEAR(printed_time_ratio(published().table(3)).value(), 120 * 9357 / (187 * 935.0), 1e-12);
  MadeUp made;
  EXPECT_FALSE(time_ratio(made.summary(1, 0), made.summary(1, 1))) << "no time at all";
  LoopSummary& fine = made.summary(0, 0);
  LoopSummary& coarse = made.summary(0, 1);
  fine.total_frames = 1000;
  fine.simulation_ms = 3;
  coarse.total_frames = 100;
  coarse.simulation_ms = 5;
  EXPECT_DOUBLE_EQ(time_ratio(fine, coarse).value(), 6);
  EXPECT_EQ(made.table().hoists.at(0).time_ratio, 6);
  coarse.broken = "flew apart";
  EXPECT_FALSE(time_ratio(fine, coarse)) << "not over the same motion";
}

TEST(SceneTables, TheHoistsEndsAreCloseOrNot) {
  MadeUp made;
  const auto off_by = [&](double x) {
    for (std::size_t solver : {0, 1})
      made.columns.in_loop[solver][1] = made_up(made.plan.solvers[0], "hoist:dt=0.01", x, 20);
    return end_distance(made.summary(0, 0), made.summary(0, 1), 2);
  };
  EXPECT_NEAR(off_by(0.19).value(), 0.0475, 1e-12) << "one of two links, over 2 m";
  EXPECT_NE(made.text().find("4.75 holds"), std::string::npos) << made.text();
  EXPECT_EQ(made.text().find("FAILED"), std::string::npos);
  EXPECT_NEAR(off_by(0.21).value(), 0.0525, 1e-12);
  EXPECT_NE(made.text().find("5.25 FAILED"), std::string::npos);
  EXPECT_EQ(made.text().find("holds"), std::string::npos);
  made.columns.in_loop[0][1] = made_up(made.plan.solvers[0], "hoist:dt=0.01", 0, 7);
  EXPECT_FALSE(end_distance(made.summary(0, 0), made.summary(0, 1), 2));
  EXPECT_NE(made.text().find("FAILED (one of the two has no end)"), std::string::npos);
}

TEST(SceneTables, AMotionPartsFromTheReference) {
  const PaperColumn solver = paper_plan(3, false).solvers[reference_solver];
  const LoopSummary reference = made_up(solver, "ring", 0, 20).summary;
  const Motion whole = motion_of(made_up(solver, "ring", 0.4, 20).summary, reference, 2);
  EXPECT_DOUBLE_EQ(whole.survived, 0.02);
  EXPECT_DOUBLE_EQ(whole.distance.value(), 0.1);
  EXPECT_DOUBLE_EQ(whole.parted.value(), 0.011) << "0.05 is reached, not exceeded, at half";
  const Motion broken = motion_of(made_up(solver, "ring", 0.4, 7).summary, reference, 2);
  EXPECT_DOUBLE_EQ(broken.survived, 0.007);
  EXPECT_DOUBLE_EQ(broken.distance.value(), 0.035) << "at the last twentieth that both reached";
  EXPECT_FALSE(broken.parted);
}

TEST(SceneTables, AreTheSameInEveryFormat) {
  MadeUp made;
  made.summary(0, 3).failure = 7;
  made.summary(2, 2).unsupported = 20;
  made.columns.in_loop[2][3] = made_up(made.plan.solvers[2], "net", 0.4, 7);
  const std::string text = made.text();
  EXPECT_NE(text.find("unsupported"), std::string::npos) << text;
  EXPECT_NE(text.find("published         4.5          6.4"), std::string::npos) << text;
  const PaperPage page = page_of(made.table());
  const nlohmann::json json = nlohmann::json::parse(page.json);
  ASSERT_EQ(json.at("rows").size(), 12u);
  const nlohmann::json& net = json.at("rows").at(3);
  EXPECT_EQ(net.at("column"), "net");
  EXPECT_EQ(net.at("mode"), "in-loop");
  EXPECT_EQ(net.at("failure"), 7);
  EXPECT_EQ(net.at("published").at("total_frames"), 1818);
  EXPECT_EQ(json.at("rows").at(11).at("survived"), 0.007);
  EXPECT_EQ(json.at("ratio").at("published"), 4.5);
  EXPECT_EQ(json.at("distance").at("measured").at(1).at("holds"), true);
  std::istringstream csv(page.csv);
  std::string line;
  while (std::getline(csv, line)) EXPECT_EQ(fields(line), 12) << line;
  EXPECT_NE(page.csv.find("3,column,in-loop,net,paper,0.001,net,\"best-first:epsilon=0.001"),
            std::string::npos);
  const std::string latex = render(page, TableFormat::latex);
  EXPECT_NE(latex.find("hoist:10ms"), std::string::npos);
  EXPECT_GT(lines(latex), 50u);
  const std::string table = latex.substr(latex.find("\\begin{tabular}"));
  std::istringstream cells(table.substr(0, table.find("\\end")));
  std::getline(cells, line);
  while (std::getline(cells, line)) EXPECT_EQ(std::count(line.begin(), line.end(), '&'), 5) << line;
}

/// Two scenes that are done in no time, by the two solvers and one more.
PaperPlan small_plan() {
  PaperPlan plan = paper_plan(3, false);
  plan.scenes = {{"hoist", "hoist:links=8,toss=0"}, {"hoist:10ms", "hoist:links=8,dt=0.01"}};
  plan.solvers.push_back({"lemke", "lemke", "lemke", by_paper, 600});
  plan.duration = 0.02;
  return plan;
}

class ScenesInTheLoop : public ReproductionTest {
 protected:
  ScenesInTheLoop() : ReproductionTest(small_plan(), "table3") {}
};

TEST_F(ScenesInTheLoop, AreSimulatedByEverySolver) {
  const PaperTable table = run().value();
  ASSERT_EQ(table.layers.size(), 3u);
  for (const PaperLayer& layer : table.layers) {
    EXPECT_EQ(layer.rows.at(0).at("survived"), 0.02);
    EXPECT_EQ(layer.rows.at(0).at("column"), "hoist");
    EXPECT_EQ(layer.rows.at(1).at("column"), "hoist:10ms");
    EXPECT_LE(layer.rows.at(1).at("total_frames"), 2);
  }
  EXPECT_EQ(table.layers[0].rows[0].at("criterion"), "paper");
  EXPECT_EQ(table.layers[1].rows[0].at("criterion"), "residual");
  EXPECT_EQ(table.layers[1].rows[0].at("tolerance"), 1e-6);
  EXPECT_EQ(table.layers[2].section, rest_section);
  const PaperPage page = page_of(table);
  for (const TableFormat format :
       {TableFormat::text, TableFormat::csv, TableFormat::json, TableFormat::latex})
    EXPECT_NE(render(page, format).find("lemke"), std::string::npos);
}

TEST_F(ScenesInTheLoop, ComputeOnlyWhatIsMissing) {
  ASSERT_EQ(missing().size(), 6u);
  EXPECT_EQ(missing()[2], "simulation of hoist:links=8,toss=0 with best-first");
  EXPECT_FALSE(fs::exists(path()));
  run();
  EXPECT_TRUE(missing().empty());
  const auto before = written();
  ASSERT_EQ(before.size(), 6u);
  run();
  EXPECT_EQ(written(), before);
  fs::remove(before.begin()->first);
  EXPECT_EQ(missing().size(), 1u);
  run();
  EXPECT_NE(written().begin()->second, before.begin()->second);
  EXPECT_EQ(written().rbegin()->second, before.rbegin()->second);
}

TEST_F(ScenesInTheLoop, InterruptedHandBackNothing) {
  interrupted_ = true;
  EXPECT_FALSE(run().has_value());
  interrupted_ = false;
  EXPECT_TRUE(run().has_value());
}

TEST_F(ScenesInTheLoop, TheLimitStopsTheRestAndAHigherOneGoesOn) {
  PaperPlan plan = small_plan();
  std::optional<double>& limit = plan.solvers.back().limit;
  limit = 1e-9;
  const PaperTable table = run(plan).value();
  const Cell& stopped = table.layers.at(2).rows.at(0);
  EXPECT_EQ(stopped.at("broken"), "stopped after 1e-09 s of computing at t = 0 s");
  EXPECT_EQ(stopped.at("stopped"), true);
  EXPECT_EQ(table.layers.at(0).rows.at(0).at("broken"), "");
  EXPECT_NE(
      render(page_of(table), TableFormat::text).find("lemke in hoist ended early: stopped after"),
      std::string::npos);
  EXPECT_TRUE(missing(plan).empty());
  limit = 1e-10;
  EXPECT_TRUE(missing(plan).empty()) << "it was given more than is asked for";
  limit = 60;
  EXPECT_EQ(missing(plan).size(), 2u);
  EXPECT_EQ(run(plan).value().layers.at(2).rows.at(0).at("broken"), "");
  limit = 1e-9;
  EXPECT_TRUE(missing(plan).empty()) << "what came to its end answers every limit";
}

}  // namespace
}  // namespace lcp
