#include <gtest/gtest.h>

#include "tests/problems/collision/collision_cases.h"

namespace lcp {
namespace {

using namespace collision;

using cases::Solid;
using cases::Uniform;

/// The floor z <= 0 and a solid on link 0.
std::vector<ContactPoint> on_floor(const Solid& solid) {
  World world({{HalfSpace{}}, {solid.geometry, 0}});
  return world.contacts(cases::links_at({solid.pose}));
}

Pose at_height(double z) { return {Matrix3d::Identity(), {0.3, -0.2, z}}; }

TEST(HalfSpace, CarriesABoxOnFourCornersEquallyDeep) {
  const auto points = on_floor({Box{{0.2, 0.1, 0.1}}, at_height(0.05 - 1e-3)});
  ASSERT_EQ(points.size(), 4);
  double sum_x = 0, sum_y = 0;
  for (const ContactPoint& point : points) {
    EXPECT_NEAR(point.depth, 1e-3, 1e-15);
    EXPECT_EQ(point.normal, Vector3d::UnitZ());
    EXPECT_NEAR(point.position.z(), -0.5e-3, 1e-15);
    EXPECT_NEAR(std::abs(point.position.x() - 0.3), 0.1, 1e-15);
    EXPECT_NEAR(std::abs(point.position.y() + 0.2), 0.05, 1e-15);
    EXPECT_EQ(point.id.body1, 1);
    EXPECT_EQ(point.id.body2, 0);
    sum_x += point.position.x() - 0.3;
    sum_y += point.position.y() + 0.2;
  }
  EXPECT_NEAR(sum_x, 0, 1e-15);
  EXPECT_NEAR(sum_y, 0, 1e-15);
}

TEST(HalfSpace, TouchesTheLowestPointAsDeepAsItIs) {
  Uniform uniform(5);
  for (const char* kind : {"sphere", "capsule", "box", "cylinder"}) {
    for (int i = 0; i < 300; ++i) {
      const Solid solid{cases::random_geometry(kind, uniform), cases::random_pose(uniform)};
      const Solid floor{Box{{10, 10, 10}}, at_height(-5)};
      const double depth = cases::exact_overlap(solid, floor).depth;
      if (depth > 0.02) continue;  // the shortest way out may be another
      const auto points = on_floor(solid);
      ASSERT_EQ(points.empty(), depth < 0) << kind << " " << depth;
      if (!points.empty()) {
        EXPECT_NEAR(points.front().depth, depth, 1e-12) << kind;
      }
    }
  }
}

TEST(HalfSpace, DoesNotTouchWhatIsJustAbove) {
  EXPECT_TRUE(on_floor({Box{{0.2, 0.1, 0.1}}, at_height(0.05 + 1e-12)}).empty());
  EXPECT_TRUE(on_floor({Sphere{0.05}, at_height(0.05 + 1e-12)}).empty());
  EXPECT_EQ(on_floor({Sphere{0.05}, at_height(0.05 - 1e-12)}).size(), 1);
}

TEST(HalfSpace, CarriesALyingCapsuleAndCylinderAtBothEnds) {
  const Pose lying = cases::turned_about(Vector3d::UnitY(), std::numbers::pi / 2, {0, 0, 0.0099});
  for (const Geometry& geometry : {Geometry(Capsule{0.01, 0.08}), Geometry(Cylinder{0.01, 0.08})}) {
    const auto points = on_floor({geometry, lying});
    ASSERT_EQ(points.size(), 2) << name_of(geometry);
    for (const ContactPoint& point : points) {
      EXPECT_NEAR(point.depth, 1e-4, 1e-15);
      EXPECT_NEAR(std::abs(point.position.x()), 0.04, 1e-12);
      EXPECT_NEAR(point.position.y(), 0, 1e-12);
    }
    EXPECT_LT(points[0].position.x() * points[1].position.x(), 0);
  }
}

TEST(HalfSpace, CarriesAStandingCylinderAllRoundItsRim) {
  const auto points = on_floor({Cylinder{0.03, 0.08}, at_height(0.0399)});
  ASSERT_EQ(points.size(), 4);
  Vector3d sum = Vector3d::Zero();
  for (const ContactPoint& point : points) {
    EXPECT_NEAR(point.depth, 1e-4, 1e-15);
    EXPECT_NEAR((point.position - Vector3d(0.3, -0.2, -0.5e-4)).norm(), 0.03, 1e-12);
    sum += point.position - Vector3d(0.3, -0.2, -0.5e-4);
  }
  EXPECT_LE(sum.norm(), 1e-12);
}

TEST(HalfSpace, TouchesCornersOfARingThatAreBelow) {
  // Standing on a corner; those beside it are 0.096 mm higher.
  const Solid ring{cases::round_ring(0.02, 0.002, 64),
                   cases::turned_about(Vector3d::UnitX(), std::numbers::pi / 2, {0, 0, 0.0219})};
  const auto points = on_floor(ring);
  ASSERT_EQ(points.size(), 3);
  EXPECT_NEAR(points[0].depth, 1e-4, 1e-15);
  EXPECT_NEAR(points[1].depth, 1e-4 - 0.02 * (1 - std::cos(std::numbers::pi / 32)), 1e-12);
  EXPECT_NEAR(points[0].position.z(), -0.5e-4, 1e-12);
}

TEST(HalfSpace, StandsOnALinkAndSlants) {
  Uniform uniform(17);
  const Pose slant = cases::random_pose(uniform);
  World world({{HalfSpace{}, 1}, {Sphere{0.02}, 0}});
  const Pose sphere{Matrix3d::Identity(), slant * Vector3d(0.1, 0.2, 0.019)};
  const auto points = world.contacts(cases::links_at({sphere, slant}));
  ASSERT_EQ(points.size(), 1);
  EXPECT_NEAR(points[0].depth, 1e-3, 1e-15);
  EXPECT_LE((points[0].position - slant * Vector3d(0.1, 0.2, -0.5e-3)).norm(), 1e-14);
  // The half-space is on the higher link: the normal leads to it.
  EXPECT_LE((points[0].normal + slant.R.col(2)).norm(), 1e-14);
  EXPECT_EQ(points[0].id.body1, 2);
}

}  // namespace
}  // namespace lcp
