#pragma once

#include <vector>

#include "problems/rigid/spatial.h"

namespace lcp::cases {

/// A circle about the z axis of its frame.
struct Circle {
  double radius = 0;
  Pose pose;
};

/// A place where two circles are nearer than all around it.
struct NearestPoints {
  double distance = 0;
  Vector3d on_first, on_second;
};

/// All of them, nearest first: the nearest point of the second circle to each of many points of the
/// first is known exactly, so that minima along the first are all; refined by golden sections.
std::vector<NearestPoints> nearest_points(const Circle& first, const Circle& second);

}  // namespace lcp::cases
