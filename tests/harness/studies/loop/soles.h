#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "problems/rigid/simulation.h"
#include "problems/scenes/humanoid/magnum.h"

namespace lcp {

/// Watches how the soles of the humanoid meet the floor.
class SoleWatch {
 public:
  struct Strike {
    double time;
    double speed;      ///< Of the lowest corner towards the floor, m/s.
    double clearance;  ///< Highest that the lowest corner was since it left the floor, m.
  };

  void look(const Frame& frame) {
    for (const magnum::Side side : {magnum::Side::left, magnum::Side::right}) {
      Foot& foot = feet_[side == magnum::Side::left ? 0 : 1];
      const Index link = magnum::foot(side);
      const Pose at = frame.kinematics.pose[link] * magnum::sole(side);
      Vector3d lowest = at * magnum::sole_points(false).front();
      for (const Vector3d& corner : magnum::sole_points(false))
        if ((at * corner).z() < lowest.z()) lowest = at * corner;
      if (lowest.z() > 0) {
        foot.clearance = std::max(foot.clearance, lowest.z());
        continue;
      }
      const double velocity =
          velocity_at(frame.kinematics.from_origin(lowest), frame.kinematics.velocity[link]).z();
      if (foot.clearance > 0) foot.strikes.push_back({frame.state.time, -velocity, foot.clearance});
      foot.clearance = 0;
    }
  }

  /// Strikes of a foot (0 left, 1 right) at `speed` or more after `clearance` or more.
  Index strikes(Index foot, double speed, double clearance) const {
    const auto& all = feet_[foot].strikes;
    return std::count_if(all.begin(), all.end(), [&](const Strike& strike) {
      return strike.speed >= speed && strike.clearance >= clearance;
    });
  }

 private:
  struct Foot {
    double clearance = 0;
    std::vector<Strike> strikes;
  };
  std::array<Foot, 2> feet_;
};

}  // namespace lcp
