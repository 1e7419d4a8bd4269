#include <algorithm>
#include <cmath>

#include "problems/collision/colliders.h"
#include "problems/collision/penetration.h"

namespace lcp::collision {

namespace {

using Face = Convex::Face;

/// Sine of the angle within which faces and edges count as turned to each other: about a degree.
constexpr double kFlat = 0.02;
/// The same, up to rounding.
constexpr double kExactlyFlat = 1e-9;
/// Depths that differ by so much, m, are the same: rounding in sizes below 10 m.
constexpr double kSameDepth = 1e-14;
/// Parallel lines that are deeper between the ends of their stretch by this share of the cylinders'
/// radii have a point there as well.
constexpr double kDeeper = 1e-6;

/// Points of contact of two solids that have to go apart along `normal`, all relative to the centre
/// of the second.
class Manifold {
 public:
  Manifold(const Convex& first, const Convex& second, const Vector3d& offset,
           const Penetration& least)
      : first_(first), second_(second), offset_(offset), least_(least) {}

  std::vector<Touch> find() {
    add(kFlat);
    // Where faces are not quite flat the points that they share need not hold the deepest.
    if (!has_deepest_) add(kExactlyFlat);
    if (touches_.empty()) add_above(second_.support(n()), least_.depth);
    return std::move(touches_);
  }

 private:
  const Vector3d& n() const { return least_.normal; }

  void add(double flat) {
    Face lower = second_.face(n(), flat), upper = first_.face(-n(), flat);
    for (Vector3d& point : upper.points) point += offset_;
    if (upper.points.size() == 1) {
      add_above(upper.points.front() + least_.depth * n(), least_.depth);
    } else if (lower.points.size() == 1) {
      add_above(lower.points.front(), least_.depth);
    } else if (upper.points.size() == 2 && lower.points.size() == 2) {
      add_of_segments(upper, lower, flat);
    } else if (lower.points.size() == 2) {
      add_of_polygon(lower.points, upper.points, -n());
    } else {
      add_of_polygon(upper.points, lower.points, n());
    }
  }

  /// The middle of an overlap below `top`, the second solid's end of it.
  void add_above(const Vector3d& top, double depth) { add(top - depth / 2 * n(), n(), depth); }

  void add(const Vector3d& position, const Vector3d& normal, double depth) {
    if (depth >= least_.depth - kSameDepth) has_deepest_ = true;
    if (depth >= 0)
      touches_.push_back({position, normal, depth, static_cast<Index>(touches_.size())});
  }

  /// Lines on the sides of cylinders and edges of boxes: the ends of the stretch that they have in
  /// common where they are parallel, else the point where they cross, seen along the normal.
  void add_of_segments(const Face& upper, const Face& lower, double flat) {
    const Vector3d &a = upper.points[0], &b = lower.points[0];
    const Vector3d u = upper.points[1] - a, v = lower.points[1] - b;
    const Vector3d crossing = u.cross(v);
    if (crossing.norm() > kFlat * u.norm() * v.norm()) {
      if (flat > kExactlyFlat) return;  // they may not be lines that cross, but ends of such
      const double s = (b - a).cross(v).dot(crossing) / crossing.squaredNorm();
      add_above(a + std::clamp(s, 0.0, 1.0) * u + least_.depth * n(), least_.depth);
      return;
    }
    const auto along = [&](const Vector3d& x) { return (x - a).dot(u) / u.squaredNorm(); };
    const double t0 = along(lower.points[0]), t1 = along(lower.points[1]);
    const double begin = std::max(0.0, std::min(t0, t1)), end = std::min(1.0, std::max(t0, t1));
    if (begin > end) return;
    for (const double s : {begin, end}) add_beside(a + s * u, upper.round, b, v, lower.round);
    const double as_deep = least_.depth - kDeeper * (upper.round + lower.round);
    const bool deeper_between =
        std::none_of(touches_.begin(), touches_.end(),
                     [&](const Touch& touch) { return touch.depth >= as_deep; });
    if (deeper_between && crossing.norm() > 0) {
      const double s = (b - a).cross(v).dot(crossing) / crossing.squaredNorm();
      if (s > begin && s < end) add_above(a + s * u + least_.depth * n(), least_.depth);
    }
    has_deepest_ = has_deepest_ || !deeper_between;
  }

  /// At a point of a line at `upper_round` from its cylinder's axis: the overlap is that of the
  /// axes' distance, which other than that of the lines is right beside the place where they cross.
  void add_beside(const Vector3d& upper, double upper_round, const Vector3d& b, const Vector3d& v,
                  double lower_round) {
    const Vector3d axis_point = upper + upper_round * radial(first_, n());
    const Vector3d axis = b - lower_round * radial(second_, n());
    const double t = (axis_point - axis).dot(v) / v.squaredNorm();
    const Vector3d apart = axis_point - (axis + t * v);
    const double distance = apart.norm();
    const double depth = upper_round + lower_round - distance;
    const Vector3d normal = distance > 0 ? Vector3d(apart / distance) : n();
    add(axis + t * v + (lower_round - depth / 2) * normal, normal, depth);
  }

  /// Direction from a cylinder's axis to the line on its side that lies farthest along `direction`.
  static Vector3d radial(const Convex& solid, const Vector3d& direction) {
    if (solid.is_box()) return Vector3d::Zero();
    const Vector3d axis = solid.axis();
    return (direction - axis * axis.dot(direction)).normalized();
  }

  /// A segment or polygon on a polygon that looks along `up`: what of it is within the sides of
  /// that one.
  void add_of_polygon(std::vector<Vector3d> points, const std::vector<Vector3d>& polygon,
                      const Vector3d& up) {
    const std::size_t corners = polygon.size();
    Vector3d plane = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[1]).normalized();
    if (plane.dot(up) < 0) plane = -plane;
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& corner : polygon) middle += corner / static_cast<double>(corners);
    for (std::size_t i = 0; i < corners && !points.empty(); ++i) {
      const Vector3d& from = polygon[i];
      Vector3d inward = up.cross(polygon[(i + 1) % corners] - from);
      if (inward.dot(middle - from) < 0) inward = -inward;
      points = clipped(points, from, inward);
    }
    const bool plane_is_lower = up.dot(n()) > 0;
    for (const Vector3d& point : points) {
      const double depth = plane.dot(polygon[0] - point) / plane.dot(up);
      add_above(plane_is_lower ? Vector3d(point + depth * up) : point, depth);
    }
  }

  /// What of a segment or polygon lies on the inner side of a plane. Source: I. E. Sutherland,
  /// G. W. Hodgman, Reentrant polygon clipping, Comm. ACM 17 (1974).
  static std::vector<Vector3d> clipped(const std::vector<Vector3d>& points, const Vector3d& from,
                                       const Vector3d& inward) {
    std::vector<Vector3d> kept;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3d &a = points[i], &b = points[(i + 1) % count];
      const double inside_a = inward.dot(a - from), inside_b = inward.dot(b - from);
      if (inside_a >= 0) kept.push_back(a);
      const bool goes_back = count == 2 && i == 1;
      if (!goes_back && (inside_a > 0) != (inside_b > 0) && inside_a != 0 && inside_b != 0)
        kept.push_back(a + inside_a / (inside_a - inside_b) * (b - a));
    }
    return kept;
  }

  const Convex &first_, &second_;
  Vector3d offset_;
  const Penetration& least_;
  std::vector<Touch> touches_;
  bool has_deepest_ = false;
};

}  // namespace

void convex_on_convex(const Placed& first, const Placed& second, std::vector<Touch>& touches) {
  const Convex above(*first.geometry, first.pose.R), below(*second.geometry, second.pose.R);
  const Vector3d offset = first.pose.p - second.pose.p;
  const Penetration least = penetration(above, below, offset);
  if (least.depth < 0) return;
  for (Touch touch : Manifold(above, below, offset, least).find()) {
    touch.position += second.pose.p;
    touches.push_back(touch);
  }
}

}  // namespace lcp::collision
