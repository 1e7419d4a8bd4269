#include <array>
#include <cmath>
#include <utility>

#include "problems/collision/colliders.h"
#include "problems/collision/signed_distance.h"

namespace lcp::collision {

namespace {

/// Where the distance of an axis from the other solid changes by less than this, m per m, it runs
/// along its surface: about a degree.
constexpr double kAlong = 0.02;
/// Stretches shorter than so many radii count as one point.
constexpr double kStretch = 1;
/// Depths that differ by less than this share of the radius are the same.
constexpr double kEven = 1e-12;
/// Deeper between the ends of a stretch than at both by this share of the radius: a point as well.
constexpr double kDeeper = 1e-6;

enum Feature : Index { at_start, at_end, between };

/// A capsule against another solid, in the frame of that one.
class AxisOnSolid {
 public:
  AxisOnSolid(const DistanceAlong& axis, double radius, const Pose& solid)
      : axis_(axis), radius_(radius), solid_(solid) {}

  void add_to(std::vector<Touch>& touches) const {
    const double deepest_at = axis_.rises_at(0);
    const Touch deepest = touch(deepest_at, name(deepest_at));
    if (deepest.depth < 0) return;
    const double start = stretch_end(-kAlong), end = stretch_end(kAlong);
    if ((end - start) * axis_.length() < kStretch * radius_) {
      // Where all of a short stretch is as deep, its middle rather than any point of it.
      const Touch middle = touch((start + end) / 2, between);
      const bool even = end > start && middle.depth >= deepest.depth - kEven * radius_;
      touches.push_back(even ? middle : deepest);
      return;
    }
    bool deepest_is_new = true;
    std::array<Touch, 2> ends{touch(start, at_start), touch(end, at_end)};
    for (const auto& [s, i] : {std::pair(start, 0), {end, 1}}) {
      const bool near = std::abs(s - deepest_at) * axis_.length() < kStretch * radius_ / 2;
      if (near && deepest.depth > ends[i].depth + kEven * radius_) {
        ends[i] = deepest;
        ends[i].feature = i;
      }
      if (ends[i].depth < 0) continue;
      deepest_is_new = deepest_is_new && deepest.depth > ends[i].depth + kDeeper * radius_;
      touches.push_back(ends[i]);
    }
    if (deepest_is_new) touches.push_back(deepest);
  }

 private:
  Index name(double s) const {
    if (s <= 0) return at_start;
    return s >= 1 ? at_end : between;
  }

  /// Where the axis begins (`slope` < 0) or ceases to run along the surface: at its own end, or
  /// where it passes the other's last point.
  double stretch_end(double slope) const {
    const double s = axis_.rises_at(slope);
    if (s <= 0 || s >= 1) return s;
    const SignedDistance here = axis_.at(s);
    return axis_.nearest(axis_.point(s) - here.to_core * here.normal);
  }

  Touch touch(double s, Index feature) const {
    SignedDistance here = axis_.at(s);
    // Axes that meet have no direction between them; across both is the shortest way out.
    if (here.normal.isZero()) here.normal = across();
    const Vector3d position = axis_.point(s) - (here.distance + radius_) / 2 * here.normal;
    return {solid_ * position, solid_.R * here.normal, radius_ - here.distance, feature};
  }

  Vector3d across() const {
    const Vector3d other = Vector3d::UnitZ();
    const Vector3d normal = axis_.along().cross(other);
    if (normal.norm() > kAlong * axis_.length()) return normal.normalized();
    return axis_.length() > 0 ? axis_.along().unitOrthogonal() : other.unitOrthogonal();
  }

  const DistanceAlong& axis_;
  double radius_;
  const Pose& solid_;
};

}  // namespace

void capsule_on_solid(const Placed& capsule, const Placed& solid, std::vector<Touch>& touches) {
  const auto* round = std::get_if<Capsule>(capsule.geometry);
  const double radius = round ? round->radius : std::get<Sphere>(*capsule.geometry).radius;
  const Vector3d half = capsule.pose.R.col(2) * (round ? round->length / 2 : 0);
  const auto in_solid = [&](const Vector3d& x) -> Vector3d {
    return solid.pose.R.transpose() * (x - solid.pose.p);
  };
  const DistanceAlong axis(*solid.geometry, in_solid(capsule.pose.p - half),
                           in_solid(capsule.pose.p + half));
  AxisOnSolid(axis, radius, solid.pose).add_to(touches);
}

}  // namespace lcp::collision
