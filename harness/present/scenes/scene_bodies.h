#pragma once

#include <vector>

#include "harness/present/scenes/snapshots.h"
#include "problems/scenes/scene.h"

namespace lcp {

/// Something that a picture shows of a scene.
struct SceneBody {
  collision::Shape shape;
  unsigned colour = 0;  ///< 0xRRGGBB in full light.

  Pose in_world(const Snapshot& snapshot) const;
};

/// Every shape of the scene but half-spaces, in the colour of links that may touch something (two
/// of them, in turn along chains and from one free body to the next), of other links or of the
/// world, and for links without a shape bones from their joint to those of their children, or to
/// their centre of mass where they have none.
std::vector<SceneBody> scene_bodies(const SceneSetup& setup);

/// Whether the half-space z <= 0 of the world is among the shapes.
bool has_floor(const SceneSetup& setup);

/// What lies within or near `region` (m, world) of a rod or beam of the world, which may be much
/// longer than what a picture is about; other shapes, and what is elsewhere, as they are.
collision::Shape near_part(const collision::Shape& shape, const Eigen::AlignedBox3d& region);

}  // namespace lcp
