#include "problems/contact/reduction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "solvers/errors.h"

namespace lcp {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Method = ReductionOptions::Method;
using Grouping = ReductionOptions::Grouping;
using Separating = ReductionOptions::Separating;

/// How far a unit normal's length may be from 1.
constexpr double kUnitTolerance = 1e-6;

/// Everything in which one point may differ from another, in the order in which they are gone through.
auto sort_key(const ContactPoint& point) {
  const Vector3d &x = point.position, &n = point.normal;
  return std::tuple(point.id.body1, point.id.body2, -point.depth, x.x(), x.y(), x.z(), n.x(), n.y(),
                    n.z(), point.normal_velocity, point.id.feature);
}

std::tuple<Index, Index> pair_of(const ContactPoint& point) {
  return {point.id.body1, point.id.body2};
}

void require_sound(const std::vector<ContactPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& point = points[i];
    if (!point.position.allFinite() || !std::isfinite(point.depth) ||
        !std::isfinite(point.normal_velocity))
      throw InvalidArgument(
          "contact reduction: point {}: expected a finite position, depth and velocity", i);
    if (!(std::abs(point.normal.norm() - 1) <= kUnitTolerance))
      throw InvalidArgument("contact reduction: point {}: the normal has length {}, expected 1", i,
                            point.normal.norm());
  }
}

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners of the convex hull, counter-clockwise; two for collinear points, one for coinciding ones.
/// Monotone chain: A. M. Andrew (1979), "Another efficient algorithm for convex hulls in two
/// dimensions", Information Processing Letters 9(5).
std::vector<Vector2d> convex_hull(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return std::tuple(a.x(), a.y()) < std::tuple(b.x(), b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;

  std::vector<Vector2d> hull;
  const auto chain = [&hull](auto first, auto last) {
    const std::size_t start = hull.size();
    for (auto point = first; point != last; ++point) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();  // the other chain begins with it
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

/// How far `point` of the hull's points lies inside its boundary; 0 on a hull without an inside.
double distance_inside(const std::vector<Vector2d>& hull, const Vector2d& point) {
  if (hull.size() < 3) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vector2d edge = hull[(k + 1) % hull.size()] - hull[k];
    least = std::min(least, cross(edge, point - hull[k]) / edge.norm());
  }
  return least;
}

/// The reduction of IV-C on points in order.
class PaperReduction {
 public:
  PaperReduction(const std::vector<ContactPoint>& points, const ReductionOptions& options)
      : points_(points), options_(options) {}

  std::vector<Index> operator()(const std::vector<Index>& order) const {
    return outside_polygons(without_neighbours(order));
  }

 private:
  bool stays(Index i) const {
    return options_.separating == Separating::keep &&
           points_[i].normal_velocity > options_.separating_speed;
  }

  bool same_normal(Index i, Index j) const {
    const Vector3d &a = points_[i].normal, &b = points_[j].normal;
    return std::atan2(a.cross(b).norm(), a.dot(b)) < options_.normal_angle;
  }

  std::vector<Index> without_neighbours(const std::vector<Index>& order) const {
    std::vector<Index> kept;
    for (const Index i : order) {
      const auto near = [&](Index j) {
        return pair_of(points_[i]) == pair_of(points_[j]) && same_normal(i, j) &&
               (points_[i].position - points_[j].position).norm() <= options_.merge_distance;
      };
      if (stays(i) || std::none_of(kept.begin(), kept.end(), near)) kept.push_back(i);
    }
    return kept;
  }

  bool same_group(Index i, Index j) const {
    const ContactId &a = points_[i].id, &b = points_[j].id;
    return a.body2 == b.body2 && (options_.grouping == Grouping::partner || a.body1 == b.body1) &&
           same_normal(i, j);
  }

  std::vector<Vector2d> project(const std::vector<Index>& members) const {
    const Vector3d n = points_[members.front()].normal;
    const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
    // From the first point: far from the origin the hull would lose digits.
    const Vector3d origin = points_[members.front()].position;
    std::vector<Vector2d> plane;
    for (const Index i : members) {
      const Vector3d x = points_[i].position - origin;
      plane.emplace_back(u.dot(x), v.dot(x));
    }
    return plane;
  }

  std::vector<Index> outside_polygons(const std::vector<Index>& order) const {
    std::vector<std::vector<Index>> groups;
    for (const Index i : order) {
      const auto fits = [&](const std::vector<Index>& group) {
        return same_group(group.front(), i);
      };
      const auto group = std::find_if(groups.begin(), groups.end(), fits);
      if (group != groups.end())
        group->push_back(i);
      else
        groups.push_back({i});
    }
    std::vector<bool> inside(points_.size(), false);
    for (const std::vector<Index>& group : groups) {
      const std::vector<Vector2d> plane = project(group);
      const std::vector<Vector2d> hull = convex_hull(plane);
      for (std::size_t k = 0; k < group.size(); ++k)
        inside[group[k]] =
            !stays(group[k]) && distance_inside(hull, plane[k]) > options_.inside_distance;
    }
    std::vector<Index> kept;
    std::copy_if(order.begin(), order.end(), std::back_inserter(kept),
                 [&inside](Index i) { return !inside[i]; });
    return kept;
  }

  const std::vector<ContactPoint>& points_;
  const ReductionOptions& options_;
};

/// The first `per_pair` of each pair; `order` holds a pair's points one after the other.
std::vector<Index> deepest(const std::vector<ContactPoint>& points, const std::vector<Index>& order,
                           Index per_pair) {
  std::vector<Index> kept;
  Index of_this_pair = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && pair_of(points[order[k]]) != pair_of(points[order[k - 1]])) of_this_pair = 0;
    if (of_this_pair++ < per_pair) kept.push_back(order[k]);
  }
  return kept;
}

}  // namespace

std::vector<Index> reduce_contacts(const std::vector<ContactPoint>& points,
                                   const ReductionOptions& options) {
  require_sound(points);
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(),
            [&](Index i, Index j) { return sort_key(points[i]) < sort_key(points[j]); });
  if (options.method == Method::none) return order;
  if (options.separating == Separating::drop)
    std::erase_if(order,
                  [&](Index i) { return points[i].normal_velocity > options.separating_speed; });
  if (options.method == Method::deepest_4) return deepest(points, order, options.per_pair);
  return PaperReduction(points, options)(order);
}

}  // namespace lcp
