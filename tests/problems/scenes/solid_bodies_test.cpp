#include "problems/scenes/solid_bodies.h"

#include <gtest/gtest.h>

#include <numbers>

namespace lcp {
namespace {

using namespace collision;

/// Of a body of revolution about z with radius r(z) between -end and end, of unit mass, from slices.
template <class Radius>
Matrix3d by_slices(double end, Radius radius) {
  constexpr int kSlices = 200000;
  double volume = 0, across = 0, along = 0;
  for (int i = 0; i < kSlices; ++i) {
    const double z = end * (2 * (i + 0.5) / kSlices - 1), r2 = radius(z) * radius(z);
    volume += r2;
    along += r2 * r2 / 2;
    across += r2 * (r2 / 4 + z * z);
  }
  return Vector3d(across / volume, across / volume, along / volume).asDiagonal();
}

TEST(SolidInertia, OfRoundBodiesIsThatOfTheirSlices) {
  const double r = 0.3, half = 0.4;
  const auto ball = [&](double z) { return std::sqrt(std::max(0.0, r * r - z * z)); };
  EXPECT_TRUE(solid_inertia(Sphere{r}, 1).isApprox(by_slices(r, ball), 1e-8));
  EXPECT_TRUE(
      solid_inertia(Capsule{r, 2 * half}, 1)
          .isApprox(by_slices(half + r,
                              [&](double z) { return ball(std::max(0.0, std::abs(z) - half)); }),
                    1e-8));
  EXPECT_TRUE(solid_inertia(Cylinder{r, 2 * half}, 1)
                  .isApprox(by_slices(half, [&](double) { return r; }), 1e-8));
}

TEST(SolidInertia, GrowsWithMassAndOfABoxIsTheTextbooks) {
  const Matrix3d inertia = solid_inertia(Box{{1, 2, 3}}, 12);
  EXPECT_TRUE(inertia.isApprox(Matrix3d(Vector3d(13, 10, 5).asDiagonal()), 1e-15));
}

TEST(SolidInertia, OfAFineRingIsThatOfATorus) {
  Ring ring{{}, 0.05};
  for (int i = 0; i < 512; ++i) {
    const double angle = 2 * std::numbers::pi * i / 512;
    ring.corners.push_back({std::cos(angle), std::sin(angle), 0});
  }
  // Of a torus with small and large radius a, c: 5/8 a^2 + c^2 / 2 across, 3/4 a^2 + c^2 along. On
  // the centre line a torus is denser outside, which discs leave out: O(a^2).
  const Matrix3d inertia = solid_inertia(ring, 2);
  EXPECT_NEAR(inertia(2, 2), 2 * (1 + 0.75 * 0.0025), 0.003);
  EXPECT_NEAR(inertia(0, 0), 2 * (0.5 + 0.625 * 0.0025), 0.003);
  EXPECT_NEAR(inertia(0, 1), 0, 1e-12);
}

TEST(SolidInertia, RefusesWhatHasNoVolume) {
  EXPECT_THROW(solid_inertia(HalfSpace{}, 1), std::invalid_argument);
  EXPECT_THROW(solid_inertia(mesh_of(Box{{1, 1, 1}}, 1), 1), std::invalid_argument);
}

/// A box of 2 cm on the floor, 0.1 mm deep; its faces in 3 x 3 squares where it is a mesh.
std::vector<ContactPoint> box_on_floor(Surfaces surfaces) {
  Kinematics k;
  k.pose = {{Matrix3d::Identity(), {0, 0, 0.0099}}};
  const std::vector<Shape> shapes = {{HalfSpace{}}, {Box{{0.02, 0.02, 0.02}}, 0}};
  return touching(shapes, {}, surfaces, 3)(k);
}

TEST(Touching, FindsABoxOnTheFloorBothAsItIsAndAsTriangles) {
  const auto exact = box_on_floor(Surfaces::exact), mesh = box_on_floor(Surfaces::mesh);
  EXPECT_EQ(exact.size(), 4u);
  EXPECT_EQ(mesh.size(), 16u);
  for (const auto* points : {&exact, &mesh})
    for (const ContactPoint& point : *points) {
      EXPECT_NEAR(point.depth, 1e-4, 1e-12);
      EXPECT_EQ(point.normal, Vector3d::UnitZ().eval());
    }
}

}  // namespace
}  // namespace lcp
