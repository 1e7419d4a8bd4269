// Spheres, capsules, boxes and cylinders in random poses against exact overlaps.

#include <gtest/gtest.h>

#include "tests/problems/collision/collision_cases.h"

namespace lcp {
namespace {

using cases::Overlap;
using cases::Solid;
using cases::Uniform;

/// Kinds of a pair, and how many poses: what their exact overlaps take is time.
struct Pair {
  const char *first, *second;
  int poses;
};

void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.first << "_on_" << pair.second; }

constexpr double kDeepest = 1.5e-3;  // m

class Solids : public testing::TestWithParam<Pair> {
 protected:
  /// Two solids near each other, some of which just do not touch.
  std::pair<Solid, Solid> random_pair() {
    Solid first{cases::random_geometry(GetParam().first, uniform_), cases::random_pose(uniform_)};
    const Solid second{cases::random_geometry(GetParam().second, uniform_),
                       cases::random_pose(uniform_)};
    cases::bring_together(first, second, uniform_.between(-1e-3, kDeepest), uniform_);
    return {first, second};
  }

  Uniform uniform_{2026};
};

TEST_P(Solids, TouchAsDeepAsTheyOverlapAndNowhereElse) {
  int touching = 0, apart = 0;
  double worst_depth = 0, worst_normal = 0;
  for (int pose = 0; pose < GetParam().poses; ++pose) {
    const auto [first, second] = random_pair();
    const Overlap exact = cases::exact_overlap(first, second);
    if (exact.depth > kDeepest) continue;
    const std::vector<ContactPoint> points = cases::contacts_of(first, second);
    if (exact.depth < -1e-12) {
      ++apart;
      EXPECT_TRUE(points.empty()) << "pose " << pose << " with a gap of " << -exact.depth << " m";
    } else if (exact.depth > 1e-12) {
      ++touching;
      ASSERT_FALSE(points.empty()) << "pose " << pose << " overlaps by " << exact.depth << " m";
      const double error = std::abs(points.front().depth - exact.depth);
      worst_depth = std::max(worst_depth, error);
      if (error <= 1e-12)
        worst_normal = std::max(worst_normal, (points.front().normal - exact.normal).norm());
    }
  }
  EXPECT_LE(worst_depth, 1e-12);
  EXPECT_LE(worst_normal, 1e-5);
  EXPECT_GT(touching, GetParam().poses / 3);
  EXPECT_GT(apart, GetParam().poses / 10);
}

TEST_P(Solids, TouchInTheMiddleOfTheOverlapAlongANormalToBody1) {
  for (int pose = 0; pose < 100; ++pose) {
    const auto [first, second] = random_pair();
    const auto points = cases::contacts_of(first, second);
    for (const ContactPoint& point : points) {
      EXPECT_EQ(point.id.body1, 2);
      EXPECT_EQ(point.id.body2, 1);
      EXPECT_GE(point.depth, 0);
      EXPECT_NEAR(point.normal.norm(), 1, 1e-14);
      // Both ends of the overlap are on surfaces: a tiny sphere there is half inside. A capsule's
      // at the ends of a stretch that is not quite parallel are nearly so.
      const double tolerance = &point == &points.front() ? 1e-9 : 1e-5;
      for (const auto& [solid, sign] : {std::pair(&first, 1.0), {&second, -1.0}}) {
        const Vector3d end = point.position - sign * point.depth / 2 * point.normal;
        const Overlap there =
            cases::exact_overlap({collision::Sphere{1e-9}, {Matrix3d::Identity(), end}}, *solid);
        EXPECT_NEAR(there.depth, 1e-9, tolerance) << pose;
      }
    }
  }
}

TEST_P(Solids, TouchAtTheSamePlacesWhenExchanged) {
  for (int pose = 0; pose < 100; ++pose) {
    const auto [first, second] = random_pair();
    const auto one = cases::contacts_of(first, second), other = cases::contacts_of(second, first);
    ASSERT_EQ(one.size(), other.size()) << pose;
    if (one.size() != 1) continue;  // points of equal depth come in any order
    EXPECT_NEAR(one[0].depth, other[0].depth, 1e-12);
    EXPECT_LE((one[0].position - other[0].position).norm(), 1e-7);
    EXPECT_LE((one[0].normal + other[0].normal).norm(), 1e-5);
  }
}

TEST_P(Solids, MoveTheirPointsWithThem) {
  for (int pose = 0; pose < 100; ++pose) {
    auto [first, second] = random_pair();
    const auto before = cases::contacts_of(first, second);
    const Pose motion = cases::random_pose(uniform_);
    first.pose = motion * first.pose;
    second.pose = motion * second.pose;
    const auto after = cases::contacts_of(first, second);
    ASSERT_EQ(before.size(), after.size()) << pose;
    if (before.size() != 1) continue;
    EXPECT_NEAR(before[0].depth, after[0].depth, 1e-12);
    EXPECT_LE((motion * before[0].position - after[0].position).norm(), 1e-7);
    EXPECT_LE((motion.R * before[0].normal - after[0].normal).norm(), 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, Solids,
    testing::Values(Pair{"sphere", "sphere", 1000}, Pair{"sphere", "capsule", 1000},
                    Pair{"sphere", "box", 1000}, Pair{"sphere", "cylinder", 1000},
                    Pair{"capsule", "capsule", 3000}, Pair{"capsule", "box", 3000},
                    Pair{"capsule", "cylinder", 3000}, Pair{"box", "box", 500},
                    Pair{"box", "cylinder", 2000}, Pair{"cylinder", "cylinder", 500}),
    testing::PrintToStringParamName());

}  // namespace
}  // namespace lcp
