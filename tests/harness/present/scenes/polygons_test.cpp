#include "harness/present/scenes/polygons.h"

#include <gtest/gtest.h>

namespace lcp {
namespace {

const Polygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(Polygons, TheHullLeavesOutWhatLiesInsideAndOnItsSides) {
  const Polygon hull =
      convex_hull({{0.5, 0.5}, {1, 0}, {0, 0}, {0.5, 0}, {1, 1}, {0, 1}, {0, 0}, {0.2, 0.3}});
  EXPECT_EQ(hull.size(), 4u);
  EXPECT_DOUBLE_EQ(area(hull), 1);
}

TEST(Polygons, HaveAThickness) {
  EXPECT_NEAR(thickness({{0, 0}, {10, 0}, {10, 0.1}, {0, 0.1}, {5, 0.05}}), 0.1, 1e-4);
  EXPECT_EQ(thickness({{0, 0}, {1, 1}}), 0);
  EXPECT_EQ(thickness({{1, 1}}), 0);
}

TEST(Polygons, ShareWhatLiesInBoth) {
  EXPECT_NEAR(area(common_part(square, {{0.5, -1}, {2, -1}, {2, 0.25}, {0.5, 0.25}})), 0.125,
              1e-12);
  EXPECT_NEAR(area(common_part(square, {{-1, -1}, {2, -1}, {2, 2}, {-1, 2}})), 1, 1e-12);
  EXPECT_NEAR(area(common_part(square, {{2, 0}, {3, 0}, {3, 1}})), 0, 1e-12);
}

TEST(Polygons, LinesThatMeetBecomeOneStrokeOfTheirWidth) {
  // Once around the square, every side told twice: a frame of width 0.2 about a line of length 4.
  std::vector<Line> lines;
  for (int k = 0; k < 4; ++k) {
    lines.push_back({square[k], square[(k + 1) % 4]});
    lines.push_back({square[(k + 1) % 4], square[k]});
  }
  const std::vector<Polygon> frame = strokes(lines, 0.2);
  ASSERT_EQ(frame.size(), 1u);
  EXPECT_NEAR(std::abs(area(frame[0])), 0.8, 1e-12);
}

TEST(Polygons, AnOpenStrokeStandsOutByHalfItsWidth) {
  const std::vector<Polygon> line = strokes({{{1, 0}, {2, 0}}, {{0, 0}, {1, 0}}}, 0.2);
  ASSERT_EQ(line.size(), 1u);
  EXPECT_NEAR(std::abs(area(line[0])), 0.2 * 2.2, 1e-12);
  EXPECT_EQ(strokes({{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}}, 0.2).size(), 2u) << "apart";
  EXPECT_TRUE(strokes({{{0, 0}, {0, 0}}}, 0.2).empty()) << "a point";
}

TEST(Polygons, WidenBySoMuchOnEverySide) { EXPECT_NEAR(area(widened(square, 0.1)), 1.44, 1e-12); }

}  // namespace
}  // namespace lcp
