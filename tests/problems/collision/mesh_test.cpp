// Triangle meshes of rings and capsules, and their contacts next to those of the shapes themselves.

#include <gtest/gtest.h>

#include <map>

#include "tests/problems/collision/collision_cases.h"

namespace lcp {
namespace {

using namespace collision;

using cases::Solid;

constexpr double kRadius = 0.02;  // m, of the rings
constexpr double kWire = 0.0015;  // m

Ring wire_ring() { return cases::round_ring(kRadius, kWire, 64); }

/// By the divergence theorem: positive where triangles are counter-clockwise seen from outside.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
  return sum;
}

/// Every edge belongs to two triangles that run along it in opposite directions.
void expect_closed(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const auto& edge : {std::pair(a, b), {b, c}, {c, a}}) ++edges[edge];
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

TEST(Mesh, OfARingIsClosedAndHasItsVolume) {
  const Mesh mesh = mesh_of(wire_ring(), 16);
  EXPECT_EQ(mesh.vertices.size(), 64 * 16);
  EXPECT_EQ(mesh.triangles.size(), 2 * 64 * 16);
  expect_closed(mesh);
  const double torus = 2 * std::numbers::pi * kRadius * std::numbers::pi * kWire * kWire;
  EXPECT_NEAR(volume(mesh), torus, 0.03 * torus);
}

TEST(Mesh, OfARingThatIsNotPlaneIsClosedAndHasItsVolume) {
  // Wound three times around a circle: a section carried along comes back turned.
  constexpr Index corners = 128, around = 16;
  Ring ring = cases::round_ring(kRadius, kWire, corners);
  double length = 0;
  for (Index k = 0; k < corners; ++k) {
    const double turn = 3 * 2 * std::numbers::pi * static_cast<double>(k) / corners;
    ring.corners[k] *= 1 + 0.25 * std::cos(turn);
    ring.corners[k].z() = 0.25 * kRadius * std::sin(turn);
  }
  const auto segment = [&](Index k) {
    return (ring.corners[k] - ring.corners[(k + 1) % corners]).norm();
  };
  for (Index k = 0; k < corners; ++k) length += segment(k);
  const Mesh mesh = mesh_of(ring, around);
  expect_closed(mesh);
  const double wire = length * std::numbers::pi * kWire * kWire;
  EXPECT_NEAR(volume(mesh), wire, 0.05 * wire);
  for (Index i = 0; i < corners; ++i) {
    for (Index k = 0; k < around; ++k) {
      const Vector3d &here = mesh.vertices[around * i + k],
                     &next = mesh.vertices[around * ((i + 1) % corners) + k];
      EXPECT_NEAR((here - ring.corners[i]).norm(), kWire, 1e-12);
      // Nowhere twisted: facets run along the wire.
      EXPECT_NEAR((next - here).norm(), segment(i), 0.3 * kWire);
    }
  }
}

TEST(Mesh, OfACapsuleIsClosedAndHasItsVolume) {
  const Mesh mesh = mesh_of(Capsule{0.01, 0.05}, 32, 8);
  expect_closed(mesh);
  const double capsule = std::numbers::pi * 1e-4 * (0.05 + 4.0 / 3 * 0.01);
  EXPECT_NEAR(volume(mesh), capsule, 0.02 * capsule);
  EXPECT_LT(volume(mesh), capsule);
  EXPECT_NEAR(bounding_radius(mesh), 0.035, 1e-12);
}

TEST(Mesh, OfACylinderIsClosedAndHasItsVolume) {
  const Mesh mesh = mesh_of(Cylinder{0.01, 0.05}, 32);
  expect_closed(mesh);
  const double cylinder = std::numbers::pi * 1e-4 * 0.05;
  EXPECT_NEAR(volume(mesh), cylinder, 0.01 * cylinder);
  EXPECT_LT(volume(mesh), cylinder);
}

TEST(Mesh, RefusesTooFewFacets) {
  EXPECT_THROW(mesh_of(wire_ring(), 2), std::invalid_argument);
  EXPECT_THROW(mesh_of(Capsule{0.01, 0.05}, 2, 4), std::invalid_argument);
  EXPECT_THROW(mesh_of(Capsule{0.01, 0.05}, 8, 0), std::invalid_argument);
  EXPECT_THROW(mesh_of(Cylinder{0.01, 0.05}, 2), std::invalid_argument);
}

/// All of the mesh's points lie near one of the shape's own, and their normals are at most
/// `angle` from its.
void expect_dirty(const std::vector<ContactPoint>& mesh, const std::vector<ContactPoint>& clean,
                  double distance, double angle) {
  ASSERT_FALSE(clean.empty());
  EXPECT_GT(mesh.size(), clean.size());
  for (const ContactPoint& point : mesh) {
    const auto near = std::find_if(clean.begin(), clean.end(), [&](const ContactPoint& other) {
      return (point.position - other.position).norm() <= distance &&
             point.normal.dot(other.normal) >= std::cos(angle);
    });
    EXPECT_NE(near, clean.end()) << point.position.transpose() << ", normal "
                                 << point.normal.transpose();
    EXPECT_NEAR(point.normal.norm(), 1, 1e-12);
    EXPECT_EQ(point.id.body1, clean.front().id.body1);
    EXPECT_EQ(point.id.body2, clean.front().id.body2);
  }
}

TEST(MeshOnMesh, RingsHaveMorePointsAroundTheOneTheyShare) {
  const Pose threaded =
      cases::turned_about(Vector3d::UnitX(), 1.4, {2 * kRadius - 2 * kWire + 3e-4, 0.0004, 0.0003});
  const auto clean = cases::contacts_of({wire_ring(), threaded}, {wire_ring(), {}});
  const auto dirty =
      cases::contacts_of({mesh_of(wire_ring(), 12), threaded}, {mesh_of(wire_ring(), 12), {}});
  expect_dirty(dirty, clean, 4e-3, 1.2);
}

TEST(MeshOnSolid, RingHasMorePointsOnACylinderAndOnABox) {
  Pose hanging = cases::turned_about(Vector3d::UnitX(), std::numbers::pi / 2, Vector3d::Zero());
  const Pose rod = hanging;
  hanging.p.z() = -(kRadius - kWire - 0.005 + 2e-4);
  const Solid clean{wire_ring(), hanging}, dirty{mesh_of(wire_ring(), 12), hanging};
  const Solid cylinder{Cylinder{0.005, 0.1}, rod};
  expect_dirty(cases::contacts_of(dirty, cylinder), cases::contacts_of(clean, cylinder), 4e-3, 1.2);
  const Solid box{Box{{0.1, 0.1, 0.1}}, {Matrix3d::Identity(), {0, 0, -0.05 - kRadius - kWire}}};
  Solid above_clean = clean, above_dirty = dirty;
  above_clean.pose.p.z() = above_dirty.pose.p.z() = -1e-4;
  expect_dirty(cases::contacts_of(above_dirty, box), cases::contacts_of(above_clean, box), 6e-3,
               1.2);
}

class MeshOn : public testing::TestWithParam<const char*> {};

TEST_P(MeshOn, SolidGivesPointsThatLieOnBoth) {
  cases::Uniform uniform(31);
  const Geometry mesh = mesh_of(wire_ring(), 12);
  int poses = 0, points = 0, far_away = 0;
  for (int pose = 0; pose < 60; ++pose) {
    const Solid solid{cases::random_geometry(GetParam(), uniform), Pose{}};
    Solid ring{wire_ring(), cases::random_pose(uniform)};
    const Vector3d away = cases::random_vector(uniform).normalized();
    const double depth = uniform.between(2e-4, 5e-4);
    double near = 0, far = 0.2;
    for (int k = 0; k < 20; ++k) {
      const double middle = (near + far) / 2;
      ring.pose.p = middle * away;
      const auto clean = cases::contacts_of(ring, solid);
      (!clean.empty() && clean.front().depth > depth ? near : far) = middle;
    }
    const auto clean = cases::contacts_of(ring, solid);
    if (clean.empty() || clean.front().depth < depth / 2) continue;
    ++poses;
    const auto dirty = cases::contacts_of({mesh, ring.pose}, solid);
    EXPECT_GT(dirty.size(), clean.size()) << pose;
    for (const ContactPoint& point : dirty) {
      ++points;
      const Solid here{Sphere{1e-9}, {Matrix3d::Identity(), point.position}};
      const Solid near_by{Sphere{kWire / 2}, here.pose};
      const double beyond_surface = std::abs(cases::exact_overlap(here, solid).depth);
      far_away += beyond_surface > kWire || cases::contacts_of(ring, near_by).empty();
    }
  }
  EXPECT_GT(poses, 25);
  EXPECT_GT(points, 10 * poses);
  EXPECT_LE(far_away, points / 100);
}

INSTANTIATE_TEST_SUITE_P(Kinds, MeshOn, testing::Values("sphere", "capsule", "box", "cylinder"),
                         [](const auto& kind) { return std::string(kind.param); });

TEST(MeshOnSolid, ExchangedGivesOppositeNormals) {
  const Solid sphere{Sphere{0.01}, {Matrix3d::Identity(), {0, 0, 0.0199}}};
  const Solid capsule{
      mesh_of(Capsule{0.01, 0.04}, 16, 4),
      cases::turned_about(Vector3d::UnitY(), std::numbers::pi / 2, Vector3d::Zero())};
  const auto one = cases::contacts_of(sphere, capsule), other = cases::contacts_of(capsule, sphere);
  ASSERT_FALSE(one.empty());
  ASSERT_EQ(one.size(), other.size());
  EXPECT_GT(one[0].normal.z(), 0.7);
  EXPECT_LT(other[0].normal.z(), -0.7);
}

TEST(MeshOnFloor, TouchesVerticesBelow) {
  World world({{HalfSpace{}}, {mesh_of(Capsule{0.01, 0.04}, 16, 4), 0}});
  const auto points = world.contacts(cases::links_at({{Matrix3d::Identity(), {0, 0, 0.0299}}}));
  ASSERT_EQ(points.size(), 1);
  EXPECT_NEAR(points[0].depth, 1e-4, 1e-15);
}

}  // namespace
}  // namespace lcp
