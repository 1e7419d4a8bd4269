#pragma once

#include <vector>

#include "problems/collision/shape.h"

namespace lcp::collision {

/// A box or cylinder at an orientation, by its support function. Points are relative to its centre,
/// in world axes.
class Convex {
 public:
  Convex(const Geometry& geometry, const Matrix3d& R);

  bool is_box() const { return radius_ == 0; }
  double radius() const { return radius_; }    ///< Of a cylinder, 0 of a box.
  Vector3d axis() const { return R_.col(2); }  ///< Of a cylinder.
  const Matrix3d& axes() const { return R_; }
  /// The point farthest along a direction.
  Vector3d support(const Vector3d& direction) const;
  /// Farthest point of one of a cylinder's rims: the upper for `side` 1, the lower for -1.
  Vector3d rim_support(const Vector3d& direction, double side) const;

  /// What a solid turns to a direction: a point, a segment or a polygon, in order around it.
  struct Face {
    std::vector<Vector3d> points;
    double round = 0;  ///< m: a segment is the line on a cylinder's side, so far from its axis.
  };
  /// Faces and edges within `flat` (sine of an angle) of lying across `direction`, unit, count as
  /// turned to it. A cylinder's end is an octagon of points on its rim, the farthest among them.
  Face face(const Vector3d& direction, double flat) const;

 private:
  Matrix3d R_;
  Vector3d half_;
  double radius_ = 0;
};

/// The shortest way out of an overlap.
struct Penetration {
  Vector3d normal;   ///< Unit, the way the first has to go.
  double depth = 0;  ///< m: how far; negative where the solids do not overlap (not their distance).
};

/// Two solids, the first's centre at `offset` from the second's.
///
/// The depth is the least over all directions d of overlap(d) = h_1(-d) + h_2(d) - offset'd, with
/// h the support functions. Where faces or edges take part, that d is normal to an axis of either
/// solid, or along that of a cylinder: minima on a few great circles. Only where the rims of two
/// cylinders cross it is not; Newton's method finds those from the best of the circles'. On a
/// circle, tangents at two directions bound the overlap between them from below; their crossing
/// is evaluated in turn until it lies as low.
///
/// Finds the least of all for overlaps much smaller than the solids; stops at the first direction
/// that separates them.
Penetration penetration(const Convex& first, const Convex& second, const Vector3d& offset);

}  // namespace lcp::collision
