// Capsules and cylinders side by side, crossing, lying and standing on others.

#include <gtest/gtest.h>

#include "tests/problems/collision/collision_cases.h"

namespace lcp {
namespace {

using namespace collision;

using cases::Solid;

constexpr double kDepth = 1e-4;  // m

Geometry long_one(bool cylinder, double radius, double length) {
  if (cylinder) return Cylinder{radius, length};
  return Capsule{radius, length};
}

/// Along z at a distance in x, `up` along z, turned about x by `angle`.
Pose beside(double distance, double up, double angle = 0) {
  return cases::turned_about(Vector3d::UnitX(), angle, {distance, 0, up});
}

struct Kinds {
  bool first_is_cylinder, second_is_cylinder;
};

class Parallel : public testing::TestWithParam<Kinds> {
 protected:
  Geometry first(double radius, double length) const {
    return long_one(GetParam().first_is_cylinder, radius, length);
  }
  Geometry second(double radius, double length) const {
    return long_one(GetParam().second_is_cylinder, radius, length);
  }
  /// The first at +x beside the second.
  std::vector<ContactPoint> contacts(double length1, double length2, double up,
                                     double angle) const {
    const Solid one{first(0.01, length1), beside(0.03 - kDepth, up, angle)};
    const Solid other{second(0.02, length2), beside(0, 0)};
    return cases::contacts_of(one, other);
  }
};

void expect_ends(const std::vector<ContactPoint>& points, double low, double high,
                 double tolerance) {
  ASSERT_EQ(points.size(), 2);
  EXPECT_NEAR(std::min(points[0].position.z(), points[1].position.z()), low, tolerance);
  EXPECT_NEAR(std::max(points[0].position.z(), points[1].position.z()), high, tolerance);
  for (const ContactPoint& point : points) {
    EXPECT_NEAR(point.depth, kDepth, 1e-12);
    EXPECT_NEAR(point.position.x(), 0.02 - kDepth / 2, 1e-12);
    EXPECT_NEAR(point.position.y(), 0, tolerance);
    EXPECT_LE((point.normal - Vector3d::UnitX()).norm(), tolerance / 0.01);
  }
}

TEST_P(Parallel, TouchAtBothEndsOfTheStretchInCommon) {
  expect_ends(contacts(0.1, 0.3, 0, 0), -0.05, 0.05, 1e-12);
  expect_ends(contacts(0.3, 0.1, 0, 0), -0.05, 0.05, 1e-12);
  expect_ends(contacts(0.2, 0.2, 0.05, 0), -0.05, 0.1, 1e-12);
}

TEST_P(Parallel, TouchAtBothEndsWhenNearlyParallel) {
  // At the ends the axes are 0.05 m times the angle farther apart than side by side: as good as
  // not.
  for (const double angle : {1e-9, 1e-7, -1e-6}) {
    const auto points = contacts(0.1, 0.3, 0.02, angle);
    expect_ends(points, -0.03, 0.07, 1e-7);
  }
}

TEST_P(Parallel, AreAsDeepAtEachEndAsTheAxesAreNearThere) {
  const double angle = 5e-3, y = 0.05 * std::sin(angle);
  const auto points = contacts(0.1, 0.3, 0, angle);
  ASSERT_EQ(points.size(), 3);  // where they cross, then both ends
  EXPECT_NEAR(points[0].depth, kDepth, 1e-12);
  EXPECT_NEAR(points[0].position.z(), 0, 1e-9);
  for (const int end : {1, 2}) {
    EXPECT_NEAR(points[end].depth, 0.03 - std::hypot(0.03 - kDepth, y), 1e-6 * kDepth);
    EXPECT_NEAR(std::abs(points[end].position.z()), 0.05 * std::cos(angle), 1e-5);
    EXPECT_GT(std::abs(points[end].normal.y()), 0.9 * y / 0.03);
  }
}

TEST_P(Parallel, TouchOnceWhereTheyCross) {
  for (const double angle : {0.1, 0.5, 1.5}) {
    const auto points = contacts(0.1, 0.3, 0, angle);
    ASSERT_EQ(points.size(), 1) << angle;
    EXPECT_NEAR(points[0].depth, kDepth, 1e-12);
    EXPECT_LE((points[0].position - Vector3d(0.02 - kDepth / 2, 0, 0)).norm(), 1e-9) << angle;
  }
}

TEST_P(Parallel, DoNotTouchBesideEachOther) { EXPECT_TRUE(contacts(0.1, 0.1, 0.135, 0).empty()); }

INSTANTIATE_TEST_SUITE_P(
    Kinds, Parallel, testing::Values(Kinds{false, false}, Kinds{false, true}, Kinds{true, true}),
    [](const auto& kinds) {
      const auto name = [](bool cylinder) {
        return std::string(cylinder ? "cylinder" : "capsule");
      };
      return name(kinds.param.first_is_cylinder) + "_on_" + name(kinds.param.second_is_cylinder);
    });

TEST(Crossing, CylinderTouchesAtItsRimWhereItEndsShortOfTheOther) {
  // Along y, from 0.2 mm beside the other's axis on: 0.01 rad from lying on its side.
  constexpr double end = 2e-4, x = 0.02 - kDepth;
  const Solid short_of{
      Cylinder{0.01, 0.1},
      cases::turned_about(Vector3d::UnitX(), std::numbers::pi / 2, {x + 0.01, end + 0.05, 0})};
  const Solid upright{Cylinder{0.02, 0.1}, Pose{}};
  const Vector3d rim(x, end, 0), normal = rim.normalized();
  const double depth = 0.02 - rim.norm();
  for (const bool first : {true, false}) {
    const auto points =
        first ? cases::contacts_of(short_of, upright) : cases::contacts_of(upright, short_of);
    ASSERT_EQ(points.size(), 1);
    EXPECT_NEAR(points[0].depth, depth, 1e-12);
    EXPECT_LE((points[0].position - (rim + depth / 2 * normal)).norm(), 1e-9);
    EXPECT_LE((points[0].normal - (first ? 1 : -1) * normal).norm(), 1e-7);
  }
}

/// A table of 20 cm with its top at z = 0.
const Solid kTable{Box{{0.2, 0.2, 0.1}}, {Matrix3d::Identity(), {0, 0, -0.05}}};

TEST(LyingOnABox, CapsuleAndCylinderTouchAtBothEnds) {
  const Pose lying =
      cases::turned_about(Vector3d::UnitY(), std::numbers::pi / 2, {0.02, 0.01, 0.01 - kDepth});
  for (const bool cylinder : {false, true}) {
    const auto points = cases::contacts_of({long_one(cylinder, 0.01, 0.1), lying}, kTable);
    ASSERT_EQ(points.size(), 2);
    for (const ContactPoint& point : points) {
      EXPECT_NEAR(point.depth, kDepth, 1e-12);
      EXPECT_NEAR(std::abs(point.position.x() - 0.02), 0.05, 1e-9);
      EXPECT_LE((point.normal - Vector3d::UnitZ()).norm(), 1e-9);
    }
  }
}

TEST(LyingOnABox, LongCapsuleAndCylinderTouchAtTheEdges) {
  const Pose lying =
      cases::turned_about(Vector3d::UnitY(), std::numbers::pi / 2, {0, 0, 0.01 - kDepth});
  for (const bool cylinder : {false, true}) {
    const auto points = cases::contacts_of({long_one(cylinder, 0.01, 0.4), lying}, kTable);
    ASSERT_EQ(points.size(), 2);
    for (const ContactPoint& point : points) {
      EXPECT_NEAR(point.depth, kDepth, 1e-12);
      EXPECT_NEAR(std::abs(point.position.x()), 0.1, 1e-9);
    }
  }
}

TEST(StandingOnABox, CylinderTouchesAllRoundItsRim) {
  const Solid cylinder{Cylinder{0.03, 0.1}, {Matrix3d::Identity(), {0.01, 0, 0.05 - kDepth}}};
  const auto points = cases::contacts_of(cylinder, kTable);
  ASSERT_EQ(points.size(), 8);
  Vector3d sum = Vector3d::Zero();
  for (const ContactPoint& point : points) {
    EXPECT_NEAR(point.depth, kDepth, 1e-12);
    const Vector3d from_axis = point.position - Vector3d(0.01, 0, -kDepth / 2);
    EXPECT_NEAR(from_axis.norm(), 0.03, 1e-12);
    sum += from_axis;
  }
  EXPECT_LE(sum.norm(), 1e-12);
}

TEST(StandingOnABox, BoxTouchesWithTheFourCornersThatAreOnIt) {
  const Solid box{Box{{0.1, 0.04, 0.02}}, {Matrix3d::Identity(), {0.08, 0, 0.01 - kDepth}}};
  const auto points = cases::contacts_of(box, kTable);
  ASSERT_EQ(points.size(), 4);
  for (const ContactPoint& point : points) {
    EXPECT_NEAR(point.depth, kDepth, 1e-12);
    const double x = point.position.x();
    EXPECT_NEAR(std::min(std::abs(x - 0.03), std::abs(x - 0.1)), 0, 1e-12);
    EXPECT_NEAR(std::abs(point.position.y()), 0.02, 1e-12);
  }
}

}  // namespace
}  // namespace lcp
