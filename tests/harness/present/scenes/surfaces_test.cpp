#include "harness/present/scenes/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/collision/signed_distance.h"

namespace lcp {
namespace {

using namespace collision;

/// Facets must be flat, turned as their normals say, and enclose a volume: their area vectors
/// cancel.
void expect_closed(const std::vector<Piece>& pieces) {
  Vector3d sum = Vector3d::Zero();
  for (const Piece& piece : pieces)
    for (const Facet& facet : piece) {
      ASSERT_EQ(facet.edge.size(), facet.corners.size());
      Vector3d area = Vector3d::Zero();
      for (std::size_t k = 0; k < facet.corners.size(); ++k) {
        area += facet.corners[k].cross(facet.corners[(k + 1) % facet.corners.size()]) / 2;
        EXPECT_NEAR(facet.normal.dot(facet.corners[k] - facet.corners[0]), 0, 1e-9);
      }
      EXPECT_NEAR(area.dot(facet.normal), area.norm(), 1e-12);
      EXPECT_GT(area.norm(), 0);
      sum += area;
    }
  EXPECT_NEAR(sum.norm(), 0, 1e-12);
}

void expect_on_the_surface(const Geometry& geometry) {
  const std::vector<Piece> pieces = pieces_of(geometry);
  ASSERT_EQ(pieces.size(), 1u) << "convex";
  expect_closed(pieces);
  for (const Facet& facet : pieces.front())
    for (const Vector3d& corner : facet.corners) {
      EXPECT_NEAR(signed_distance(geometry, corner).distance, 0, 1e-12) << name_of(geometry);
      EXPECT_GE(facet.normal.dot(corner), 0) << "turned inwards";
    }
}

TEST(Surfaces, CornersOfSolidsLieOnThem) {
  expect_on_the_surface(Sphere{0.3});
  expect_on_the_surface(Capsule{0.1, 0.5});
  expect_on_the_surface(Capsule{0.1, 0});
  expect_on_the_surface(Cylinder{0.2, 0.7});
  expect_on_the_surface(Box{{1, 2, 3}});
  EXPECT_TRUE(pieces_of(HalfSpace{}).empty());
}

Ring polygon(int corners, double radius, double wire) {
  Ring ring{.corners = {}, .radius = wire};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return ring;
}

TEST(Surfaces, AWireIsAPrismPerSegmentWhoseCornersLieOnItsTube) {
  for (const int corners : {3, 4, 12}) {
    const Ring ring = polygon(corners, 0.5, 0.02);
    const std::vector<Piece> pieces = pieces_of(ring);
    ASSERT_EQ(pieces.size(), ring.corners.size());
    expect_closed(pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Vector3d& from = ring.corners[i];
      const Vector3d along = (ring.corners[(i + 1) % ring.corners.size()] - from).normalized();
      for (const Facet& facet : pieces[i])
        for (const Vector3d& corner : facet.corners)
          EXPECT_NEAR((corner - from).cross(along).norm(), ring.radius, 1e-12);
    }
  }
}

TEST(Surfaces, AFinelyDividedWireHasFewerPiecesAndKeepsSharpCorners) {
  const std::size_t pieces = pieces_of(polygon(256, 0.5, 0.02)).size();
  EXPECT_GT(pieces, 16u);
  EXPECT_LT(pieces, 30u);
  Ring square{.corners = {}, .radius = 0.02};
  const Ring corners = polygon(4, 0.5, 0.02);
  for (std::size_t i = 0; i < 4; ++i)
    for (const double share : {0.0, 0.3, 0.9})
      square.corners.push_back((1 - share) * corners.corners[i] +
                               share * corners.corners[(i + 1) % 4]);
  EXPECT_EQ(pieces_of(square).size(), 4u);
}

TEST(Surfaces, AWireOutOfThePlaneAndOneTooShortForMitresStayFinite) {
  Ring bent = polygon(8, 0.5, 0.02);
  for (std::size_t i = 0; i < 8; ++i) bent.corners[i].z() = 0.1 * std::sin(2.0 * double(i));
  const Ring hairpin{.corners = {{0, 0, 0}, {1, 0, 0}, {0.001, 0, 0}}, .radius = 0.1};
  for (const Ring& ring : {bent, hairpin})
    for (const Piece& piece : pieces_of(ring))
      for (const Facet& facet : piece)
        for (const Vector3d& corner : facet.corners) {
          ASSERT_TRUE(corner.allFinite());
          EXPECT_LT(corner.norm(), bounding_radius(ring) + 2 * ring.radius);
        }
}

TEST(Surfaces, AnUprightBoxShowsItsTopAndTwoSides) {
  const Vector3d viewer(0.8, 0.4, 0.3);
  const auto seen = seen_from(viewer, pieces_of(Box{{1, 2, 3}}), Pose{}, 7);
  ASSERT_EQ(seen.size(), 1u);
  ASSERT_EQ(seen.front().size(), 3u);
  for (const Facet& face : seen.front()) {
    EXPECT_EQ(face.body, 7u);
    EXPECT_NEAR(face.normal.maxCoeff(), 1, 1e-15);  // front, left and top
    for (const bool edge : face.edge) EXPECT_TRUE(edge);
  }
}

std::size_t edges(const std::vector<Piece>& pieces) {
  std::size_t count = 0;
  for (const Piece& piece : pieces)
    for (const Facet& facet : piece)
      count += std::count(facet.edge.begin(), facet.edge.end(), true);
  return count;
}

TEST(Surfaces, RoundBodiesHaveAnOutlineAndNoOtherEdges) {
  const std::vector<Piece> sphere = pieces_of(Sphere{1});
  EXPECT_EQ(edges(sphere), 0u);
  const auto seen = seen_from({0, 0, 1}, sphere, Pose{}, 0);
  EXPECT_EQ(edges(seen), 12u) << "once around";
  // Of a ring both borders, and no line where segments meet.
  const auto ring = seen_from({0, 0, 1}, pieces_of(polygon(12, 0.5, 0.02)), Pose{}, 0);
  EXPECT_EQ(edges(ring), 24u);
}

TEST(Surfaces, AMeshIsItsTrianglesWithEdgesWhereItIsCreased) {
  const Mesh roof{.vertices = {{0, 0, 1}, {1, 0, 1}, {0, 1, 0}, {1, 1, 0}, {0, -1, 1}},
                  .triangles = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}}};
  const std::vector<Piece> pieces = pieces_of(roof);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(edges(pieces), 2u) << "the ridge, from both sides";
}

}  // namespace
}  // namespace lcp
