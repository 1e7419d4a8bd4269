#pragma once

#include <vector>

#include "harness/present/scenes/facets.h"
#include "problems/collision/shape.h"

namespace lcp {

/// Facets of a convex part of a body.
using Piece = std::vector<Facet>;

/// The surface of a shape in its own frame, as convex pieces: a ring in its segments, a mesh in its
/// triangles, others in one. Corners of what stands for a round surface lie on it; wires are mitred,
/// and leave out corners at which they hardly bend. None for a half-space.
std::vector<Piece> pieces_of(const collision::Geometry& geometry);

/// The facets of one body, in the frame `pose`, whose fronts a viewer in the direction
/// `towards_viewer`, far away, sees. Borders between what is seen and what is not become edges.
std::vector<Piece> seen_from(const Vector3d& towards_viewer, const std::vector<Piece>& pieces,
                             const Pose& pose, std::size_t body);

}  // namespace lcp
