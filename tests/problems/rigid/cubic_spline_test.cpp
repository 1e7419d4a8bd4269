#include "problems/rigid/cubic_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/problems/rigid/figures.h"

namespace lcp {
namespace {

/// `function` at count knots over [0, duration], one row.
CubicSpline through(const std::function<double(double)>& function, Index count,
                    double duration = 1) {
  const double spacing = duration / static_cast<double>(count - 1);
  return CubicSpline(
      MatrixXd::NullaryExpr(
          1, count, [&](Index, Index k) { return function(spacing * static_cast<double>(k)); }),
      spacing);
}

/// Three components that jump about.
CubicSpline jagged() {
  return CubicSpline(MatrixXd{{0, 1, -1, 2, 0.5, 0.5}, {1, 1, 1, 1, 1, 1}, {-2, 0, 3, 1, 4, -1}},
                     0.1);
}

TEST(CubicSpline, PassesThroughItsKnots) {
  const MatrixXd values{{0, 1, -1, 2}, {3, 3.5, 0.25, 7}};
  const CubicSpline spline(values, 0.25);
  for (Index k = 0; k < 4; ++k)
    EXPECT_LE((spline.at(0.25 * static_cast<double>(k)).value - values.col(k)).norm(), 1e-14) << k;
}

TEST(CubicSpline, RatesAndAccelerationsAreItsDerivatives) {
  const CubicSpline spline = jagged();
  constexpr double h = 1e-5;
  for (double t = 0.013; t < 0.5; t += 0.02) {
    const CubicSpline::Point before = spline.at(t - h), here = spline.at(t),
                             after = spline.at(t + h);
    EXPECT_LE(((after.value - before.value) / (2 * h) - here.rate).norm(), 1e-5) << t;
    EXPECT_LE(((after.rate - before.rate) / (2 * h) - here.acceleration).norm(), 1e-4) << t;
  }
}

TEST(CubicSpline, IsTwiceContinuouslyDifferentiableAtInnerKnots) {
  const CubicSpline spline = jagged();
  constexpr double h = 1e-9;
  for (const double knot : {0.1, 0.2, 0.3, 0.4}) {
    const CubicSpline::Point before = spline.at(knot - h), after = spline.at(knot + h);
    const double steep = spline.at(knot).acceleration.norm();  // 600, jerk 2e4: 1e-9 s are 2e-5
    EXPECT_LE((after.value - before.value).norm(), 1e-6) << knot;
    EXPECT_LE((after.rate - before.rate).norm(), 1e-5) << knot;
    EXPECT_LE((after.acceleration - before.acceleration).norm(), 1e-6 * (1 + steep)) << knot;
  }
}

TEST(CubicSpline, RestsAtBothEndsAndStaysThere) {
  const CubicSpline spline = jagged();
  constexpr double h = 1e-9;
  for (const double end : {0.0, 0.5}) {
    const double inside = end == 0 ? h : end - h, outside = end == 0 ? -3.0 : 3.0;
    EXPECT_LE(spline.at(inside).rate.norm(), 1e-5);
    EXPECT_LE((spline.at(inside).value - spline.at(outside).value).norm(), 1e-9);
    EXPECT_EQ(spline.at(outside).rate.norm(), 0);
    EXPECT_EQ(spline.at(outside).acceleration.norm(), 0);
  }
}

TEST(CubicSpline, ReproducesACubicThatRestsAtBothEnds) {
  const auto cubic = [](double t) { return 3 + t * t * (3 - 2 * t); };
  for (const Index knots : {2, 3, 8}) {
    const CubicSpline spline = through(cubic, knots);
    for (double t = 0.01; t < 1; t += 0.07) {
      EXPECT_NEAR(spline.at(t).value(0), cubic(t), 1e-14) << knots;
      EXPECT_NEAR(spline.at(t).rate(0), 6 * t * (1 - t), 1e-13) << knots;
      EXPECT_NEAR(spline.at(t).acceleration(0), 6 - 12 * t, 1e-12) << knots;
    }
  }
}

TEST(CubicSpline, ConvergesWithTheFourthPowerOfTheSpacing) {
  const auto wave = [](double t) { return std::cos(2 * std::numbers::pi * t); };
  const auto error = [&](Index knots) {
    const CubicSpline spline = through(wave, knots);
    double largest = 0;
    for (double t = 0; t < 1; t += 1e-3)
      largest = std::max(largest, std::abs(spline.at(t).value(0) - wave(t)));
    return largest;
  };
  EXPECT_NEAR(cases::record("ratio when the spacing halves", error(17) / error(33)), 16, 2);
}

TEST(CubicSpline, RefusesOneKnotAndTimesThatDoNotPass) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CubicSpline(MatrixXd::Ones(3, 1), 0.1), std::invalid_argument);
  EXPECT_THROW(CubicSpline(MatrixXd::Ones(3, 0), 0.1), std::invalid_argument);
  for (const double spacing : {0.0, -0.1, kNaN})
    EXPECT_THROW(CubicSpline(MatrixXd::Ones(3, 2), spacing), std::invalid_argument) << spacing;
  EXPECT_NO_THROW(CubicSpline(MatrixXd::Ones(3, 2), 0.1));
}

TEST(CubicSpline, RefusesWhatIsNotANumber) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CubicSpline(MatrixXd{{0, kNaN, 1}}, 0.1), std::invalid_argument);
  EXPECT_THROW(jagged().at(kNaN), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
