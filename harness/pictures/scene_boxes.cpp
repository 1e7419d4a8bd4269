#include "harness/pictures/scene_boxes.h"

#include <algorithm>

namespace lcp {

namespace {

constexpr unsigned kBody = 0xe4e7eb, kHandle = 0x86bbea, kWorld = 0xd8c9a8;
constexpr double kSlender = 0.05;    // thickness of a bone over its length,
constexpr double kThinnest = 0.004;  // and its bounds, m
constexpr double kThickest = 0.02;

/// A stick from the link's joint to `end` in its frame.
SceneBox bone(Index link, const Vector3d& end, unsigned colour) {
  const double length = end.norm();
  const double thick = std::clamp(kSlender * length, kThinnest, kThickest) / 2;
  SceneBox box{.link = link,
               .in_link = {},
               .low = {-thick, -thick, -thick},
               .high = {thick, thick, length + thick},
               .colour = colour};
  box.in_link.R = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), end).toRotationMatrix();
  return box;
}

}  // namespace

Pose SceneBox::in_world(const Snapshot& snapshot) const {
  return link == Link::world ? in_link : snapshot.links[link] * in_link;
}

std::array<Vector3d, 8> SceneBox::corners(const Snapshot& snapshot) const {
  const Pose pose = in_world(snapshot);
  std::array<Vector3d, 8> corners;
  for (int k = 0; k < 8; ++k)
    corners[k] = pose * Vector3d((k & 1 ? high : low).x(), (k & 2 ? high : low).y(),
                                 (k & 4 ? high : low).z());
  return corners;
}

std::vector<SceneBox> scene_boxes(const SceneSetup& setup) {
  const Model& model = setup.system.model;
  std::vector<unsigned> colour(model.size(), kBody);
  for (const Index handle : setup.system.handles) colour[handle] = kHandle;
  std::vector<bool> has_box(model.size(), false), has_child(model.size(), false);
  std::vector<SceneBox> boxes;
  for (const LinkBox& box : setup.boxes) {
    const bool in_the_world = box.link == Link::world;
    boxes.push_back({.link = box.link,
                     .in_link = {},
                     .low = box.low,
                     .high = box.high,
                     .colour = in_the_world ? kWorld : colour[box.link]});
    if (!in_the_world) has_box[box.link] = true;
  }
  for (Index i = 0; i < model.size(); ++i) {
    const Index parent = model.link(i).parent;
    if (parent == Link::world) continue;
    has_child[parent] = true;
    if (!has_box[parent]) boxes.push_back(bone(parent, model.link(i).in_parent.p, colour[parent]));
  }
  for (Index i = 0; i < model.size(); ++i)
    if (!has_box[i] && !has_child[i]) boxes.push_back(bone(i, model.link(i).centre, colour[i]));
  return boxes;
}

}  // namespace lcp
