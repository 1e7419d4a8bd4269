#include "harness/present/scenes/scene_bodies.h"

#include <algorithm>

namespace lcp {

namespace {

using collision::mesh_of;
using collision::Shape;

constexpr unsigned kBody = 0xe4e7eb, kWorld = 0xd8c9a8;
constexpr unsigned kHandles[] = {0x86bbea, 0x5592c8};
constexpr double kSlender = 0.05;    // thickness of a bone over its length,
constexpr double kThinnest = 0.004;  // and its bounds, m
constexpr double kThickest = 0.02;
constexpr double kNear = 0.25;  // of a region's size: how far around it is near

/// A stick from the link's joint to `end` in its frame.
SceneBody bone(Index link, const Vector3d& end, unsigned colour) {
  const double length = end.norm();
  const double thick = std::clamp(kSlender * length, kThinnest, kThickest);
  const Matrix3d R = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), end).matrix();
  return {link, {R, end / 2}, surface_of(collision::Box{{thick, thick, length + thick}}), colour};
}

/// Of each link.
std::vector<unsigned> colours(const SceneSetup& setup) {
  const Model& model = setup.system.model;
  std::vector<unsigned> colour(model.size(), kBody);
  std::size_t roots = 0;
  for (Index i = 0; i < model.size(); ++i) {
    const Index parent = model.link(i).parent;
    const std::size_t root = parent == Link::world ? roots++ : 0;
    if (std::ranges::count(setup.system.handles, i) == 0) continue;
    const bool as_second = parent == Link::world ? root % 2 == 1 : colour[parent] == kHandles[0];
    colour[i] = kHandles[as_second ? 1 : 0];
  }
  return colour;
}

/// Facets around, and from an equator to a pole; more would not show in pictures of that size.
struct SurfaceOf {
  collision::Mesh operator()(const collision::HalfSpace&) const { return {}; }
  collision::Mesh operator()(const collision::Sphere& it) const {
    return mesh_of(collision::Capsule{it.radius, 0}, 32, 8);
  }
  collision::Mesh operator()(const collision::Capsule& it) const { return mesh_of(it, 32, 8); }
  collision::Mesh operator()(const collision::Box& it) const { return mesh_of(it, 1); }
  collision::Mesh operator()(const collision::Cylinder& it) const { return mesh_of(it, 64); }
  collision::Mesh operator()(const collision::Mesh& it) const { return it; }
  collision::Mesh operator()(const collision::Ring& ring) const {
    collision::Mesh all;
    for (std::size_t i = 0; i < ring.corners.size(); ++i) {
      const Vector3d from = ring.corners[i], to = ring.corners[(i + 1) % ring.corners.size()];
      const collision::Mesh tube =
          mesh_of(collision::Capsule{ring.radius, (to - from).norm()}, 12, 3);
      const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), to - from);
      const int first = static_cast<int>(all.vertices.size());
      for (const Vector3d& v : tube.vertices) all.vertices.push_back((from + to) / 2 + turn * v);
      for (const auto& [a, b, c] : tube.triangles)
        all.triangles.push_back({first + a, first + b, first + c});
    }
    return all;
  }
};

}  // namespace

Pose SceneBody::in_world(const Snapshot& snapshot) const {
  return link == Link::world ? in_link : snapshot.links[link] * in_link;
}

std::vector<SceneBody> scene_bodies(const SceneSetup& setup) {
  const Model& model = setup.system.model;
  const std::vector<unsigned> colour = colours(setup);
  std::vector<SceneBody> bodies;
  for (const Shape& shape : setup.shapes)
    if (!std::holds_alternative<collision::HalfSpace>(shape.geometry))
      bodies.push_back({shape.link, shape.in_link, surface_of(shape.geometry),
                        shape.link == Link::world ? kWorld : colour[shape.link]});
  for (Index i = 0; i < model.size(); ++i) {
    if (std::ranges::count(bodies, i, &SceneBody::link) > 0) continue;
    bool leaf = true;
    for (Index child = i + 1; child < model.size(); ++child) {
      if (model.link(child).parent != i) continue;
      bodies.push_back(bone(i, model.link(child).in_parent.p, colour[i]));
      leaf = false;
    }
    if (leaf) bodies.push_back(bone(i, model.link(i).centre, colour[i]));
  }
  return bodies;
}

bool has_floor(const SceneSetup& setup) {
  return std::any_of(setup.shapes.begin(), setup.shapes.end(), [](const Shape& shape) {
    return std::holds_alternative<collision::HalfSpace>(shape.geometry) &&
           shape.link == Link::world && shape.in_link.p.z() == 0 &&
           shape.in_link.R.col(2).isApprox(Vector3d::UnitZ());
  });
}

collision::Mesh surface_of(const collision::Geometry& geometry) {
  return std::visit(SurfaceOf{}, geometry);
}

void keep_near(SceneBody& body, const Eigen::AlignedBox3d& region) {
  if (body.link != Link::world || region.isEmpty()) return;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d direction = body.in_link.R.col(axis);
    const double centre = direction.dot(region.center() - body.in_link.p);
    const double reach =
        direction.cwiseAbs().dot(region.sizes()) / 2 + kNear * region.sizes().maxCoeff();
    Eigen::AlignedBox3d all;
    for (const Vector3d& v : body.surface.vertices) all.extend(v);
    if (all.min()(axis) >= centre + reach || all.max()(axis) <= centre - reach) continue;
    for (Vector3d& v : body.surface.vertices)
      v(axis) = std::clamp(v(axis), centre - reach, centre + reach);
  }
}

}  // namespace lcp
