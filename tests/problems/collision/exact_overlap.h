#pragma once

#include "problems/collision/shape.h"

namespace lcp::cases {

/// A geometry and where it is.
struct Solid {
  collision::Geometry geometry;
  Pose pose;
};

struct Overlap {
  double depth = 0;                     ///< m: the least way that the first has to go, < 0: apart.
  Vector3d normal = Vector3d::UnitZ();  ///< The way it goes.
};

/// Overlap of spheres, capsules, boxes and cylinders, from their support functions alone: the least
/// over directions, looked for by sampling great circles (normal to the solids' axes) or, between
/// cylinders, the whole sphere too, and golden sections. Exact to rounding for shallow overlaps, of
/// boxes, cylinders and, by distances along its axis, of a sphere or capsule with anything.
/// `refine` off: only the samples, too large by up to a tenth of the sizes.
Overlap exact_overlap(const Solid& first, const Solid& second, bool refine = true);

}  // namespace lcp::cases
