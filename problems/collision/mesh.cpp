
#include <cmath>
#include <map>
#include <numbers>

#include "problems/collision/shape.h"
#include "solvers/errors.h"

namespace lcp::collision {

namespace {

constexpr Index kLeastFacets = 3;

void require_at_least(Index least, Index count, const char* name) {
  if (count < least)
    throw InvalidArgument("mesh: {} is {}, expected {} or more", name, count, least);
}

/// Point k of `around` on a circle in the plane of u and v.
Vector3d on_circle(const Vector3d& u, const Vector3d& v, double radius, double turn, Index k,
                   Index around) {
  const double angle =
      turn + 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(around);
  return radius * (std::cos(angle) * u + std::sin(angle) * v);
}

/// The band of triangles between two circles of vertices, the first seen counter-clockwise from the
/// side of the second.
void add_band(Mesh& mesh, Index first, Index second, Index around) {
  for (Index k = 0; k < around; ++k) {
    const int a = static_cast<int>(first + k), b = static_cast<int>(first + (k + 1) % around);
    const int c = static_cast<int>(second + k), d = static_cast<int>(second + (k + 1) % around);
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({a, d, c});
  }
}

/// Closes a mesh of circles along z, from the lowest one up, with fans around -pole and pole.
void add_poles(Mesh& mesh, const Vector3d& pole, Index around) {
  const int lower = static_cast<int>(mesh.vertices.size()), upper = lower + 1;
  const int last = lower - static_cast<int>(around);
  mesh.vertices.push_back(-pole);
  mesh.vertices.push_back(pole);
  for (Index k = 0; k < around; ++k) {
    const int a = static_cast<int>(k), b = static_cast<int>((k + 1) % around);
    mesh.triangles.push_back({lower, b, a});
    mesh.triangles.push_back({upper, last + a, last + b});
  }
}

/// Turns `u`, normal to `from`, so that it is normal to `to`, by the least rotation.
Vector3d carried(const Vector3d& u, const Vector3d& from, const Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to) * u;
}

}  // namespace

Mesh mesh_of(const Ring& ring, Index around) {
  require_at_least(kLeastFacets, around, "facets around");
  const Index count = static_cast<Index>(ring.corners.size());
  const auto edge = [&](Index i) -> Vector3d {
    return (ring.corners[(i + 1) % count] - ring.corners[i % count]).normalized();
  };
  const auto tangent = [&](Index i) -> Vector3d {
    return (edge(i + count - 1) + edge(i)).normalized();
  };

  std::vector<Vector3d> u{tangent(0).unitOrthogonal()};
  for (Index i = 0; i < count; ++i) u.push_back(carried(u.back(), tangent(i), tangent(i + 1)));
  // Carried round once, u comes back turned; every corner takes its share of that.
  const double twist =
      std::atan2(u.back().cross(u.front()).dot(tangent(0)), u.back().dot(u.front()));

  Mesh mesh;
  for (Index i = 0; i < count; ++i) {
    const double turn = twist * static_cast<double>(i) / static_cast<double>(count);
    for (Index k = 0; k < around; ++k)
      mesh.vertices.push_back(
          ring.corners[i] + on_circle(u[i], tangent(i).cross(u[i]), ring.radius, turn, k, around));
  }
  for (Index i = 0; i < count; ++i) add_band(mesh, around * i, around * ((i + 1) % count), around);
  return mesh;
}

Mesh mesh_of(const Capsule& capsule, Index around, Index rings) {
  require_at_least(kLeastFacets, around, "facets around");
  require_at_least(1, rings, "rings");
  const Vector3d top(0, 0, capsule.length / 2);
  Mesh mesh;
  // Circles from the lower half sphere to the upper one, both equators among them.
  for (const double side : {-1.0, 1.0}) {
    for (Index i = 0; i < rings; ++i) {
      const Index up = side < 0 ? i + 1 - rings : i;
      const double latitude =
          std::numbers::pi / 2 * static_cast<double>(up) / static_cast<double>(rings);
      for (Index k = 0; k < around; ++k)
        mesh.vertices.push_back(side * top +
                                capsule.radius * std::sin(latitude) * Vector3d::UnitZ() +
                                on_circle(Vector3d::UnitX(), Vector3d::UnitY(),
                                          capsule.radius * std::cos(latitude), 0, k, around));
    }
  }
  for (Index i = 0; i + 1 < 2 * rings; ++i) add_band(mesh, around * i, around * (i + 1), around);

  add_poles(mesh, top + capsule.radius * Vector3d::UnitZ(), around);
  return mesh;
}

Mesh mesh_of(const Cylinder& cylinder, Index around) {
  require_at_least(kLeastFacets, around, "facets around");
  const Vector3d top(0, 0, cylinder.length / 2);
  Mesh mesh;
  for (const Vector3d& centre : {Vector3d(-top), top})
    for (Index k = 0; k < around; ++k)
      mesh.vertices.push_back(
          centre + on_circle(Vector3d::UnitX(), Vector3d::UnitY(), cylinder.radius, 0, k, around));
  add_band(mesh, 0, around, around);
  add_poles(mesh, top, around);
  return mesh;
}

Mesh mesh_of(const Box& box, Index divisions) {
  require_at_least(1, divisions, "divisions of a face");
  Mesh mesh;
  std::map<std::array<Index, 3>, int> numbers;  // of vertices, by their place on the lattice
  const auto vertex = [&](const std::array<Index, 3>& at) {
    const auto [place, fresh] = numbers.emplace(at, static_cast<int>(mesh.vertices.size()));
    if (fresh) {
      const Vector3d share = Vector3d(at[0], at[1], at[2]) / static_cast<double>(divisions);
      mesh.vertices.push_back((share.array() - 0.5).matrix().cwiseProduct(box.edges));
    }
    return place->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const Index level : {Index{0}, divisions}) {
      for (Index i = 0; i < divisions; ++i) {
        for (Index j = 0; j < divisions; ++j) {
          const auto corner = [&](Index di, Index dj) {
            std::array<Index, 3> at{};
            at[axis] = level;
            at[(axis + 1) % 3] = i + di;
            at[(axis + 2) % 3] = j + dj;
            return vertex(at);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (level > 0) {
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
          } else {
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({a, d, c});
          }
        }
      }
    }
  }
  return mesh;
}

}  // namespace lcp::collision
