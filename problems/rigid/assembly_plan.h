#pragma once

#include <vector>

#include "problems/rigid/model.h"

namespace lcp {

/// A body of an assembly: a link by its number, or, negative, a copy of the world. As the world never
/// moves, each joint to it may have a copy of its own, which keeps apart what only the world connects.
inline bool is_world(Index body) { return body < 0; }

/// A part of the system: a body, two parts and the joint between them, or a part and a joint that
/// closes a loop in it. `open` are the bodies that later joints or callers still push.
struct AssemblyPart {
  Index left = -1, right = -1;    ///< Parts joined; both -1 for a body, right alone for a loop.
  Index joint = -1;               ///< That was closed: of link i, or of loop i - (number of links).
  bool redundant = false;         ///< The joint may hold what already is held.
  std::vector<Index> open;        ///< Bodies.
  std::vector<Index> merged;      ///< Open bodies of left, then of right.
  std::vector<Index> kept;        ///< Places in `merged` of `open`.
  Index parent = -1, child = -1;  ///< Places in `merged` of the joint's bodies.

  bool is_body() const { return left < 0; }
};

/// The order in which a system is assembled.
struct AssemblyPlan {
  std::vector<AssemblyPart> parts;  ///< Each after its own parts.
  std::vector<Index> roots;         ///< Parts that belong to no other.
};

/// Orders the joints into balanced trees of parts, one for each set of bodies that joints connect; a
/// loop is closed in the first part that holds both its links. `handles` are links that stay open.
/// Cost: O((links + loops)^3), once.
AssemblyPlan plan_assembly(const Model& model, const std::vector<Index>& handles);

}  // namespace lcp
