#pragma once

#include "problems/rigid/kinematics.h"

namespace lcp {

/// What the joint between two bodies transmits, at the joint in world axes.
struct Transmission {
  Space T;  ///< Columns span the forces that hold: T'S = 0 for the motions S it allows.
  Space F;  ///< Torques that drive it, S'F = 1; a loop's joint has no such torques.
};

/// Of the joint that carries a link; a prescribed joint transmits all, T = 1, a free one nothing.
Transmission link_transmission(const Model& model, const Kinematics& kinematics, Index link);

/// Of a loop's joint, on its second link.
Transmission loop_transmission(const Model& model, const Kinematics& kinematics, Index loop);

}  // namespace lcp
