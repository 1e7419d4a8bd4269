#pragma once

#include <vector>

#include "harness/present/scenes/surfaces.h"

namespace lcp {

struct PlacedGeometry {
  const collision::Geometry* geometry;
  Pose pose;  ///< In the world.
};

/// Leaves out facets of round surfaces that lie within other bodies, as half of what capsules have
/// where they meet at a joint; of two that share such a surface the first body keeps it.
/// Facet::body is a place in `bodies`.
void drop_hidden(std::vector<Piece>& pieces, const std::vector<PlacedGeometry>& bodies);

}  // namespace lcp
