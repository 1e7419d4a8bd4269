// Rings of 64 segments against exact circles, and polylines that are not circles.

#include <gtest/gtest.h>

#include <set>

#include "tests/problems/collision/circles.h"
#include "tests/problems/collision/collision_cases.h"

namespace lcp {
namespace {

using namespace collision;

using cases::Circle;
using cases::NearestPoints;
using cases::Solid;
using cases::Uniform;

constexpr double kRadius = 0.02;  // m, of the rings
constexpr double kWire = 0.0015;  // m
constexpr Index kSegments = 64;
const double kSagitta = kRadius * (1 - std::cos(std::numbers::pi / kSegments));

Solid ring_at(const Pose& pose) { return {cases::round_ring(kRadius, kWire, kSegments), pose}; }

Vector3d on_circle(double angle) {
  return {kRadius * std::cos(angle), kRadius * std::sin(angle), 0};
}

/// Two circles in random poses whose wires overlap by 0.1 to 0.6 mm at the deepest place.
std::pair<Circle, Circle> random_circles(Uniform& uniform) {
  while (true) {
    Circle first{kRadius, cases::random_pose(uniform)};
    const Circle second{kRadius, cases::random_pose(uniform)};
    // Two points opposite each other: across both wires.
    const double angle1 = uniform.between(0, 6), angle2 = uniform.between(0, 6);
    const Vector3d tangent1 = first.pose.R * Vector3d::UnitZ().cross(on_circle(angle1));
    const Vector3d tangent2 = second.pose.R * Vector3d::UnitZ().cross(on_circle(angle2));
    const Vector3d apart =
        (2 * kWire - uniform.between(1e-4, 5e-4)) * tangent1.cross(tangent2).normalized();
    first.pose.p += second.pose * on_circle(angle2) + apart - first.pose * on_circle(angle1);
    const double depth = 2 * kWire - cases::nearest_points(first, second)[0].distance;
    if (depth > 1e-4 && depth < 6e-4) return {first, second};
  }
}

/// Whether no other minimum is so near, along wires that are nearly parallel, that a few segments
/// cannot tell them apart.
bool alone(const NearestPoints& minimum, const std::vector<NearestPoints>& minima) {
  return std::none_of(minima.begin(), minima.end(), [&](const NearestPoints& other) {
    const double apart = (other.on_first - minimum.on_first).norm();
    return apart > 0 && apart < 0.01;
  });
}

TEST(RingOnRing, TouchesWhereCirclesAreNearest) {
  Uniform uniform(64);
  double depth_errors = 0, angles = 0, worst_depth = 0;
  Index compared = 0, several = 0;
  for (int pose = 0; pose < 200; ++pose) {
    const auto [first, second] = random_circles(uniform);
    const auto points = cases::contacts_of(ring_at(first.pose), ring_at(second.pose));
    Index deep = 0;
    std::set<std::size_t> used;
    const auto minima = cases::nearest_points(first, second);
    for (const NearestPoints& exact : minima) {
      const double depth = 2 * kWire - exact.distance;
      if (depth < 2 * kSagitta) continue;  // the polylines may miss it
      if (!alone(exact, minima)) continue;
      ++deep;
      const Vector3d middle = (exact.on_first + exact.on_second) / 2;
      std::size_t nearest = 0;
      for (std::size_t i = 0; i < points.size(); ++i)
        if ((points[i].position - middle).norm() < (points[nearest].position - middle).norm())
          nearest = i;
      ASSERT_FALSE(points.empty()) << pose;
      EXPECT_LE((points[nearest].position - middle).norm(), 4e-3) << pose;
      EXPECT_TRUE(used.insert(nearest).second) << pose << ": two minima, one point";
      const Vector3d normal = (exact.on_first - exact.on_second) / exact.distance;
      const double angle = std::acos(std::min(1.0, normal.dot(points[nearest].normal)));
      depth_errors += std::abs(points[nearest].depth - depth);
      worst_depth = std::max(worst_depth, std::abs(points[nearest].depth - depth));
      angles += angle;
      ++compared;
    }
    several += deep > 1;
    EXPECT_GE(static_cast<Index>(points.size()), deep);
  }
  EXPECT_GE(compared, 200);
  EXPECT_GE(several, 5);
  EXPECT_LE(worst_depth, 2 * kSagitta);
  EXPECT_LE(depth_errors / static_cast<double>(compared), 2e-5);
  EXPECT_LE(angles / static_cast<double>(compared), 1.8 * std::numbers::pi / 180);
}

TEST(RingOnRing, ReportsNoPointWhereCirclesHaveNoMinimum) {
  Uniform uniform(65);
  Index points_found = 0, strays = 0;
  for (int pose = 0; pose < 200; ++pose) {
    const auto [first, second] = random_circles(uniform);
    const auto exact = cases::nearest_points(first, second);
    for (const ContactPoint& point :
         cases::contacts_of(ring_at(first.pose), ring_at(second.pose))) {
      ++points_found;
      strays += std::none_of(exact.begin(), exact.end(), [&](const NearestPoints& minimum) {
        return (point.position - (minimum.on_first + minimum.on_second) / 2).norm() < 4e-3;
      });
    }
  }
  EXPECT_GE(points_found, 200);
  EXPECT_EQ(strays, 0);
}

TEST(RingOnRing, TouchesOnceAtCornersThatMeet) {
  // Corner 0 of one (at +x) meets corner 32 of the other (at -x), in planes across each other.
  const Pose across = cases::turned_about(Vector3d::UnitX(), std::numbers::pi / 2,
                                          {2 * kRadius + 2 * kWire - 1e-4, 0, 0});
  const auto points = cases::contacts_of(ring_at(across), ring_at({}));
  ASSERT_EQ(points.size(), 1);
  EXPECT_NEAR(points[0].depth, 1e-4, 1e-12);
  EXPECT_LE((points[0].normal - Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_LE((points[0].position - Vector3d(kRadius + kWire - 0.5e-4, 0, 0)).norm(), 1e-9);
}

TEST(RingOnRing, LinkedRingsTouchInside) {
  // Threaded at right angles, pulled apart along x: the wires touch inside.
  const double pulled = 2 * kRadius - 2 * kWire + 1e-4;
  const Pose threaded =
      cases::turned_about(Vector3d::UnitX(), std::numbers::pi / 2, {pulled, 0, 0});
  const auto points = cases::contacts_of(ring_at(threaded), ring_at({}));
  ASSERT_GE(points.size(), 1);
  EXPECT_NEAR(points[0].position.x(), kRadius - kWire + 0.5e-4, 2e-5);
  EXPECT_LT(points[0].normal.x(), -0.9);
}

TEST(RingOnRing, GivesFeaturesThatStayWhenItMovesALittle) {
  const Pose across = cases::turned_about(Vector3d::UnitX(), std::numbers::pi / 2,
                                          {2 * kRadius + 2 * kWire - 1e-4, 0, 0.3e-3});
  Pose moved = across;
  moved.p += Vector3d(-2e-5, 1e-5, 1e-5);
  const auto before = cases::contacts_of(ring_at(across), ring_at({}));
  const auto after = cases::contacts_of(ring_at(moved), ring_at({}));
  ASSERT_EQ(before.size(), 1);
  ASSERT_EQ(after.size(), 1);
  EXPECT_EQ(before[0].id.feature, after[0].id.feature);
}

/// 10 cm a side.
Ring square() {
  return {{{0.05, 0.05, 0}, {-0.05, 0.05, 0}, {-0.05, -0.05, 0}, {0.05, -0.05, 0}}, 0.002};
}

TEST(RingOnSolid, SquareTouchesACapsuleOnTwoSides) {
  // A bar of 3 mm over the sides at x = +-0.05.
  const Solid bar{Capsule{0.003, 0.3},
                  cases::turned_about(Vector3d::UnitY(), std::numbers::pi / 2, {0, 0.01, 0.0049})};
  const auto points = cases::contacts_of({square(), {}}, bar);
  ASSERT_EQ(points.size(), 2);
  for (const ContactPoint& point : points) {
    EXPECT_NEAR(point.depth, 1e-4, 1e-12);
    EXPECT_NEAR(std::abs(point.position.x()), 0.05, 1e-9);
    EXPECT_NEAR(point.position.y(), 0.01, 1e-9);
    EXPECT_LE((point.normal + Vector3d::UnitZ()).norm(), 1e-9);
  }
}

TEST(RingOnSolid, TouchesASphereAsDeepAsItsNearestSegment) {
  Uniform uniform(9);
  int touching = 0;
  for (int i = 0; i < 300; ++i) {
    const double radius = uniform.between(0.002, 0.02);
    const Solid sphere{Sphere{radius},
                       {Matrix3d::Identity(), 0.03 * cases::random_vector(uniform)}};
    const auto points = cases::contacts_of(ring_at({}), sphere);
    double depth = -1;
    const Ring ring = cases::round_ring(kRadius, kWire, kSegments);
    for (Index k = 0; k < kSegments; ++k) {
      const Vector3d a = ring.corners[k], b = ring.corners[(k + 1) % kSegments];
      const double s = std::clamp((sphere.pose.p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      depth = std::max(depth, kWire + radius - (a + s * (b - a) - sphere.pose.p).norm());
    }
    ASSERT_EQ(points.empty(), depth < 0) << i;
    if (points.empty()) continue;
    ++touching;
    EXPECT_NEAR(points[0].depth, depth, 1e-12) << i;
  }
  EXPECT_GT(touching, 50);
}

TEST(RingOnSolid, HangsOnACylinderAndABoxAtOnePoint) {
  // On a rod along y: the wire's inside on its top.
  const Pose rod = cases::turned_about(Vector3d::UnitX(), std::numbers::pi / 2, Vector3d::Zero());
  const Pose hanging = cases::turned_about(Vector3d::UnitX(), std::numbers::pi / 2, {0, 0, 0});
  Solid ring = ring_at(hanging);
  ring.pose.p.z() = -(kRadius - kWire - 0.005 + 1e-4);
  const auto on_cylinder = cases::contacts_of(ring, {Cylinder{0.005, 0.1}, rod});
  ASSERT_EQ(on_cylinder.size(), 1);
  // A corner is above the rod, so that the sides beside it are nearer.
  EXPECT_NEAR(on_cylinder[0].depth, 1e-4, 1e-5);
  EXPECT_LE((on_cylinder[0].normal - Vector3d::UnitZ()).norm(), std::numbers::pi / kSegments);

  const auto on_box = cases::contacts_of(ring, {Box{{0.002, 0.1, 0.01}}, {}});
  ASSERT_GE(on_box.size(), 1);
  EXPECT_NEAR(on_box[0].normal.z(), 1, 0.1);
}

}  // namespace
}  // namespace lcp
