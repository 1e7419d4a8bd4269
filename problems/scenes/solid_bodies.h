#pragma once

#include <functional>
#include <vector>

#include "problems/collision/collision.h"
#include "problems/contact/reduction.h"
#include "problems/rigid/model.h"

namespace lcp {

/// Inertia about the origin of the shape's frame, in its axes (kg m^2), of a body of that mass (kg)
/// spread evenly over its volume; of a ring along its wire, as discs on the centre line. Throws
/// std::invalid_argument for half-spaces and meshes, which have no volume of their own.
Matrix3d solid_inertia(const collision::Geometry& geometry, double mass);

/// Which surfaces touch.
enum class Surfaces {
  exact,  ///< The shapes'.
  mesh,   ///< Triangles in their place, as a detector for general polygonal objects sees them.
};

/// Facets around a round surface that is turned into triangles.
inline constexpr Index kFacetsAround = 6;

/// The rule by which the shapes of a scene touch one another, all but those of excluded pairs of
/// links. As a mesh a face of a box has `divisions`^2 rectangles; half-spaces stay what they are.
std::function<std::vector<ContactPoint>(const Kinematics&)> touching(
    std::vector<collision::Shape> shapes, std::vector<collision::LinkPair> excluded,
    Surfaces surfaces, Index divisions = 1);

}  // namespace lcp
