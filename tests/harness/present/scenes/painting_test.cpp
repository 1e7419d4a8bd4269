#include "harness/present/scenes/painting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/harness/present/scenes/nearness.h"

namespace lcp {
namespace {

using namespace collision;

struct Body {
  Geometry geometry;
  Pose pose;
};

struct Painted {
  std::vector<Facet> all, painted;
  std::size_t whole = 0, cut = 0;  ///< Coats.
};

Painted painted(const std::vector<Body>& bodies, const Camera& camera) {
  Painted made;
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (const Piece& piece :
         seen_from(camera.towards_viewer, pieces_of(bodies[i].geometry), bodies[i].pose, i)) {
      pieces.push_back(piece);
      made.all.insert(made.all.end(), piece.begin(), piece.end());
    }
  for (const Coat& coat : painting_order(pieces, camera)) {
    (coat.whole ? made.whole : made.cut) += 1;
    made.painted.insert(made.painted.end(), coat.facets.begin(), coat.facets.end());
  }
  return made;
}

Pose turned(double angle, const Vector3d& axis, const Vector3d& at) {
  return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), at};
}

Ring circle(int corners, double radius, double wire) {
  Ring ring{.corners = {}, .radius = wire};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return ring;
}

const std::vector<Body> linked = {{circle(12, 0.5, 0.06), turned(0.3, {0, 1, 0}, {-0.25, 0, 0})},
                                  {circle(4, 0.5, 0.06), turned(1.5, {1, 0, 0}, {0.25, 0, 0})}};

TEST(Painting, ARingThroughAnotherLiesBeforeItHereAndBehindItThere) {
  const Camera camera = Camera::from(-0.9, 0.4);
  const Painted rings = painted(linked, camera);
  EXPECT_EQ(rings.cut, 0u) << "segments are convex and apart: none needs to be cut";
  EXPECT_EQ(rings.all.size(), rings.painted.size());
  EXPECT_GT(expect_nearest_on_top(rings.all, rings.painted, camera, 0.8, 0.0231), 500);
  // Neither ring is painted in one go.
  std::size_t changes = 0;
  for (std::size_t i = 1; i < rings.painted.size(); ++i)
    changes += rings.painted[i].body != rings.painted[i - 1].body;
  EXPECT_GE(changes, 2u);
}

TEST(Painting, RodsRoundAboutInACircleAreCut) {
  std::vector<Body> rods;
  for (int i = 0; i < 3; ++i) {
    const Matrix3d around =
        Eigen::AngleAxisd(2 * std::numbers::pi / 3 * i, Vector3d::UnitZ()).toRotationMatrix();
    const Pose lying = turned(std::numbers::pi / 2 - 0.25, {1, 0, 0}, {0.3, 0, 0});
    rods.push_back({Cylinder{0.05, 1.4}, Pose{around, Vector3d::Zero()} * lying});
  }
  const Camera camera = Camera::from(0, 1.5);
  const Painted seen = painted(rods, camera);
  EXPECT_EQ(seen.cut, 1u);
  EXPECT_GT(seen.painted.size(), seen.all.size());
  EXPECT_GT(expect_nearest_on_top(seen.all, seen.painted, camera, 0.8, 0.0371), 200);
}

TEST(Painting, ACapsuleThatPiercesABoxIsCutWithIt) {
  const Camera camera = Camera::from(-0.9, 0.4);
  const Painted seen = painted(
      {{Box{{0.5, 0.5, 0.5}}, {}}, {Capsule{0.1, 1.2}, turned(1, {1, 0.3, 0}, {0, 0, 0})}}, camera);
  EXPECT_EQ(seen.cut, 1u);
  EXPECT_GT(expect_nearest_on_top(seen.all, seen.painted, camera, 0.8, 0.0371), 200);
}

TEST(Painting, OfTwoCapsulesAtAJointTheNearerIsPaintedOverTheOther) {
  const Camera camera = Camera::from(0, 0);  // looks against x
  const Capsule capsule{0.1, 0.5};
  const Body nearer{
      capsule,
      turned(1.1, {0, 1, 0}, Eigen::AngleAxisd(1.1, Vector3d::UnitY()) * Vector3d(0, 0, 0.25))};
  const Body farther{capsule, turned(0, {0, 1, 0}, {0, 0, -0.25})};
  for (const bool swapped : {false, true}) {
    const Painted seen =
        swapped ? painted({farther, nearer}, camera) : painted({nearer, farther}, camera);
    EXPECT_EQ(seen.whole, 2u);
    EXPECT_EQ(seen.painted.back().body, swapped ? 1u : 0u);
  }
}

TEST(Painting, BoxesAloneAreLeftToTheirPlanes) {
  const Camera camera = Camera::from(-0.9, 0.4);
  const Painted seen = painted(
      {{Box{{1, 0.2, 0.2}}, {}}, {Box{{0.2, 1, 0.2}}, turned(0.1, {0, 0, 1}, {0, 0, 1})}}, camera);
  EXPECT_EQ(seen.cut, 1u);
  EXPECT_EQ(seen.whole, 0u);
}

TEST(Painting, NothingIsPaintedOfNothing) {
  EXPECT_TRUE(painted({}, Camera::from(0, 0)).painted.empty());
}

}  // namespace
}  // namespace lcp
