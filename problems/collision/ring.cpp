#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/collision/colliders.h"
#include "problems/collision/signed_distance.h"

namespace lcp::collision {

namespace {

/// Sine of the angle under which two segments count as parallel.
constexpr double kParallel = 1e-9;

/// Turn of a wire at a corner (cosine) up to which its segments stand for a curve. Where it turns
/// more, the segments on both sides may each have a minimum of their own.
const double kSmooth = std::cos(0.55);

/// Where segment i of a wire is nearest to segment j of the other (0 for other solids).
struct Nearest {
  Index i, j;
  double s, t;      ///< Where on the segments, 0 ... 1.
  double distance;  ///< m, between centre lines or from the surface of a solid.
  Vector3d position, normal;
};

/// For each segment of a wire whether the corner at its end is smooth.
std::vector<bool> smooth_corners(const std::vector<Vector3d>& corners) {
  const std::size_t count = corners.size();
  std::vector<bool> smooth(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d &a = corners[i], &b = corners[(i + 1) % count], &c = corners[(i + 2) % count];
    smooth[i] = (b - a).dot(c - b) >= kSmooth * (b - a).norm() * (c - b).norm();
  }
  return smooth;
}

/// Whether the distance falls from `place` on segment a to segment b where b is nearer: b is a or its
/// neighbour, and the corner between them is smooth or just where the place is.
bool leads_to(Index a, Index b, double place, const std::vector<bool>& smooth) {
  const Index count = static_cast<Index>(smooth.size());
  if (a == b) return true;
  if ((a + 1) % count == b) return smooth[a] || place >= 1;
  if ((b + 1) % count == a) return smooth[b] || place <= 0;
  return false;
}

/// Adds those of `found`, in the order of (i, j), from which no neighbouring pair of segments is
/// nearer. A minimum at a corner is found on both sides of it, equally far: the first counts.
void add_local_minima(const std::vector<Nearest>& found, const std::vector<bool>& smooth_i,
                      const std::vector<bool>& smooth_j, double reach,
                      std::vector<Touch>& touches) {
  for (std::size_t a = 0; a < found.size(); ++a) {
    const Nearest& here = found[a];
    bool least = true;
    for (std::size_t b = 0; b < found.size() && least; ++b) {
      const Nearest& other = found[b];
      if (a == b || !leads_to(here.i, other.i, here.s, smooth_i) ||
          !leads_to(here.j, other.j, here.t, smooth_j))
        continue;
      least = b < a ? here.distance < other.distance : here.distance <= other.distance;
    }
    if (least)
      touches.push_back({here.position, here.normal, reach - here.distance,
                         here.i * ring_corners_limit + here.j});
  }
}

/// The segments of a ring with spheres around them.
struct Segment {
  Index number;
  Vector3d from, along, middle;
  double half_length;
};

/// Those that come within `reach` of the box `low` ... `high`.
std::vector<Segment> segments_near(const std::vector<Vector3d>& corners, const Vector3d& low,
                                   const Vector3d& high, double reach) {
  std::vector<Segment> near;
  const Index count = static_cast<Index>(corners.size());
  for (Index i = 0; i < count; ++i) {
    const Vector3d &a = corners[i], &b = corners[i + 1 == count ? 0 : i + 1];
    if (((a.cwiseMin(b) - high).array() > reach).any() ||
        ((low - a.cwiseMax(b)).array() > reach).any())
      continue;
    const Vector3d along = b - a;
    near.push_back({i, a, along, a + along / 2, along.norm() / 2});
  }
  return near;
}

/// Nearest points of two segments. Source: C. Ericson, Real-Time Collision Detection (2005), 5.1.9.
std::pair<double, double> nearest_on_segments(const Segment& first, const Segment& second) {
  const Vector3d between = first.from - second.from;
  const double a = first.along.squaredNorm(), e = second.along.squaredNorm();
  const double b = first.along.dot(second.along);
  const double c = first.along.dot(between), f = second.along.dot(between);
  const double determinant = a * e - b * b;
  double s = 0.5;  // of parallel segments, any point will do
  if (determinant > kParallel * kParallel * a * e)
    s = std::clamp((b * f - c * e) / determinant, 0.0, 1.0);
  double t = (b * s + f) / e;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
  }
  return {s, t};
}

struct Bounds {
  Vector3d low, high;

  explicit Bounds(const std::vector<Vector3d>& points) : low(points.front()), high(low) {
    for (const Vector3d& point : points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
};

}  // namespace

void ring_on_ring(const Placed& first, const Placed& second, std::vector<Touch>& touches) {
  const double r1 = std::get<Ring>(*first.geometry).radius;
  const double r2 = std::get<Ring>(*second.geometry).radius;
  const double reach = r1 + r2;
  const Bounds around_second(second.corners);
  const auto ours = segments_near(first.corners, around_second.low, around_second.high, reach);
  if (ours.empty()) return;
  const Bounds around_first(first.corners);
  const auto theirs = segments_near(second.corners, around_first.low, around_first.high, reach);

  std::vector<Nearest> found;
  for (const Segment& x : ours) {
    for (const Segment& y : theirs) {
      const double limit = reach + x.half_length + y.half_length;
      if ((x.middle - y.middle).squaredNorm() > limit * limit) continue;
      const auto [s, t] = nearest_on_segments(x, y);
      const Vector3d on_first = x.from + s * x.along, on_second = y.from + t * y.along;
      const Vector3d apart = on_first - on_second;
      const double distance = apart.norm();
      if (distance > reach) continue;
      Vector3d normal = apart / distance;
      if (distance == 0) {  // centre lines that cross: across both
        normal = x.along.cross(y.along);
        normal = normal.norm() > 0 ? Vector3d(normal.normalized()) : x.along.unitOrthogonal();
      }
      found.push_back({x.number, y.number, s, t, distance,
                       on_second + (r2 - (reach - distance) / 2) * normal, normal});
    }
  }
  if (found.empty()) return;
  add_local_minima(found, smooth_corners(first.corners), smooth_corners(second.corners), reach,
                   touches);
}

void ring_on_solid(const Placed& ring, const Placed& solid, std::vector<Touch>& touches) {
  const double radius = std::get<Ring>(*ring.geometry).radius;
  const auto in_solid = [&](const Vector3d& x) -> Vector3d {
    return solid.pose.R.transpose() * (x - solid.pose.p);
  };
  const Index count = static_cast<Index>(ring.corners.size());
  std::vector<Nearest> found;
  Vector3d from = in_solid(ring.corners.front());
  for (Index i = 0; i < count; ++i) {
    const Vector3d to = in_solid(ring.corners[(i + 1) % count]);
    const DistanceAlong segment(*solid.geometry, from, to);
    from = to;
    if (segment.at(0.5).distance > segment.length() / 2 + radius) continue;
    const double s = segment.rises_at(0);
    SignedDistance here = segment.at(s);
    if (here.distance > radius) continue;
    if (here.normal.isZero()) here.normal = segment.along().unitOrthogonal();
    const Vector3d position = segment.point(s) - (here.distance + radius) / 2 * here.normal;
    found.push_back(
        {i, 0, s, 0.5, here.distance, solid.pose * position, solid.pose.R * here.normal});
  }
  if (found.empty()) return;
  add_local_minima(found, smooth_corners(ring.corners), {true}, radius, touches);
}

}  // namespace lcp::collision
