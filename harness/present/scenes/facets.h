#pragma once

#include <vector>

#include "problems/rigid/spatial.h"

namespace lcp {

/// A flat convex piece of a body's surface, seen from its front.
struct Facet {
  std::vector<Vector3d> corners;  ///< World, m, counterclockwise.
  std::vector<bool> edge;         ///< Corner k to the next is an edge of the body and no mere cut.
  Vector3d normal;                ///< Unit, out of the body.
  std::size_t body = 0;           ///< What it belongs to.
  bool smooth = false;            ///< Approximates a round surface.
};

/// Orders facets so that each may be painted over those before it, whatever stands in or behind
/// another; cuts those that no order would serve.
///
/// Binary space partition. Source: H. Fuchs, Z. Kedem, B. Naylor, "On Visible Surface Generation by
/// A Priori Tree Structures", SIGGRAPH 1980.
std::vector<Facet> back_to_front(std::vector<Facet> facets, const Vector3d& towards_viewer);

}  // namespace lcp
