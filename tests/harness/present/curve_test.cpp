#include "harness/present/curve.h"

#include <gtest/gtest.h>

namespace lcp {
namespace {

TEST(StepCurves, CornersGoFromEndToEndAndKeepEveryShare) {
  const Curve curve{4, {1, 10, 10}};
  const std::vector<Pixels> corners = step_corners(curve, {1, 100}, 10);
  EXPECT_DOUBLE_EQ(corners.front().x, 1);
  EXPECT_DOUBLE_EQ(corners.front().y, 0.25);
  EXPECT_DOUBLE_EQ(corners.back().x, 100);
  EXPECT_DOUBLE_EQ(corners.back().y, 0.75);
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_NEAR(corners[1].x, 10, 6) << "within a column of ten";
}

TEST(StepCurves, NoCurveHasMoreCornersThanColumnsNeed) {
  Curve curve;
  curve.counted = 10000;
  for (int i = 0; i < 10000; ++i) curve.reached.push_back(1 + i);
  EXPECT_LE(step_corners(curve, {1, 10000}, 50).size(), 102u);
}

}  // namespace
}  // namespace lcp
