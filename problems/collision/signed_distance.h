#pragma once

#include "problems/collision/shape.h"

namespace lcp::collision {

/// Distance of a point from the surface of a solid, negative inside, and its gradient: the unit
/// normal of the surface at the nearest point. A convex function of the point.
struct SignedDistance {
  double distance = 0;                 ///< m.
  Vector3d normal = Vector3d::Zero();  ///< Zero where all directions are the same: on an axis.
  double to_core = 0;  ///< m: the same from the axis of a capsule, the centre of a sphere; of other
                       ///< solids, which are not rounded, the distance.
};

/// Of a sphere, capsule, box or cylinder, at `point` in its frame.
SignedDistance signed_distance(const Geometry& solid, const Vector3d& point);

/// A segment in a solid's frame and the distances of its points, at s from 0 to 1. Because the
/// solid is convex, the slope of the distance never falls with s.
class DistanceAlong {
 public:
  DistanceAlong(const Geometry& solid, const Vector3d& from, const Vector3d& to)
      : solid_(solid), from_(from), along_(to - from), length_(along_.norm()) {}

  double length() const { return length_; }
  const Vector3d& along() const { return along_; }  ///< From one end to the other, m.
  Vector3d point(double s) const { return from_ + s * along_; }
  SignedDistance at(double s) const { return signed_distance(solid_, point(s)); }
  /// Where on the segment a point is nearest.
  double nearest(const Vector3d& point) const;
  /// The least s at which the distance grows by `slope` metres a metre or more; 1 where it nowhere does.
  double rises_at(double slope) const;

 private:
  const Geometry& solid_;
  Vector3d from_, along_;
  double length_;
};

}  // namespace lcp::collision
