#include "harness/studies/paper/published.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>

#include "harness/studies/paper/choices.h"
#include "harness/studies/paper/paper_table.h"
#include "harness/studies/paper/plan.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

TEST(Published, HoldsTheCellsThatThePaperPrints) {
  const PublishedTable& first = published().table(1);
  EXPECT_EQ(first.value("success", "lemke"), 506);
  EXPECT_EQ(first.value("error", "lexicographic:delta=0"), 310);
  EXPECT_EQ(first.value("contacts", "lexicographic:delta=1e-6"), 12.1);
  EXPECT_EQ(first.value("active", "proposed"), 2.18);
  EXPECT_EQ(first.value("failure", "lexicographic:delta=1e-4"), 4);
  const PublishedTable& second = published().table(2);
  EXPECT_EQ(second.value("total_frames", "proposed"), 9670);
  EXPECT_EQ(second.value("lcp_time_ms", "lexicographic"), 0.375);
  EXPECT_EQ(second.value("total_pivots", "proposed"), 34335);
  EXPECT_EQ(published().table(3).value("contacts", "hoist"), 34.2);
}

TEST(Published, CountsAddUp) {
  for (const int number : {1, 2})
    for (const std::string& column : published().table(number).columns) {
      const PublishedTable& table = published().table(number);
      const auto value = [&](const char* row) { return table.value(row, column); };
      if (!value("success")) continue;
      EXPECT_EQ(*value("success") + *value("failure"), *value("total_frames")) << column;
      EXPECT_EQ(*value("no_solution") + *value("cycle") + *value("error"), *value("failure"))
          << column;
    }
}

TEST(Published, SaysNothingWhereThePaperDoesNot) {
  EXPECT_FALSE(published().table(1).value("contacts", "lexicographic:delta=1e-3"));
  EXPECT_FALSE(published().table(1).value("contacts", "no such column"));
  EXPECT_FALSE(published().table(1).value("no such row", "lemke"));
  EXPECT_THROW(published().table(4), std::invalid_argument);
}

TEST(Published, RefusesRowsThatDoNotHoldAValuePerColumn) {
  EXPECT_THROW(parse_published("{"), std::invalid_argument);
  EXPECT_THROW(parse_published(R"({"source": "x"})"), std::invalid_argument);
  EXPECT_THROW(parse_published(R"({"source": "x", "tables": [{"table": 1, "title": "t",
      "section": "s", "columns": ["a", "b"], "notes": [],
      "rows": [{"row": "r", "unit": "u", "values": [1]}]}]})"),
               std::invalid_argument);
}

TEST(Published, FarMeansMoreThanAFactorOfTwo) {
  EXPECT_FALSE(far_from(2, 1));
  EXPECT_FALSE(far_from(1, 2));
  EXPECT_TRUE(far_from(2.01, 1));
  EXPECT_TRUE(far_from(0.49, 1));
  EXPECT_FALSE(far_from(0, 0));
  EXPECT_TRUE(far_from(1, 0));
  EXPECT_TRUE(far_from(0, 1));
  EXPECT_TRUE(far_from(std::numeric_limits<double>::quiet_NaN(), 1));
}

TEST(Published, AnUpperBoundOfTheTextIsKeptByAllBelow) {
  const PublishedTable& table = published().table(1);
  EXPECT_TRUE(table.at_most("both_failures"));
  EXPECT_FALSE(table.at_most("failure"));
  EXPECT_FALSE(table.departs("both_failures", "lemke", 0));
  EXPECT_FALSE(table.departs("both_failures", "lemke", 3));
  EXPECT_TRUE(table.departs("both_failures", "lemke", 4));
  EXPECT_TRUE(table.departs("failure", "lemke", 0));
  EXPECT_FALSE(table.departs("failure", "no such column", 0));
}

TEST(PaperPlans, HaveThePublishedColumns) {
  for (const int number : {1, 2, 3}) {
    const PaperPlan plan = paper_plan(number, false);
    for (const std::string& column : published().table(number).columns)
      EXPECT_TRUE(std::any_of(plan.solvers.begin(), plan.solvers.end(),
                              [&](const PaperColumn& each) { return each.name == column; }) ||
                  std::any_of(plan.scenes.begin(), plan.scenes.end(),
                              [&](const PaperScene& each) { return each.name == column; }))
          << number << " " << column;
  }
  EXPECT_EQ(paper_plan(2, false).deltas.size(), 11u);
  EXPECT_THROW(paper_plan(4, false), std::invalid_argument);
}

TEST(PaperPlans, WithAllSolversHoldEveryRowOfTheRegistry) {
  const PaperPlan plan = paper_plan(1, true);
  for (const Row& row : registry())
    EXPECT_TRUE(std::any_of(plan.solvers.begin(), plan.solvers.end(),
                            [&](const PaperColumn& column) {
                              return column.solver.substr(0, column.solver.find(':')) ==
                                     row.info.name;
                            }))
        << row.info.name;
}

TEST(PaperTables, TheBestDeltaIsNotOneAtWhichTheRobotFell) {
  std::vector<LoopColumn> sweep(4);
  for (LoopColumn& column : sweep) column.summary.steps = 10;
  sweep[0].summary.success = 5;
  sweep[1].summary.success = 9;
  sweep[1].summary.tilt_max = 3;
  sweep[2].summary.success = 7;
  sweep[2].summary.pivots = 20;
  sweep[3].summary.success = 7;
  sweep[3].summary.pivots = 10;
  EXPECT_EQ(best_of(sweep), 3u);
}

TEST(Choices, AreSpelledRightAndDifferFromTheFirst) {
  std::set<std::string> knobs;  // planning the motion takes long
  for (const Choice& choice : choices()) {
    EXPECT_NO_THROW(make_solver(choice.solver)) << choice.solver;
    if (!choice.knobs.empty()) knobs.insert(choice.knobs);
  }
  for (const std::string& each : knobs) EXPECT_NO_THROW(make_scene("squat:" + each)) << each;
  EXPECT_EQ(choices().front().knobs, "");
  EXPECT_EQ(choices().front().solver, "best-first");
}

TEST(Choices, RenderALineForEach) {
  std::vector<ChoiceTable> tables = {{"squat", {}}};
  for (const Choice& choice : choices()) {
    LoopColumn column;
    column.question = {"squat", choice.solver, choice.acceptance, {}};
    column.summary.total_frames = 10;
    column.summary.nodes = 123;
    column.summary.failure = 7;
    tables.front().columns.push_back(column);
  }
  const auto lines = [](const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  };
  const PaperPage page = page_of(tables);
  EXPECT_EQ(lines(page.csv), choices().size() + 1);
  EXPECT_NE(render(page, TableFormat::text).find("12.3"), std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(page.json);
  EXPECT_EQ(json.at("rows").size(), choices().size());
  EXPECT_EQ(json.at("rows").at(0).at("summary").at("failure"), 7);
  const std::string latex = render(page, TableFormat::latex);
  EXPECT_EQ(lines(latex.substr(latex.find("% squat"))), choices().size() + 5)
      << "title, begin, heads, end, space";
}

}  // namespace
}  // namespace lcp
