#include "harness/present/dot_panels.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace lcp {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

const LegendEntry a{"a", look_at(0)}, b{"b", look_at(1)};

/// A page of one panel with one row and one series.
DotPage page_with(const std::vector<double>& values) {
  return {"t", {a}, {{"p", std::vector<std::string>(values.size(), "x"), {{0, values}}}}, ""};
}

TEST(DotPanels, HaveAMarkPerValueInTheLookOfItsEntry) {
  const Figure figure =
      figure_of({"t", {a, b}, {{"p", {"x", "y"}, {{0, {1, 2}}, {1, {0, none}}}}}, ""});
  const std::vector<Series>& series = figure.panels.at(0).series;
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].marks[1].x, 2);
  EXPECT_DOUBLE_EQ(series[0].marks[1].y, 0.915);
  EXPECT_EQ(series[0].marks[1].look.colour, a.look.colour);
  EXPECT_EQ(series[1].marks[0].x, 0);
  EXPECT_DOUBLE_EQ(series[1].marks[0].y, 0.085);
  EXPECT_EQ(series[1].marks[0].look.marker, b.look.marker);
  EXPECT_TRUE(std::isnan(series[1].marks[1].x)) << "is not drawn";
}

TEST(DotPanels, TakeALogarithmicAxisForPositiveValuesFarApart) {
  const auto is_logarithmic = [](const std::vector<double>& values) {
    const Axis axis = figure_of(page_with(values)).panels.at(0).x;
    for (const double value : values) EXPECT_TRUE(axis.low <= value && value < axis.high);
    return axis.scale == Axis::Scale::log;
  };
  EXPECT_TRUE(is_logarithmic({1, 31}));
  EXPECT_FALSE(is_logarithmic({1, 29}));
  EXPECT_FALSE(is_logarithmic({0, 31})) << "0 has no place on it";
}

TEST(DotPanels, NameTheRowsOnceWhereNeighboursShareThem) {
  const DotPanel panel{"p", {"a row"}, {{0, {1}}}};
  const std::vector<Panel> panels =
      figure_of({"t", {a}, {panel, panel, {"q", {"another"}, {{0, {1}}}}}, ""}).panels;
  EXPECT_EQ(panels.at(0).y.ticks.at(0).label, "a row");
  EXPECT_EQ(panels.at(1).y.ticks.at(0).label, "");
  EXPECT_EQ(panels.at(2).y.ticks.at(0).label, "another");
}

TEST(DotPanels, ThatDoNotFitBeginANewLineAndAreNamedThere) {
  const DotPanel panel{"p", {"a row"}, {{0, {1}}}};
  const Figure figure = figure_of({"t", {a}, std::vector<DotPanel>(9, panel), ""});
  std::size_t named = 0;
  for (const Panel& each : figure.panels) {
    EXPECT_LE(each.area.left + each.area.width, figure.width);
    EXPECT_LE(each.area.top + each.area.height, figure.height);
    named += each.y.ticks.at(0).label == "a row";
  }
  EXPECT_EQ(named, 2u);
  EXPECT_GT(figure.panels.back().area.top, figure.panels.front().area.top);
}

TEST(DotPanels, WithoutAValueHaveAnAxisAllTheSame) {
  const Panel panel = figure_of(page_with({none})).panels.at(0);
  EXPECT_EQ(panel.x.low, 0);
  EXPECT_EQ(panel.x.high, 1);
}

TEST(DotPanels, RefuseSeriesOfAnotherLength) {
  EXPECT_THROW(figure_of({"t", {a}, {{"p", {"x", "y"}, {{0, {1}}}}}, ""}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
