#include "harness/studies/paper/scene_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "harness/studies/paper/table_pictures.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"
#include "tests/harness/temporary_directory.h"

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

/// A table whose simulations all come to their end; length 2 m.
SceneTable made_up_table() {
  SceneTable table;
  table.plan = scene_plan(false);
  table.plan.rest = {{"lemke", "lemke", "lemke", by_paper}};
  table.published = published().table(3);
  table.source = "a source";
  table.lengths = {2, 2, 2, 2};
  for (const PaperColumn& solver : table.plan.solvers) {
    table.solvers.emplace_back();
    for (const ScenePlace& place : table.plan.scenes)
      table.solvers.back().push_back(made_up(solver, place.scene, 0, 20));
  }
  table.rest.emplace_back();
  for (const ScenePlace& place : table.plan.scenes)
    table.rest.back().push_back(made_up(table.plan.rest.front(), place.scene, 0, 20));
  return table;
}

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
  const ScenePlan plan = scene_plan(false);
  ASSERT_EQ(plan.scenes.size(), published().table(3).columns.size());
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    EXPECT_EQ(plan.scenes[i].column, published().table(3).columns[i]);
    EXPECT_EQ(make_scene(plan.scenes[i].scene).setup.duration,
              published().table(3).value("duration", plan.scenes[i].column));
  }
  for (const std::string& key : plan.rows) {
    EXPECT_NO_THROW(paper_quantity(key));
    EXPECT_TRUE(published().table(3).value(key, "ring")) << key;
  }
  for (const std::string& key : plan.own_rows) EXPECT_NO_THROW(paper_quantity(key));
  EXPECT_TRUE(plan.rest.empty());
}

TEST(ScenePlans, WithAllSolversHoldEveryRowOfTheRegistryOnce) {
  const ScenePlan plan = scene_plan(true);
  for (const Row& row : registry()) {
    const auto is_it = [&](const PaperColumn& column) { return column.solver == row.info.name; };
    EXPECT_EQ(std::count_if(plan.solvers.begin(), plan.solvers.end(), is_it) +
                  std::count_if(plan.rest.begin(), plan.rest.end(), is_it),
              1)
        << row.info.name;
  }
  for (const PaperColumn& column : plan.rest) {
    if (column.solver == "lemke") {
      EXPECT_EQ(column.acceptance, by_paper);
    }
    if (column.solver == "lexicographic-revised") {
      EXPECT_EQ(column.acceptance, Acceptance{});
    }
  }
}

TEST(SceneTables, ARowHasALinePerSolverWithStarsWhereTheyAreFar) {
  SceneTable table = made_up_table();
  table.solvers[0][2].summary.lcp_ms = 35.0 * 1.9;  // published 35.0
  table.solvers[1][2].summary.lcp_ms = 35.0 * 2.1;
  const std::vector<PaperLine> found = lines_of(table, paper_quantity("lcp_time_ms"));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].label, "published");
  EXPECT_EQ(found[0].cells[2].value, 35.0);
  EXPECT_EQ(found[1].label, "proposed");
  EXPECT_FALSE(found[1].cells[2].far);
  EXPECT_EQ(found[2].label, "best-first");
  EXPECT_TRUE(found[2].cells[2].far);
}

TEST(SceneTables, ThePictureHasAPanelPerRowAndALineOfItPerScene) {
  const DotPage page = picture_of(made_up_table());
  EXPECT_EQ(page.legend, (std::vector<std::string>{"published", "proposed", "best-first"}));
  ASSERT_EQ(page.panels.size(), scene_plan(false).rows.size());
  for (const DotPanel& panel : page.panels) EXPECT_EQ(panel.rows, published().table(3).columns);
}

TEST(SceneTables, RowsOfOursHaveNoPublishedLine) {
  const std::vector<PaperLine> found = lines_of(made_up_table(), paper_quantity("nodes"));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].label, "proposed");
  EXPECT_TRUE(lines_of(made_up_table(), paper_quantity("gap_end")).empty()) << "no loops";
}

TEST(SceneTables, TheRatioOfTimesIsThatOfTotals) {
  SceneTable table = made_up_table();
  EXPECT_NEAR(printed_time_ratio(table.published).value(), 120 * 9357 / (187 * 935.0), 1e-12);
  LoopSummary& fine = table.solvers[0][0].summary;
  LoopSummary& coarse = table.solvers[0][1].summary;
  fine.total_frames = 1000;
  fine.simulation_ms = 3;
  coarse.total_frames = 100;
  coarse.simulation_ms = 5;
  EXPECT_DOUBLE_EQ(time_ratio(table, table.solvers[0]).value(), 6);
  EXPECT_FALSE(time_ratio(table, table.solvers[1])) << "no time at all";
  coarse.broken = "flew apart";
  EXPECT_FALSE(time_ratio(table, table.solvers[0])) << "not over the same motion";
}

TEST(SceneTables, TheHoistsEndsAreCloseOrNot) {
  SceneTable table = made_up_table();
  const auto off_by = [&](double x) {
    for (auto& columns : table.solvers)
      columns[1] = made_up(table.plan.solvers[0], "hoist:dt=0.01", x, 20);
    return end_distance(table, table.solvers[0]);
  };
  EXPECT_NEAR(off_by(0.19).value(), 0.0475, 1e-12) << "one of two links, over 2 m";
  EXPECT_NE(render(table, TableFormat::text).find("4.75  holds"), std::string::npos);
  EXPECT_EQ(render(table, TableFormat::text).find("FAILED"), std::string::npos);
  EXPECT_NEAR(off_by(0.21).value(), 0.0525, 1e-12);
  EXPECT_NE(render(table, TableFormat::text).find("5.25  FAILED"), std::string::npos);
  EXPECT_EQ(render(table, TableFormat::text).find("holds"), std::string::npos);
  table.solvers[0][1] = made_up(table.plan.solvers[0], "hoist:dt=0.01", 0, 7);
  EXPECT_FALSE(end_distance(table, table.solvers[0]));
  EXPECT_NE(render(table, TableFormat::text).find("FAILED (one of the two has no end)"),
            std::string::npos);
}

TEST(SceneTables, AMotionPartsFromTheReference) {
  const PaperColumn solver = own_column();
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
  SceneTable table = made_up_table();
  table.solvers[0][3].summary.failure = 7;
  table.rest[0][2].summary.unsupported = 20;
  table.rest[0][3] = made_up(table.plan.rest[0], "net", 0.4, 7);
  const std::string text = render(table, TableFormat::text);
  EXPECT_NE(text.find("unsupported"), std::string::npos) << text;
  EXPECT_NE(text.find("published                4.5, by its cells 6.4"), std::string::npos) << text;
  const nlohmann::json json = nlohmann::json::parse(render(table, TableFormat::json));
  ASSERT_EQ(json.at("rows").size(), 12u);
  const nlohmann::json& net = json.at("rows").at(3);
  EXPECT_EQ(net.at("column"), "net");
  EXPECT_EQ(net.at("mode"), "in-loop");
  EXPECT_EQ(net.at("failure"), 7);
  EXPECT_EQ(net.at("published").at("total_frames"), 1818);
  EXPECT_EQ(json.at("rows").at(11).at("survived"), 0.007);
  EXPECT_EQ(json.at("ratio").at("published"), 4.5);
  EXPECT_EQ(json.at("distance").at("measured").at(1).at("holds"), true);
  std::istringstream csv(render(table, TableFormat::csv));
  std::string line;
  while (std::getline(csv, line)) EXPECT_EQ(fields(line), 12) << line;
  EXPECT_NE(render(table, TableFormat::csv)
                .find("3,column,in-loop,net,paper,0.001,net,\"best-first:epsilon=0.001"),
            std::string::npos);
  const std::string latex = render(table, TableFormat::latex);
  EXPECT_NE(latex.find("hoist:10ms"), std::string::npos);
  EXPECT_GT(lines(latex), 50u);
}

/// Two scenes that are done in no time, by the two solvers and one more.
ScenePlan small_plan() {
  ScenePlan plan = scene_plan(false);
  plan.scenes = {{"hoist", "hoist:links=8,toss=0"}, {"hoist:10ms", "hoist:links=8,dt=0.01"}};
  plan.rest = {{"lemke", "lemke", "lemke", by_paper}};
  plan.duration = 0.02;
  return plan;
}

class ScenesInTheLoop : public testing::Test {
 protected:
  std::optional<SceneTable> run(const ScenePlan& plan = small_plan()) {
    return simulate_scenes(plan, how(), interrupted_);
  }
  std::vector<std::string> missing(const ScenePlan& plan = small_plan()) {
    return missing_work(plan, how());
  }
  Reproduction how() {
    Reproduction reproduction;
    reproduction.directory = path();
    return reproduction;
  }
  fs::path path() const { return directory_.file("table3"); }
  /// When each simulation's file was written.
  std::map<fs::path, fs::file_time_type> written() const {
    std::map<fs::path, fs::file_time_type> times;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path() / "loop"))
      if (entry.path().extension() == ".json") times[entry.path()] = entry.last_write_time();
    return times;
  }
  std::atomic<bool> interrupted_ = false;

 private:
  TemporaryDirectory directory_;
};

TEST_F(ScenesInTheLoop, AreSimulatedByEverySolver) {
  const SceneTable table = run().value();
  ASSERT_EQ(table.solvers.size(), 2u);
  ASSERT_EQ(table.rest.size(), 1u);
  for (const auto& columns : table.solvers) {
    EXPECT_EQ(columns.at(0).summary.steps, 20);
    EXPECT_EQ(columns.at(1).summary.steps, 2);
  }
  EXPECT_EQ(table.solvers[0][0].question.acceptance, by_paper);
  EXPECT_EQ(table.solvers[1][0].question.acceptance, Acceptance{});
  EXPECT_NEAR(table.lengths[0], 0.8, 1e-12);
  for (const TableFormat format :
       {TableFormat::text, TableFormat::csv, TableFormat::json, TableFormat::latex})
    EXPECT_NE(render(table, format).find("lemke"), std::string::npos);
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
  ScenePlan plan = small_plan();
  plan.limit = 1e-9;
  const SceneTable table = run(plan).value();
  EXPECT_EQ(table.rest[0][0].summary.broken, "stopped after 1e-09 s of computing at t = 0 s");
  EXPECT_TRUE(table.rest[0][0].summary.stopped);
  EXPECT_TRUE(table.solvers[0][0].summary.broken.empty());
  EXPECT_NE(render(table, TableFormat::text).find("lemke in hoist ended early: stopped after"),
            std::string::npos);
  EXPECT_TRUE(missing(plan).empty());
  plan.limit = 1e-10;
  EXPECT_TRUE(missing(plan).empty()) << "it was given more than is asked for";
  plan.limit = 60;
  EXPECT_EQ(missing(plan).size(), 2u);
  EXPECT_TRUE(run(plan).value().rest[0][0].summary.broken.empty());
  plan.limit = 1e-9;
  EXPECT_TRUE(missing(plan).empty()) << "what came to its end answers every limit";
}

}  // namespace
}  // namespace lcp
