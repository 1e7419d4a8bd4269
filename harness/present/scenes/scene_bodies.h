#pragma once

#include <vector>

#include "harness/present/scenes/snapshots.h"
#include "problems/scenes/scene.h"

namespace lcp {

/// Something that a picture shows of a scene.
struct SceneBody {
  Index link = Link::world;
  Pose in_link = {};
  collision::Mesh surface;  ///< In its own frame, fine enough for a picture.
  unsigned colour = 0;      ///< 0xRRGGBB in full light.

  Pose in_world(const Snapshot& snapshot) const;
};

/// Every shape of the scene but half-spaces, in the colour of links that may touch something (two
/// of them, in turn along chains and from one free body to the next), of other links or of the
/// world, and for links without a shape bones from their joint to those of their children, or to
/// their centre of mass where they have none.
std::vector<SceneBody> scene_bodies(const SceneSetup& setup);

/// Whether the half-space z <= 0 of the world is among the shapes.
bool has_floor(const SceneSetup& setup);

/// The surface of a shape. The wire of a ring is a capsule from each corner to the next. None for a
/// half-space.
collision::Mesh surface_of(const collision::Geometry& geometry);

/// Shortens rods and beams of the world, which may be much longer than what a picture is about, to
/// what lies within or near `region` (m, world), along their axes; what is elsewhere stays as it is.
void keep_near(SceneBody& body, const Eigen::AlignedBox3d& region);

}  // namespace lcp
