#include "harness/present/scenes/facets.h"

#include <gtest/gtest.h>

#include <random>

#include "harness/present/scenes/surfaces.h"
#include "tests/harness/present/scenes/nearness.h"

namespace lcp {
namespace {

struct Solid {
  collision::Box box;
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
    solids.push_back({{2 * half}, {R, vector()}});
  }
  return solids;
}

std::vector<Facet> faces_of(const std::vector<Solid>& solids, const Vector3d& towards_viewer) {
  std::vector<Facet> faces;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (const Piece& piece :
         seen_from(towards_viewer, pieces_of(solids[i].box), solids[i].pose, i))
      faces.insert(faces.end(), piece.begin(), piece.end());
  return faces;
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
  EXPECT_GT(expect_nearest_on_top(faces, painted, camera, 1.6, 0.0371), 1000);
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

}  // namespace
}  // namespace lcp
