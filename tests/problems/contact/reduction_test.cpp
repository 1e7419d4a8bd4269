#include "problems/contact/reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

using Eigen::Vector3d;
using Points = std::vector<ContactPoint>;
using Method = ReductionOptions::Method;
using Grouping = ReductionOptions::Grouping;
using Separating = ReductionOptions::Separating;

/// A resting point of `body` on the floor; its feature is its number.
ContactPoint on_floor(double x, double y, Index feature, Index body = 1) {
  return {.position = {x, y, 0}, .normal = Vector3d::UnitZ(), .id = {body, 0, feature}};
}

Points on_floor(const std::vector<std::pair<double, double>>& places, Index body = 1) {
  Points points;
  for (const auto& [x, y] : places)
    points.push_back(on_floor(x, y, static_cast<Index>(points.size()), body));
  return points;
}

/// Corners 0-3 and mid-edges 4-7 of a square of 0.2 m, then 8 and 9 inside.
Points square() {
  return on_floor({{-0.1, -0.1},
                   {0.1, -0.1},
                   {0.1, 0.1},
                   {-0.1, 0.1},
                   {0, -0.1},
                   {0.1, 0},
                   {0, 0.1},
                   {-0.1, 0},
                   {0, 0},
                   {0.05, 0.02}});
}

std::vector<Index> features(const Points& points, const ReductionOptions& options = {}) {
  std::vector<Index> kept;
  for (const Index i : reduce_contacts(points, options)) kept.push_back(points[i].id.feature);
  return kept;
}

std::vector<Index> sorted_features(const Points& points, const ReductionOptions& options = {}) {
  std::vector<Index> kept = features(points, options);
  std::sort(kept.begin(), kept.end());
  return kept;
}

std::vector<Index> first(Index count) {
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

void shuffle(Points& points, cases::Uniform& uniform) {
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1],
              points[static_cast<std::size_t>(uniform.between(0, static_cast<double>(i)))]);
}

TEST(Reduction, KeepsCornersAndMidEdgesOfASquareAndDropsWhatIsInside) {
  EXPECT_EQ(sorted_features(square()), first(8));
  EXPECT_EQ(sorted_features(square(), {.method = Method::none}), first(10));
  EXPECT_EQ(sorted_features(square(), {.inside_distance = 1}), first(10));
}

TEST(Reduction, ListsPointsByPairThenDeepestThenByPosition) {
  Points points = on_floor({{0.1, 0}, {0.3, 0}, {0.2, 0}, {0.2, -0.1}});
  points[1].depth = 1e-4;
  points.push_back(on_floor(0, 0, 4, 2));
  points.push_back(on_floor(0.4, 0, 5, 1));
  points.back().id.body2 = 7;
  EXPECT_EQ(features(points, {.method = Method::none}), (std::vector<Index>{1, 0, 3, 2, 5, 4}));
}

TEST(Reduction, KeepsEveryPointOfALine) {
  EXPECT_EQ(sorted_features(on_floor({{0, 0}, {0.1, 0.05}, {0.2, 0.1}, {0.3, 0.15}})), first(4));
}

TEST(Reduction, KeepsNoneOneAndTwoPoints) {
  EXPECT_TRUE(reduce_contacts({}).empty());
  EXPECT_EQ(sorted_features(on_floor({{0.3, 0.1}})), first(1));
  EXPECT_EQ(sorted_features(on_floor({{0.3, 0.1}, {0.3, 0.2}})), first(2));
}

TEST(Reduction, KeepsTheDeepestOfPointsWithinAMillimetre) {
  Points points = on_floor({{0, 0}, {0.0009, 0}, {0.1, 0}, {0.0021, 0}});
  points[1].depth = 1e-5;
  // 3 is 1.2 mm from 1, which stays.
  EXPECT_EQ(sorted_features(points), (std::vector<Index>{1, 2, 3}));
  EXPECT_EQ(sorted_features(points, {.merge_distance = 0}), first(4));
  // 2 mm reach all but 2.
  EXPECT_EQ(sorted_features(points, {.merge_distance = 2e-3}), (std::vector<Index>{1, 2}));
}

TEST(Reduction, KeepsOneOfPointsThatCoincide) {
  EXPECT_EQ(features(on_floor({{0.1, 0.2}, {0.1, 0.2}, {0.1, 0.2}})), (std::vector<Index>{0}));
}

TEST(Reduction, KeepsNeighboursOfAnotherPairOrNormal) {
  // Two feet toe to toe, and a corner that touches floor and wall at once.
  Points points = on_floor({{0, 0}});
  points.push_back(on_floor(0.0005, 0, 1, 2));
  points.push_back(on_floor(0, 0, 2));
  points.back().normal = Vector3d::UnitX();
  EXPECT_EQ(sorted_features(points), first(3));
  EXPECT_EQ(sorted_features(points, {.normal_angle = 2}), first(2));
}

TEST(Reduction, HalfATenthOfAMillimetreInsideTheBoundaryIsOnIt) {
  Points points = square();
  points[4].position.y() += 0.5e-4;
  points[5].position.x() -= 1.5e-4;
  EXPECT_EQ(sorted_features(points), (std::vector<Index>{0, 1, 2, 3, 4, 6, 7}));
  EXPECT_EQ(sorted_features(points, {.inside_distance = 1e-5}),
            (std::vector<Index>{0, 1, 2, 3, 6, 7}));
}

TEST(Reduction, NoiseOfThePlaneAndItsNormalsChangesNothing) {
  cases::Uniform uniform(5);
  for (int round = 0; round < 50; ++round) {
    Points points = square();
    for (ContactPoint& point : points) {
      // 0.05 mm in all: two edges' worth of noise stays below inside_distance.
      point.position += 0.5e-4 / 2 * Vector3d(uniform(), uniform(), 2 * uniform());
      point.normal = (point.normal + 0.02 * Vector3d(uniform(), uniform(), 0)).normalized();
      point.depth = -point.position.z();
    }
    EXPECT_EQ(sorted_features(points), first(8)) << round;
  }
}

TEST(Reduction, NormalsFurtherApartThanTheirToleranceMakePolygonsOfTheirOwn) {
  Points points = square();
  points[8].normal = Vector3d(std::sin(0.2), 0, std::cos(0.2));
  EXPECT_EQ(sorted_features(points), first(9));
  EXPECT_EQ(sorted_features(points, {.normal_angle = 0.3}), first(8));
}

TEST(Reduction, PolygonsLieInTheContactPlaneWhateverItsDirection) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  Points points = square();
  for (ContactPoint& point : points) {
    point.position = turn * point.position + Vector3d(3, -4, 5);
    point.normal = turn * point.normal;
  }
  EXPECT_EQ(sorted_features(points), first(8));
}

/// Two feet of 0.1 x 0.06 m, 0.1 m apart, corners only: 0-3 of body 1, 4-7 of body 2. Point 8 of
/// body 1 lies in the middle of its foot, 9 of body 2 between the inner corners of its own.
Points two_feet() {
  Points points = on_floor({{0.05, 0.11}, {-0.05, 0.11}, {-0.05, 0.05}, {0.05, 0.05}});
  for (const auto& [x, y] : {std::pair(0.05, -0.05), {-0.05, -0.05}, {-0.05, -0.11}, {0.05, -0.11}})
    points.push_back(on_floor(x, y, static_cast<Index>(points.size()), 2));
  points.push_back(on_floor(0, 0.08, 8, 1));
  points.push_back(on_floor(0, -0.05, 9, 2));
  return points;
}

TEST(Reduction, FeetOnOneFloorShareAPolygonUnlessPairsAreGroups) {
  // Corners of the inner edges are on the boundary of the common rectangle, a mid-edge is not.
  EXPECT_EQ(sorted_features(two_feet()), first(8));
  EXPECT_EQ(sorted_features(two_feet(), {.grouping = Grouping::pair}),
            (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7, 9}));
}

TEST(Reduction, FeetOnDifferentFloorsDoNotShareAPolygon) {
  Points points = two_feet();
  for (ContactPoint& point : points)
    if (point.id.body1 == 2) point.id.body2 = 3;
  EXPECT_EQ(sorted_features(points), (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7, 9}));
}

TEST(Reduction, StaggeredFeetLoseTheCornersThatLookAtOneAnother) {
  // Foot 2 is half a foot ahead: of the inner corners 5 and 3 lie inside the common hexagon.
  Points points = two_feet();
  for (ContactPoint& point : points)
    if (point.id.body1 == 2) point.position.x() += 0.05;
  EXPECT_EQ(sorted_features(points), (std::vector<Index>{0, 1, 2, 4, 6, 7}));
}

TEST(Reduction, KeepsASeparatingPointInsideThePolygon) {
  Points points = square();
  points[8].normal_velocity = 0.01;
  points[9].normal_velocity = -0.01;
  EXPECT_EQ(sorted_features(points), first(9));
  EXPECT_EQ(sorted_features(points, {.separating = Separating::as_others}), first(8));
  EXPECT_EQ(sorted_features(points, {.separating_speed = 0.02}), first(8));
}

TEST(Reduction, KeepsASeparatingPointWithinAMillimetreOfAnother) {
  Points points = on_floor({{0, 0}, {0.0005, 0}, {0.0009, 0}});
  points[1].normal_velocity = 0.01;
  EXPECT_EQ(sorted_features(points), first(2));
  EXPECT_EQ(sorted_features(points, {.separating = Separating::as_others}), first(1));
}

TEST(Reduction, SeparatingCornersStillMakeThePolygonUnlessDropped) {
  Points points = square();
  for (const Index corner : {2, 3, 6}) points[corner].normal_velocity = 0.01;
  EXPECT_EQ(sorted_features(points), first(8));
  // Without them the polygon ends at y = 0.02, the height of point 9.
  EXPECT_EQ(sorted_features(points, {.separating = Separating::drop}),
            (std::vector<Index>{0, 1, 4, 5, 7, 9}));
}

TEST(Reduction, DeepestFourOfEachPairBreakTiesByPosition) {
  Points points = square();
  points[8].depth = 1e-3;
  points.push_back(on_floor(7, 7, 10, 2));
  EXPECT_EQ(features(points, {.method = Method::deepest_4}), (std::vector<Index>{8, 0, 7, 3, 10}));
  EXPECT_EQ(features(points, {.method = Method::deepest_4, .per_pair = 2}),
            (std::vector<Index>{8, 0, 10}));
}

TEST(Reduction, TheOrderOfThePointsHasNoInfluence) {
  cases::Uniform uniform(9);
  Points points = two_feet();
  for (Index k = 0; k < 20; ++k) {  // clusters within a millimetre, inner points, equal depths
    points.push_back(on_floor(0.06 * uniform(), 0.1 + 0.02 * uniform(), 10 + k, 1 + k % 2));
    points.back().depth = k % 3 == 0 ? 1e-4 : 1e-4 * uniform();
    points.back().normal_velocity = k % 5 == 0 ? 0.1 : 0;
    points.push_back(points.back());
    points.back().id.feature += 20;
    points.back().position.x() += 7e-4;
  }
  for (const Method method : {Method::none, Method::paper, Method::deepest_4}) {
    const std::vector<Index> expected = features(points, {.method = method});
    ASSERT_FALSE(expected.empty());
    Points shuffled = points;
    for (int round = 0; round < 100; ++round) {
      shuffle(shuffled, uniform);
      EXPECT_EQ(features(shuffled, {.method = method}), expected) << round;
    }
  }
}

TEST(Reduction, RefusesNumbersThatAreNotFiniteAndNormalsThatAreNotUnit) {
  Points points = square();
  points[3].depth = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(reduce_contacts(points), std::invalid_argument);
  points = square();
  points[3].normal *= 2;
  EXPECT_THROW(reduce_contacts(points), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
