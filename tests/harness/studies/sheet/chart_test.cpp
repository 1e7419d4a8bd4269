#include "harness/studies/sheet/chart.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "harness/studies/sheet/chart_panels.h"
#include "harness/studies/sheet/sheet_pictures.h"
#include "harness/present/step_curves.h"
#include "harness/present/tag_placement.h"
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

TEST(Chart, PointsAreMediansAndQuartilesOverTheSolved) {
  const std::vector<ChartPanel> panels = chart_panels(make_sheet(three_solved_one_failed()));
  ASSERT_EQ(panels.size(), 1u);
  ASSERT_EQ(panels[0].points.size(), 1u);
  const ChartPoint& point = panels[0].points[0];
  EXPECT_EQ(point.mass.counted(), 4);
  EXPECT_EQ(point.mass.failed, 1);
  EXPECT_DOUBLE_EQ(point.cost.value().low, 1);
  EXPECT_DOUBLE_EQ(point.cost.value().median, 2);
  EXPECT_DOUBLE_EQ(point.cost.value().high, 4);
  EXPECT_DOUBLE_EQ(point.residual.value().low, 0);
  EXPECT_DOUBLE_EQ(point.residual.value().median, 1e-14);
}

TEST(Chart, ASolverThatSolvedNothingHasNoPointButIsCounted) {
  const std::vector<ChartPanel> panels =
      chart_panels(make_sheet({made_up("c/0", "a", Verdict::ray, Claim::ray, 1)}));
  ASSERT_EQ(panels.size(), 1u);
  EXPECT_FALSE(panels[0].points[0].cost || panels[0].points[0].residual);
  EXPECT_EQ(panels[0].points[0].mass.failed, 1);
  EXPECT_TRUE(panels[0].stairs.empty());
}

TEST(Chart, TheStairsJoinTheFrontOfThoseThatSolveTheMost) {
  std::vector<Record> records = {solved("c/0", "slow", 1e-15), solved("c/0", "quick", 1e-8),
                                 solved("c/0", "worse", 1e-7)};
  records[0].times_ns = {8'000'000};
  const std::vector<ChartPanel> panels = chart_panels(make_sheet(records));
  const std::vector<Pixels>& stairs = panels[0].stairs;
  ASSERT_EQ(stairs.size(), 5u);
  EXPECT_DOUBLE_EQ(stairs[1].x, 1);
  EXPECT_DOUBLE_EQ(stairs[1].y, 1e-8);
  EXPECT_DOUBLE_EQ(stairs[2].x, 8);
  EXPECT_DOUBLE_EQ(stairs[2].y, 1e-8);
  EXPECT_DOUBLE_EQ(stairs[3].y, 1e-15);
  EXPECT_DOUBLE_EQ(stairs[4].x, panels[0].cost.high);
}

TEST(Chart, AmongManySettingsSomeAreListedAndTheOthersSummedUp) {
  std::vector<Record> records;
  for (int i = 0; i < 30; ++i) {
    const std::string solver = fmt::format("a:x={}", i);
    records.push_back(i % 2 == 0 ? solved("c/0", solver, 1e-10)
                                 : made_up("c/0", solver, Verdict::ray, Claim::ray, 1));
  }
  const ChartPanel panel = chart_panels(make_sheet(records)).front();
  Mass listed;
  for (const ChartPoint& point : panel.points)
    if (point.listed) {
      listed.instances += point.mass.instances;
      listed.failed += point.mass.failed;
    }
  EXPECT_LE(panel.lines(), 15u);
  EXPECT_EQ(listed.instances + panel.others().instances, 30);
  EXPECT_EQ(listed.failed + panel.others().failed, 15);
}

TEST(Chart, IsDrawnWithScriptAndDataBesideIt) {
  const TemporaryDirectory directory;
  std::vector<Record> records = three_solved_one_failed();
  records.push_back(made_up("c/0", "b_x", Verdict::ray, Claim::ray, 1));
  draw_chart(make_sheet(records), directory.file("chart.svg"));
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
  draw_chart(sheet, directory.file("chart.svg"));
  draw_step_curves(directory.file("profile.svg"), profile_page(sheet));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Chart, RefusesToDrawNothing) {
  const TemporaryDirectory directory;
  EXPECT_THROW(
      draw_chart(make_sheet({ended("c/0", "a", Verdict::not_run)}), directory.file("chart.svg")),
      std::invalid_argument);
}

TEST(Chart, SaysHowToGoOnWhereGnuplotIsMissing) {
  const TemporaryDirectory directory;
  const std::string path = std::getenv("PATH");
  setenv("PATH", directory.path().c_str(), 1);
  try {
    draw_chart(make_sheet({solved("c/0", "a", 0)}), directory.file("chart.svg"));
    ADD_FAILURE() << "drawn without gnuplot";
  } catch (const UnwritableOutput& error) {
    EXPECT_NE(std::string(error.what()).find("gnuplot-nox"), std::string::npos) << error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(std::filesystem::exists(directory.file("chart.gp")));
  EXPECT_FALSE(std::filesystem::exists(directory.file("chart.svg")));
}

bool apart(Pixels a, Pixels b, Pixels size) {
  return std::abs(a.x - b.x) >= size.x || std::abs(a.y - b.y) >= size.y;
}

TEST(TagPlacement, TagsOfEqualPointsStandApartAndInside) {
  const Pixels area = {300, 200}, tag = {17, 13};
  const std::vector<Pixels> tags =
      place_tags(std::vector<Pixels>(12, Pixels{295, 4}), {}, area, tag);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    EXPECT_GE(tags[i].x, tag.x / 2);
    EXPECT_LE(tags[i].x, area.x - tag.x / 2);
    EXPECT_GE(tags[i].y, tag.y / 2);
    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(apart(tags[i], tags[j], tag)) << i << ' ' << j;
  }
}

TEST(TagPlacement, ALonelyPointHasItsTagNearby) {
  const Pixels tag = place_tags({{100, 100}}, {}, {300, 200}, {17, 13}).front();
  EXPECT_NEAR(std::hypot(tag.x - 100, tag.y - 100), nearest_tag_distance(), 1e-9);
}

}  // namespace
}  // namespace lcp
