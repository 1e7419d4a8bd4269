#include "harness/present/scenes/hidden_facets.h"

#include <gtest/gtest.h>

namespace lcp {
namespace {

using collision::Geometry;

/// Facets of each body that a viewer sees from +x, before and after.
struct Count {
  std::vector<std::size_t> before, after;
};

Count count(const std::vector<Geometry>& geometries, const std::vector<Vector3d>& places) {
  std::vector<PlacedGeometry> bodies;
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    bodies.push_back({&geometries[i], {Matrix3d::Identity(), places[i]}});
    for (const Piece& piece :
         seen_from({1, 0.1, 0.05}, pieces_of(geometries[i]), bodies.back().pose, i))
      pieces.push_back(piece);
  }
  const auto facets = [&] {
    std::vector<std::size_t> found(geometries.size(), 0);
    for (const Piece& piece : pieces)
      for (const Facet& facet : piece) ++found[facet.body];
    return found;
  };
  Count counted{.before = facets(), .after = {}};
  drop_hidden(pieces, bodies);
  counted.after = facets();
  return counted;
}

TEST(HiddenFacets, OfTwoCapsulesInARowOneKeepsTheHalfSphereBetween) {
  const collision::Capsule capsule{0.1, 0.5};
  const Count facets = count({capsule, capsule}, {{0, 0, 0}, {0, 0, 0.5}});
  EXPECT_LT(facets.after[1], facets.before[1] - 4);
  EXPECT_GT(facets.after[0], facets.after[1]) << "the first keeps what both share";
}

TEST(HiddenFacets, WhatIsInsideAnotherVanishesAndWhatTouchesStays) {
  const Count inside =
      count({collision::Box{{1, 1, 1}}, collision::Sphere{0.3}}, {{0, 0, 0}, {0.1, 0, 0}});
  EXPECT_EQ(inside.after[1], 0u);
  EXPECT_EQ(inside.after[0], inside.before[0]);
  const Count beside =
      count({collision::Box{{1, 1, 1}}, collision::Sphere{0.3}}, {{0, 0, 0}, {0, 0, 0.8}});
  EXPECT_EQ(beside.after, beside.before);
}

TEST(HiddenFacets, BoxesAndWhatIsBehindRingsStay) {
  const collision::Ring ring{.corners = {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, .radius = 0.5};
  const Count facets =
      count({ring, collision::Sphere{0.1}, collision::Sphere{2}, collision::Box{{0.1, 0.1, 0.1}}},
            {{0, 0, 0}, {1, 0, 0}, {9, 9, 9}, {9, 9, 9}});
  EXPECT_EQ(facets.after, facets.before);
}

}  // namespace
}  // namespace lcp
