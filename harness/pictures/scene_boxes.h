#pragma once

#include <array>
#include <vector>

#include "harness/pictures/snapshots.h"
#include "problems/scenes/scene.h"

namespace lcp {

/// A box that a picture shows of a scene.
struct SceneBox {
  Index link = 0;  ///< Or Link::world.
  Pose in_link;
  Vector3d low, high;   ///< In the frame `in_link`, m.
  unsigned colour = 0;  ///< 0xRRGGBB in full light.

  Pose in_world(const Snapshot& snapshot) const;
  std::array<Vector3d, 8> corners(const Snapshot& snapshot) const;  ///< World, m.
};

/// Every box of the scene, in the colour of links that may touch something or of others, and for
/// links without a box bones from their joint to those of their children, or to their centre of mass
/// where they have none.
std::vector<SceneBox> scene_boxes(const SceneSetup& setup);

}  // namespace lcp
