#pragma once

#include <cmath>

#include "problems/rigid/spatial.h"

namespace lcp {

/// Looks at the world from far away (parallel projection).
struct Camera {
  Vector3d right, up, towards_viewer;  ///< Orthonormal, world axes.

  /// The viewer stands in the direction `azimuth` (rad, from x towards y), `elevation` above the
  /// horizon.
  static Camera from(double azimuth, double elevation) {
    const double c = std::cos(elevation), s = std::sin(elevation);
    const Vector3d away(std::cos(azimuth), std::sin(azimuth), 0);
    return {{-away.y(), away.x(), 0},
            c * Vector3d::UnitZ() - s * away,
            c * away + s * Vector3d::UnitZ()};
  }

  /// Place in the picture plane, m: to the right and up.
  Eigen::Vector2d flat(const Vector3d& v) const { return {right.dot(v), up.dot(v)}; }
};

}  // namespace lcp
