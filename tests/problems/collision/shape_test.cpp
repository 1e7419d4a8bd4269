#include "problems/collision/shape.h"

#include <gtest/gtest.h>

#include <limits>

#include "problems/collision/collision.h"

namespace lcp {
namespace {

using namespace collision;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string complaint(const Shape& shape) {
  try {
    check(shape, "here");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Shape, WithSoundSizesIsAccepted) {
  for (const Geometry& geometry :
       {Geometry(HalfSpace{}), Geometry(Sphere{1}), Geometry(Capsule{1, 0}),
        Geometry(Box{{1, 2, 3}}), Geometry(Cylinder{1, 2}),
        Geometry(Ring{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0.1}),
        Geometry(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}})})
    EXPECT_EQ(complaint({geometry}), "");
}

TEST(Shape, RefusesSizesThatAreNoPositiveLengths) {
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
    EXPECT_NE(complaint({Sphere{bad}}), "") << bad;
    EXPECT_NE(complaint({Capsule{bad, 1}}), "") << bad;
    EXPECT_NE(complaint({Cylinder{bad, 1}}), "") << bad;
    EXPECT_NE(complaint({Cylinder{1, bad}}), "") << bad;
    EXPECT_NE(complaint({Box{{1, bad, 1}}}), "") << bad;
    EXPECT_NE(complaint({Ring{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, bad}}), "") << bad;
  }
  for (const double bad : {-1.0, kNaN, kInfinity}) EXPECT_NE(complaint({Capsule{1, bad}}), "");
}

TEST(Shape, RefusesRingsThatAreNoPolygon) {
  EXPECT_NE(complaint({Ring{{{0, 0, 0}, {1, 0, 0}}, 0.1}}), "");
  EXPECT_NE(complaint({Ring{{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, 0.1}}), "");
  EXPECT_NE(complaint({Ring{{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, 0.1}}), "");  // last on first
  EXPECT_NE(complaint({Ring{{{0, 0, 0}, {1, 0, 0}, {0, kNaN, 0}}, 0.1}}), "");
  Ring long_one{{}, 0.1};
  for (Index k = 0; k <= ring_corners_limit; ++k)
    long_one.corners.emplace_back(static_cast<double>(k), 0, 0);
  EXPECT_NE(complaint({long_one}), "");
  long_one.corners.pop_back();
  EXPECT_EQ(complaint({long_one}), "");
}

TEST(Shape, RefusesMeshesWithIndicesOfNoVertex) {
  const std::vector<Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_NE(complaint({Mesh{corners, {}}}), "");
  EXPECT_NE(complaint({Mesh{corners, {{0, 1, 3}}}}), "");
  EXPECT_NE(complaint({Mesh{corners, {{-1, 1, 2}}}}), "");
  EXPECT_NE(complaint({Mesh{corners, {{0, 1, 1}}}}), "");
  EXPECT_NE(complaint({Mesh{{{0, 0, kInfinity}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}), "");
}

TEST(Shape, RefusesFramesThatAreNoRotationsAndLinksBelowTheWorld) {
  EXPECT_NE(complaint({Sphere{1}, 0, {2 * Matrix3d::Identity(), Vector3d::Zero()}}), "");
  EXPECT_NE(complaint({Sphere{1}, 0, {-Matrix3d::Identity(), Vector3d::Zero()}}), "");
  EXPECT_NE(complaint({Sphere{1}, 0, {Matrix3d::Identity(), {0, kNaN, 0}}}), "");
  EXPECT_NE(complaint({Sphere{1}, -2}), "");
}

TEST(Shape, IsNamedInTheMessageWithTheOffendingValue) {
  EXPECT_EQ(complaint({Cylinder{1, -2}}),
            "here: cylinder: length is -2 m, expected a positive length");
  try {
    World({{Sphere{1}}, {Sphere{-1}}});
    FAIL() << "was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "collision: shape 1: sphere: radius is -1 m, expected a positive length");
  }
}

}  // namespace
}  // namespace lcp
