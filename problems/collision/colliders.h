#pragma once

#include <vector>

#include "problems/collision/shape.h"

namespace lcp::collision {

/// A point at which two shapes overlap.
struct Touch {
  Vector3d position;  ///< m: middle of the overlap, in the world.
  Vector3d normal;    ///< Unit, from the second shape to the first.
  double depth = 0;   ///< m, >= 0.
  Index feature = 0;  ///< Of this pair of shapes: 0 ... features_per_pair - 1.
};

/// As many as there are pairs of corners of two rings.
inline constexpr Index features_per_pair = ring_corners_limit * ring_corners_limit;

/// A shape where it is at one instant.
struct Placed {
  const Geometry* geometry = nullptr;
  Pose pose = {};                      ///< In the world.
  std::vector<Vector3d> corners = {};  ///< Of a ring, in the world.
};

/// Appends the points at which two shapes touch.
using Collider = void (*)(const Placed& first, const Placed& second, std::vector<Touch>& touches);

/// Half-space on anything but another: exact. Vertices of boxes and meshes, both ends of a capsule,
/// corners of a ring; of a cylinder the lowest point of either rim, and of the lower rim also the
/// points a quarter and half a turn from there, which are what it stands on.
void half_space_on_solid(const Placed& half_space, const Placed& solid,
                         std::vector<Touch>& touches);

/// Sphere or capsule on sphere, capsule, box or cylinder. The depth is exact as long as the axis of
/// the first does not enter the second (its axis, where that is a capsule); deeper, it is that of
/// the axis' deepest point. Features: 0 and 1 near the ends of the first, 2 between.
///
/// One point, where they are deepest; two where the axis runs along the surface of the other for
/// more than its own radius, at the ends of that stretch. A third where they are deeper between.
void capsule_on_solid(const Placed& capsule, const Placed& solid, std::vector<Touch>& touches);

/// Ring on sphere, capsule, ring, box or cylinder: one point for every local minimum of the
/// distance between the wire and the other, over the wire's segments (and the other ring's).
void ring_on_solid(const Placed& ring, const Placed& solid, std::vector<Touch>& touches);
void ring_on_ring(const Placed& first, const Placed& second, std::vector<Touch>& touches);

/// Box or cylinder on box or cylinder: in the exact direction of least overlap, the points that the
/// faces turned to each other have in common; faces within a degree of flat are. The deepest
/// point is as deep as the solids overlap (for overlaps much smaller than the solids).
/// Features count the points.
void convex_on_convex(const Placed& first, const Placed& second, std::vector<Touch>& touches);

}  // namespace lcp::collision
