#include "harness/studies/sheet/chart.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>

#include "harness/studies/sheet/sheet_pictures.h"
#include "problems/io/errors.h"
#include "tests/harness/made_up_records.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

std::vector<Record> three_solved_one_failed() {
  std::vector<Record> records = {solved("c/0", "a", 1e-14), solved("c/1", "a", 0),
                                 solved("c/2", "a", 1e-10),
                                 made_up("c/3", "a", Verdict::ray, Claim::ray, 1)};
  records[0].times_ns = {4'000'000};
  records[1].times_ns = {2'000'000};
  return records;
}

/// The marks of the series of one kind in a panel, for which `fits` holds.
std::vector<Mark> marks_of(const Panel& panel, Series::Kind kind,
                           const std::function<bool(const Series&)>& fits) {
  std::vector<Mark> marks;
  for (const Series& series : panel.series)
    if (series.kind == kind && fits(series))
      marks.insert(marks.end(), series.marks.begin(), series.marks.end());
  return marks;
}

/// Points with quartiles, which are those in colour.
std::vector<Mark> points_of(const Panel& panel) {
  return marks_of(panel, Series::Kind::points, [](const Series& series) {
    return !series.marks.empty() && !std::isnan(series.marks.front().x_low);
  });
}

std::vector<Mark> stairs_of(const Panel& panel) {
  return marks_of(panel, Series::Kind::line, [](const Series& series) { return series.size == 5; });
}

/// What the list beside a chart says of each line's mass: failed of counted.
std::vector<std::pair<int, int>> masses_of(const Panel& list) {
  std::vector<std::pair<int, int>> masses;
  for (const Mark& mark : marks_of(list, Series::Kind::text,
                                   [](const Series& series) { return !series.marks.empty(); }))
    if (int failed = 0, counted = 0;
        std::sscanf(mark.text.c_str(), "%d of %d", &failed, &counted) == 2)
      masses.emplace_back(failed, counted);
  return masses;
}

TEST(Chart, PointsAreMediansAndQuartilesOverTheSolved) {
  const Figure figure = chart_figure(make_sheet(three_solved_one_failed()));
  ASSERT_EQ(figure.panels.size(), 2u) << "the plane and its list";
  const std::vector<Mark> points = points_of(figure.panels[0]);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(masses_of(figure.panels[1]), (std::vector<std::pair<int, int>>{{1, 4}}));
  EXPECT_FALSE(points[0].filled) << "it failed somewhere";
  EXPECT_DOUBLE_EQ(points[0].x_low, 1);
  EXPECT_DOUBLE_EQ(points[0].x, 2);
  EXPECT_DOUBLE_EQ(points[0].x_high, 4);
  EXPECT_DOUBLE_EQ(points[0].y_low, residual_floor) << "where 0 stands";
  EXPECT_DOUBLE_EQ(points[0].y, 1e-14);
  EXPECT_EQ(figure.panels[0].y.ticks.back().label, "exact");
}

TEST(Chart, ASolverThatSolvedNothingHasNoPointButIsCounted) {
  const Figure figure =
      chart_figure(make_sheet({made_up("c/0", "a", Verdict::ray, Claim::ray, 1)}));
  ASSERT_EQ(figure.panels.size(), 2u);
  EXPECT_TRUE(points_of(figure.panels[0]).empty());
  EXPECT_EQ(masses_of(figure.panels[1]), (std::vector<std::pair<int, int>>{{1, 1}}));
  EXPECT_TRUE(stairs_of(figure.panels[0]).empty());
}

TEST(Chart, TheStairsJoinTheFrontOfThoseThatSolveTheMost) {
  std::vector<Record> records = {solved("c/0", "slow", 1e-15), solved("c/0", "quick", 1e-8),
                                 solved("c/0", "worse", 1e-7)};
  records[0].times_ns = {8'000'000};
  const Panel panel = chart_figure(make_sheet(records)).panels.front();
  const std::vector<Mark> stairs = stairs_of(panel);
  ASSERT_EQ(stairs.size(), 5u);
  EXPECT_DOUBLE_EQ(stairs[1].x, 1);
  EXPECT_DOUBLE_EQ(stairs[1].y, 1e-8);
  EXPECT_DOUBLE_EQ(stairs[2].x, 8);
  EXPECT_DOUBLE_EQ(stairs[2].y, 1e-8);
  EXPECT_DOUBLE_EQ(stairs[3].y, 1e-15);
  EXPECT_DOUBLE_EQ(stairs[4].x, panel.x.high);
}

TEST(Chart, AmongManySettingsSomeAreListedAndTheOthersSummedUp) {
  std::vector<Record> records;
  for (int i = 0; i < 30; ++i) {
    const std::string solver = fmt::format("a:x={}", i);
    records.push_back(i % 2 == 0 ? solved("c/0", solver, 1e-10)
                                 : made_up("c/0", solver, Verdict::ray, Claim::ray, 1));
  }
  const Figure figure = chart_figure(make_sheet(records));
  const auto masses = masses_of(figure.panels[1]);
  EXPECT_LE(masses.size(), 15u);
  int failed = 0, counted = 0;
  for (const auto& [of_line, all] : masses) {
    failed += of_line;
    counted += all;
  }
  EXPECT_EQ(counted, 30);
  EXPECT_EQ(failed, 15);
}

TEST(Chart, GivesEverySolverItsOneLook) {
  const Figure figure = chart_figure(make_sheet(three_solved_one_failed()));
  const Look look = points_of(figure.panels[0]).front().look, own = look_of_solver("a");
  EXPECT_EQ(look.colour, own.colour);
  EXPECT_EQ(look.marker, own.marker);
}

TEST(Chart, IsDrawnWithScriptAndDataBesideIt) {
  const TemporaryDirectory directory;
  std::vector<Record> records = three_solved_one_failed();
  records.push_back(made_up("c/0", "b_x", Verdict::ray, Claim::ray, 1));
  draw_figure(directory.file("chart.svg"), chart_figure(make_sheet(records)));
  const std::string svg = read_text(directory.file("chart.svg"));
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_NE(svg.find("b_x"), std::string::npos);
  EXPECT_NE(svg.find("1 of 4"), std::string::npos);
  EXPECT_NE(svg.find("1 of 1"), std::string::npos);
  EXPECT_NE(read_text(directory.file("chart.dat")).find("1e-14"), std::string::npos);
  EXPECT_NE(read_text(directory.file("chart.gp")).find("DATA = 'chart.dat'"), std::string::npos);
}

TEST(Chart, ACorpusNameCannotRunCommands) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("made");
  const Sheet sheet = make_sheet({solved("`touch " + file + "`", "a", 0),
                                  solved("'\n! touch " + file + "\n", "a`touch " + file + "`", 0)});
  draw_figure(directory.file("chart.svg"), chart_figure(sheet));
  draw_figure(directory.file("profile.svg"), profile_figure(sheet));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Chart, RefusesToDrawNothing) {
  EXPECT_THROW(chart_figure(make_sheet({ended("c/0", "a", Verdict::not_run)})),
               std::invalid_argument);
}

TEST(Chart, SaysHowToGoOnWhereGnuplotIsMissing) {
  const TemporaryDirectory directory;
  const std::string path = std::getenv("PATH");
  setenv("PATH", directory.path().c_str(), 1);
  try {
    draw_figure(directory.file("chart.svg"), chart_figure(make_sheet({solved("c/0", "a", 0)})));
    ADD_FAILURE() << "drawn without gnuplot";
  } catch (const UnwritableOutput& error) {
    EXPECT_NE(std::string(error.what()).find("gnuplot-nox"), std::string::npos) << error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(std::filesystem::exists(directory.file("chart.gp")));
  EXPECT_FALSE(std::filesystem::exists(directory.file("chart.svg")));
}

}  // namespace
}  // namespace lcp
