#include "harness/present/scenes/scene_bodies.h"

#include <algorithm>

namespace lcp {

namespace {

using collision::Shape;

constexpr unsigned kBody = 0xe4e7eb, kWorld = 0xd8c9a8;
constexpr unsigned kHandles[] = {0x86bbea, 0x5592c8};
constexpr double kSlender = 0.05;    // thickness of a bone over its length,
constexpr double kThinnest = 0.004;  // and its bounds, m
constexpr double kThickest = 0.02;
constexpr double kNear = 0.25;  // of a region's size: how far around it is near

/// A stick from the link's joint to `end` in its frame.
Shape bone(Index link, const Vector3d& end) {
  const double length = end.norm();
  const double thick = std::clamp(kSlender * length, kThinnest, kThickest);
  Shape shape{.geometry = collision::Box{{thick, thick, length + thick}}, .link = link};
  shape.in_link.R = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), end).toRotationMatrix();
  shape.in_link.p = shape.in_link.R * Vector3d(0, 0, length / 2);
  return shape;
}

/// Of each link.
std::vector<unsigned> colours(const SceneSetup& setup) {
  const Model& model = setup.system.model;
  std::vector<bool> handle(model.size(), false);
  for (const Index i : setup.system.handles) handle[i] = true;
  std::vector<unsigned> colour(model.size(), kBody);
  std::size_t roots = 0;
  for (Index i = 0; i < model.size(); ++i) {
    const Index parent = model.link(i).parent;
    const std::size_t root = parent == Link::world ? roots++ : 0;
    if (!handle[i]) continue;
    const bool as_second = parent == Link::world ? root % 2 == 1 : colour[parent] == kHandles[0];
    colour[i] = kHandles[as_second ? 1 : 0];
  }
  return colour;
}

/// Shortens the length along an axis of the shape to what is near, moving its centre.
void shorten(Shape& shape, int axis, double& length, const Eigen::AlignedBox3d& region) {
  const Vector3d direction = shape.in_link.R.col(axis);
  const double centre = direction.dot(region.center() - shape.in_link.p);
  const double reach =
      direction.cwiseAbs().dot(region.sizes()) / 2 + kNear * region.sizes().maxCoeff();
  const double low = std::max(-length / 2, centre - reach);
  const double high = std::min(length / 2, centre + reach);
  if (low >= high) return;
  shape.in_link.p += (low + high) / 2 * direction;
  length = high - low;
}

}  // namespace

Pose SceneBody::in_world(const Snapshot& snapshot) const {
  return shape.link == Link::world ? shape.in_link : snapshot.links[shape.link] * shape.in_link;
}

std::vector<SceneBody> scene_bodies(const SceneSetup& setup) {
  const Model& model = setup.system.model;
  const std::vector<unsigned> colour = colours(setup);
  std::vector<bool> has_shape(model.size(), false), has_child(model.size(), false);
  std::vector<SceneBody> bodies;
  for (const Shape& shape : setup.shapes) {
    if (std::holds_alternative<collision::HalfSpace>(shape.geometry)) continue;
    const bool in_the_world = shape.link == Link::world;
    bodies.push_back({shape, in_the_world ? kWorld : colour[shape.link]});
    if (!in_the_world) has_shape[shape.link] = true;
  }
  for (Index i = 0; i < model.size(); ++i) {
    const Index parent = model.link(i).parent;
    if (parent == Link::world) continue;
    has_child[parent] = true;
    if (!has_shape[parent])
      bodies.push_back({bone(parent, model.link(i).in_parent.p), colour[parent]});
  }
  for (Index i = 0; i < model.size(); ++i)
    if (!has_shape[i] && !has_child[i])
      bodies.push_back({bone(i, model.link(i).centre), colour[i]});
  return bodies;
}

bool has_floor(const SceneSetup& setup) {
  return std::any_of(setup.shapes.begin(), setup.shapes.end(), [](const Shape& shape) {
    return std::holds_alternative<collision::HalfSpace>(shape.geometry) &&
           shape.link == Link::world && shape.in_link.p.z() == 0 &&
           shape.in_link.R.col(2).isApprox(Vector3d::UnitZ());
  });
}

Shape near_part(const Shape& shape, const Eigen::AlignedBox3d& region) {
  Shape near = shape;
  if (shape.link != Link::world || region.isEmpty()) return near;
  if (auto* capsule = std::get_if<collision::Capsule>(&near.geometry))
    shorten(near, 2, capsule->length, region);
  if (auto* cylinder = std::get_if<collision::Cylinder>(&near.geometry))
    shorten(near, 2, cylinder->length, region);
  if (auto* box = std::get_if<collision::Box>(&near.geometry))
    for (int axis = 0; axis < 3; ++axis) shorten(near, axis, box->edges(axis), region);
  return near;
}

}  // namespace lcp
