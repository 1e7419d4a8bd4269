#include "harness/pictures/facets.h"

#include <gtest/gtest.h>

#include <random>

#include "harness/pictures/camera.h"

namespace lcp {
namespace {

struct Solid {
  Vector3d low, high;
  Pose pose;
};

std::vector<Solid> heap_of_boxes(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> draw(-1, 1);
  const auto vector = [&] { return Vector3d(draw(random), draw(random), draw(random)); };
  std::vector<Solid> solids;
  for (int i = 0; i < count; ++i) {
    const Vector3d half = 0.5 * vector().cwiseAbs() + Vector3d::Constant(0.05);
    const Matrix3d R = Eigen::Quaterniond(draw(random), draw(random), draw(random), 1)
                           .normalized()
                           .toRotationMatrix();
    solids.push_back({-half, half, {R, vector()}});
  }
  return solids;
}

std::vector<Facet> faces_of(const std::vector<Solid>& solids, const Vector3d& towards_viewer) {
  std::vector<Facet> faces;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (const Facet& face :
         visible_faces(solids[i].low, solids[i].high, solids[i].pose, towards_viewer, i))
      faces.push_back(face);
  return faces;
}

/// How near to the viewer the facet is where the viewer sees `at`; nothing beside it.
std::optional<double> nearness(const Facet& facet, const Camera& camera,
                               const Eigen::Vector2d& at) {
  const std::size_t count = facet.corners.size();
  bool left = true, right = true;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector2d a = camera.flat(facet.corners[k]);
    const Eigen::Vector2d b = camera.flat(facet.corners[(k + 1) % count]);
    const double turn = (b - a).x() * (at - a).y() - (b - a).y() * (at - a).x();
    left &= turn > 0;
    right &= turn < 0;
  }
  if (!left && !right) return std::nullopt;
  const Vector3d start = at.x() * camera.right + at.y() * camera.up;
  return facet.normal.dot(facet.corners.front() - start) / facet.normal.dot(camera.towards_viewer);
}

double area(const std::vector<Facet>& facets) {
  double sum = 0;
  for (const Facet& facet : facets)
    for (std::size_t k = 1; k + 1 < facet.corners.size(); ++k)
      sum += (facet.corners[k] - facet.corners[0])
                 .cross(facet.corners[k + 1] - facet.corners[0])
                 .norm() /
             2;
  return sum;
}

TEST(Facets, WhatIsPaintedLastIsNearestInAHeapOfBoxesThatPierceOneAnother) {
  const Camera camera = Camera::from(-0.9, 0.3);
  const std::vector<Facet> faces = faces_of(heap_of_boxes(12), camera.towards_viewer);
  const std::vector<Facet> painted = back_to_front(faces, camera.towards_viewer);
  EXPECT_GT(painted.size(), faces.size()) << "nothing had to be cut";
  int seen = 0;
  for (double x = -1.6; x < 1.6; x += 0.0371)
    for (double y = -1.6; y < 1.6; y += 0.0371) {
      std::optional<double> nearest, last;
      for (const Facet& face : faces) {
        const std::optional<double> here = nearness(face, camera, {x, y});
        if (here && (!nearest || *here > *nearest)) nearest = here;
      }
      for (const Facet& facet : painted)
        if (const std::optional<double> here = nearness(facet, camera, {x, y})) last = here;
      ASSERT_EQ(nearest.has_value(), last.has_value()) << x << ' ' << y;
      if (!nearest) continue;
      ASSERT_NEAR(*last, *nearest, 1e-6) << x << ' ' << y;
      ++seen;
    }
  EXPECT_GT(seen, 1000);
}

TEST(Facets, CuttingKeepsTheAreaAndTheEdges) {
  const Camera camera = Camera::from(0.4, 0.2);
  const std::vector<Facet> faces = faces_of(heap_of_boxes(6), camera.towards_viewer);
  const std::vector<Facet> painted = back_to_front(faces, camera.towards_viewer);
  EXPECT_NEAR(area(painted), area(faces), 1e-9);
  const auto edges = [](const std::vector<Facet>& facets) {
    double length = 0;
    for (const Facet& facet : facets)
      for (std::size_t k = 0; k < facet.corners.size(); ++k)
        if (facet.edge[k])
          length += (facet.corners[(k + 1) % facet.corners.size()] - facet.corners[k]).norm();
    return length;
  };
  EXPECT_NEAR(edges(painted), edges(faces), 1e-9);
}

TEST(Facets, AnUprightBoxShowsItsTopAndTwoSides) {
  const Camera camera = Camera::from(0.5, 0.3);
  const std::vector<Facet> faces =
      visible_faces({0, 0, 0}, {1, 2, 3}, Pose{}, camera.towards_viewer, 7);
  ASSERT_EQ(faces.size(), 3u);
  for (const Facet& face : faces) {
    EXPECT_EQ(face.box, 7u);
    EXPECT_EQ(face.normal.maxCoeff(), 1);  // front, left and top
    const Vector3d turn =
        (face.corners[1] - face.corners[0]).cross(face.corners[2] - face.corners[1]);
    EXPECT_GT(turn.dot(face.normal), 0) << "not counterclockwise";
  }
}

}  // namespace
}  // namespace lcp
