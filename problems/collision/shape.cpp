#include "problems/collision/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/errors.h"

namespace lcp::collision {

namespace {

/// Says what is wrong with a geometry; empty where nothing is.
struct Complaint {
  std::string operator()(const HalfSpace&) const { return {}; }
  std::string operator()(const Sphere& sphere) const { return of_size("radius", sphere.radius); }
  std::string operator()(const Capsule& capsule) const {
    if (!(capsule.length >= 0) || !std::isfinite(capsule.length))
      return fmt::format("length is {} m, expected 0 or more", capsule.length);
    return of_size("radius", capsule.radius);
  }
  std::string operator()(const Ring& ring) const {
    const std::size_t count = ring.corners.size();
    if (count < 3 || count > static_cast<std::size_t>(ring_corners_limit))
      return fmt::format("has {} corners, expected 3 ... {}", count, ring_corners_limit);
    for (std::size_t i = 0; i < count; ++i) {
      if (!ring.corners[i].allFinite()) return fmt::format("corner {} is not finite", i);
      if (ring.corners[i] == ring.corners[(i + 1) % count])
        return fmt::format("corner {} is at the place of the next", i);
    }
    return of_size("radius", ring.radius);
  }
  std::string operator()(const Box& box) const {
    for (const double edge : box.edges)
      if (std::string wrong = of_size("edge", edge); !wrong.empty()) return wrong;
    return {};
  }
  std::string operator()(const Cylinder& cylinder) const {
    std::string wrong = of_size("radius", cylinder.radius);
    return wrong.empty() ? of_size("length", cylinder.length) : wrong;
  }
  std::string operator()(const Mesh& mesh) const {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      if (!mesh.vertices[i].allFinite()) return fmt::format("vertex {} is not finite", i);
    if (mesh.triangles.empty()) return "has no triangles";
    const int count = static_cast<int>(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh.triangles[i];
      if (std::min({a, b, c}) < 0 || std::max({a, b, c}) >= count || a == b || b == c || c == a)
        return fmt::format("triangle {} is ({}, {}, {}), expected three of the {} vertices", i, a,
                           b, c, count);
    }
    return {};
  }

  static std::string of_size(const char* name, double value) {
    if (value > 0 && std::isfinite(value)) return {};
    return fmt::format("{} is {} m, expected a positive length", name, value);
  }
};

double farthest(const std::vector<Vector3d>& points) {
  double radius = 0;
  for (const Vector3d& point : points) radius = std::max(radius, point.norm());
  return radius;
}

struct BoundingRadius {
  double operator()(const HalfSpace&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Capsule& capsule) const { return capsule.radius + capsule.length / 2; }
  double operator()(const Ring& ring) const { return ring.radius + farthest(ring.corners); }
  double operator()(const Box& box) const { return box.edges.norm() / 2; }
  double operator()(const Cylinder& cylinder) const {
    return std::hypot(cylinder.radius, cylinder.length / 2);
  }
  double operator()(const Mesh& mesh) const { return farthest(mesh.vertices); }
};

}  // namespace

const char* name_of(const Geometry& geometry) {
  constexpr const char* names[] = {"half-space", "sphere",   "capsule", "ring",
                                   "box",        "cylinder", "mesh"};
  static_assert(std::size(names) == std::variant_size_v<Geometry>);
  return names[geometry.index()];
}

void check(const Shape& shape, const std::string& where) {
  std::string wrong = std::visit(Complaint{}, shape.geometry);
  if (wrong.empty() && shape.link < Link::world)
    wrong = fmt::format("link is {}, expected -1 (the world) or more", shape.link);
  if (wrong.empty() && !shape.in_link.p.allFinite()) wrong = "place in the link is not finite";
  if (wrong.empty() && !is_rotation(shape.in_link.R)) wrong = "frame in the link is not a rotation";
  if (!wrong.empty()) throw InvalidArgument("{}: {}: {}", where, name_of(shape.geometry), wrong);
}

double bounding_radius(const Geometry& geometry) { return std::visit(BoundingRadius{}, geometry); }

}  // namespace lcp::collision
