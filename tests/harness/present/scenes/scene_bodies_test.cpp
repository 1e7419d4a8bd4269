#include "harness/present/scenes/scene_bodies.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "problems/collision/signed_distance.h"

namespace lcp {
namespace {

using namespace collision;

/// Every side of a triangle is one of its neighbour's, the other way round.
void expect_closed(const Mesh& mesh) {
  ASSERT_FALSE(mesh.triangles.empty());
  std::map<std::array<int, 2>, int> sides;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(sides.contains({side[1], side[0]}));
  }
}

TEST(SceneBodies, CornersOfTheSurfacesOfSolidsLieOnThemAndFaceOutwards) {
  for (const Geometry& solid : {Geometry(Sphere{0.3}), Geometry(Capsule{0.1, 0.5}),
                                Geometry(Cylinder{0.2, 0.7}), Geometry(Box{{1, 2, 3}})}) {
    const Mesh mesh = surface_of(solid);
    expect_closed(mesh);
    for (const Vector3d& v : mesh.vertices)
      EXPECT_NEAR(signed_distance(solid, v).distance, 0, 1e-12) << name_of(solid);
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vector3d normal =
          (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
      EXPECT_GE(normal.dot(mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]), 0);
    }
  }
  EXPECT_TRUE(surface_of(HalfSpace{}).triangles.empty());
}

TEST(SceneBodies, AMeshIsItsTriangles) {
  const Mesh mesh = mesh_of(Capsule{1, 1}, 5, 1);
  EXPECT_EQ(surface_of(mesh).triangles, mesh.triangles);
}

TEST(SceneBodies, AWireIsAsThickAsItIsAtItsSharpestCorners) {
  Ring bent{.corners = {}, .radius = 0.02};
  for (int i = 0; i < 4; ++i) {
    const double angle = std::numbers::pi / 2 * i;
    bent.corners.push_back({0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.1 * (i % 3)});
  }
  const Ring hairpin{.corners = {{0, 0, 0}, {1, 0, 0}, {0.001, 0, 0}}, .radius = 0.1};
  for (const Ring& ring : {bent, hairpin}) {
    const Mesh mesh = surface_of(ring);
    expect_closed(mesh);
    for (const Vector3d& v : mesh.vertices) {
      double nearest = 1;
      for (std::size_t i = 0; i < ring.corners.size(); ++i) {
        const Vector3d& from = ring.corners[i];
        const Vector3d along = ring.corners[(i + 1) % ring.corners.size()] - from;
        const double share = std::clamp((v - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, std::abs((v - from - share * along).norm() - ring.radius));
      }
      EXPECT_NEAR(nearest, 0, 1e-9) << v.transpose();
    }
  }
}

TEST(SceneBodies, LinksWithoutAShapeAreBones) {
  SceneSetup setup = make_scene("squat").setup;
  setup.shapes.clear();
  EXPECT_EQ(scene_bodies(setup).size(), 24u) << "20 to the children's joints, 4 at the ends";
}

TEST(SceneBodies, ABoneReachesFromItsJointToTheNext) {
  SceneSetup setup = make_scene("squat").setup;
  setup.shapes.clear();
  const Model& model = setup.system.model;
  for (const SceneBody& bone : scene_bodies(setup)) {
    double nearest = 1;
    const Vector3d end = 2 * bone.in_link.p;
    for (Index i = 0; i < model.size(); ++i) {
      if (model.link(i).parent == bone.link)
        nearest = std::min(nearest, (end - model.link(i).in_parent.p).norm());
      if (i == bone.link) nearest = std::min(nearest, (end - model.link(i).centre).norm());
    }
    EXPECT_NEAR(nearest, 0, 1e-12);
    const Vector3d along = bone.in_link.R.transpose() * end;
    EXPECT_NEAR(along.z(), end.norm(), 1e-12) << "its long side is z";
  }
}

TEST(SceneBodies, AFloorIsTheHalfSpaceBelowZeroAndNoOther) {
  SceneSetup setup = make_scene("squat").setup;
  EXPECT_TRUE(has_floor(setup));
  setup.shapes = {{.geometry = HalfSpace{}}};
  setup.shapes.front().in_link.p.z() = -1;
  EXPECT_FALSE(has_floor(setup));
  setup.shapes.front().in_link = {Eigen::AngleAxisd(0.1, Vector3d::UnitX()).matrix(), {0, 0, 0}};
  EXPECT_FALSE(has_floor(setup));
  EXPECT_EQ(scene_bodies(setup).size(), 24u) << "a slope is not drawn";
}

TEST(SceneBodies, WhatIsFixedInTheWorldStaysWhereItIs) {
  SceneSetup setup = make_scene("squat").setup;
  setup.shapes = {{Box{{1, 1, 1}}, Link::world, {Matrix3d::Identity(), {1, 2, 3}}}};
  EXPECT_EQ(scene_bodies(setup).front().in_world(Snapshot{}).p, Vector3d(1, 2, 3));
}

SceneBody beam(Index link) {
  return {link, {Matrix3d::Identity(), {0.5, 0, 0}}, surface_of(Box{{100, 1, 1}}), 0};
}

Eigen::AlignedBox3d extent(const SceneBody& body) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& v : body.surface.vertices) box.extend(body.in_link * v);
  return box;
}

TEST(SceneBodies, OfABeamOfTheWorldWhatIsNearARegionStaysInPlace) {
  SceneBody body = beam(Link::world);
  keep_near(body, {Vector3d(10, -1, -1), Vector3d(14, 1, 1)});
  EXPECT_NEAR(extent(body).min().x(), 9, 1e-12) << "and 1 m around";
  EXPECT_NEAR(extent(body).max().x(), 15, 1e-12);
  EXPECT_NEAR(extent(body).sizes().y(), 1, 1e-12);
}

TEST(SceneBodies, WhatIsElsewhereOrMovesStaysAsItIs) {
  SceneBody far = beam(Link::world), moving = beam(2);
  keep_near(far, {Vector3d(510, -1, -1), Vector3d(514, 1, 1)});
  keep_near(moving, {Vector3d(10, -1, -1), Vector3d(14, 1, 1)});
  SceneBody alone = beam(Link::world);
  keep_near(alone, {});
  for (const SceneBody& body : {far, moving, alone})
    EXPECT_NEAR(extent(body).sizes().x(), 100, 1e-12);
}

}  // namespace
}  // namespace lcp
