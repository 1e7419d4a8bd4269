#pragma once

#include <vector>

#include "harness/present/scenes/camera.h"
#include "harness/present/scenes/surfaces.h"

namespace lcp {

/// Facets to be painted one after another.
struct Coat {
  Piece facets;
  bool whole = false;  ///< One convex piece, no facet of which hides another.
};

/// Orders what is seen of convex pieces so that each may be painted over those before it. A piece
/// is painted whole where it can be. Those that pierce one another, or each of which hides the next
/// round in a circle, are cut as back_to_front does; round pieces that overlap, as at a joint, are
/// not: the nearer is painted over the other. Boxes alone are few facets, and left to back_to_front
/// together. Cost: O(pieces^2).
///
/// Source of the comparison of pairs: M. Newell, R. Newell, T. Sancha, "A Solution to the Hidden
/// Surface Problem", ACM Annual Conference 1972; here at the corners of what two pieces share of
/// the picture.
std::vector<Coat> painting_order(std::vector<Piece> pieces, const Camera& camera);

}  // namespace lcp
