#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "problems/rigid/model.h"

namespace lcp::collision {

// Shapes in their own frames: centre at the origin, axes along z. All lengths in m.

/// All points with z <= 0. It may not touch another half-space.
struct HalfSpace {};

struct Sphere {
  double radius = 0;  ///< > 0.
};

/// Points nearer than `radius` to the segment from -length/2 to length/2 on the z axis.
struct Capsule {
  double radius = 0;  ///< > 0.
  double length = 0;  ///< Of the segment, >= 0: without the half spheres at the ends.
};

/// A closed wire: points nearer than `radius` to the closed polyline through `corners`.
struct Ring {
  std::vector<Vector3d> corners;  ///< 3 ... ring_corners_limit, neighbours at different places.
  double radius = 0;              ///< > 0, of the wire.
};

struct Box {
  Vector3d edges = Vector3d::Zero();  ///< > 0.
};

struct Cylinder {
  double radius = 0;  ///< > 0.
  double length = 0;  ///< > 0.
};

/// The surface of a body as triangles, counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< Indices of three different vertices.
};

/// In the order in which colliders take them: the first of a pair comes before the second.
using Geometry = std::variant<HalfSpace, Sphere, Capsule, Ring, Box, Cylinder, Mesh>;

inline constexpr Index ring_corners_limit = 1024;

/// A geometry that is fixed to a link.
struct Shape {
  Geometry geometry;
  Index link = Link::world;  ///< Link::world where it stands still.
  Pose in_link = {};         ///< The shape's frame in the link's.
};

/// "sphere", "box", ...
const char* name_of(const Geometry& geometry);

/// Throws std::invalid_argument unless sizes are finite and in the ranges above, indices name
/// vertices, the frame is a rotation at a finite place and the link is the world or >= 0. `where`
/// begins the message.
void check(const Shape& shape, const std::string& where);

/// Radius about the origin of the shape's frame within which it lies; infinite for a half-space.
double bounding_radius(const Geometry& geometry);

/// The wire as tubes of `around` facets, one from corner to corner: 2 `around` triangles a segment.
/// Its vertices lie on the wire's surface, so that its facets lie within. Throws
/// std::invalid_argument when `around` is less than 3.
Mesh mesh_of(const Ring& ring, Index around);

/// The same of a capsule, whose half spheres have `rings` of facets each. Throws
/// std::invalid_argument when `around` is less than 3 or `rings` less than 1.
Mesh mesh_of(const Capsule& capsule, Index around, Index rings);

/// The same of a cylinder, with flat ends. Throws std::invalid_argument when `around` is less than
/// 3.
Mesh mesh_of(const Cylinder& cylinder, Index around);

/// The same of a box, each face of `divisions`^2 rectangles. Throws std::invalid_argument when
/// there are less than 1.
Mesh mesh_of(const Box& box, Index divisions);

}  // namespace lcp::collision
