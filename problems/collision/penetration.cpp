#include "problems/collision/penetration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace lcp::collision {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// Sine of the angle under which edges are parallel: rounding.
constexpr double kParallel = 1e-12;
/// Directions at which a great circle is looked at first.
constexpr int kSamples = 24;
constexpr int kRefinements = 64;
/// Two directions nearer than this (rad) are one: rounding.
constexpr double kSameDirection = 1e-15;
constexpr int kNewtonSteps = 30;
constexpr int kNewtonHalvings = 12;
/// Slope at which Newton's method stops, relative to the sizes.
constexpr double kFlatSlope = 1e-12;
/// How far from a direction's plane a rim may lie so that both rims are tried (cosine).
constexpr double kEitherRim = 1e-6;
/// From how far beyond it (cosine) a search for one rim's minimum does not come back.
constexpr double kFarSide = 0.05;
/// Longest step, rad, and least curvature, relative to the sizes, that it reckons with.
constexpr double kLongestStep = 0.5, kLeastCurvature = 1e-3;
/// How far from a cylinder's axis, rad, a start lies.
constexpr double kBesideAxis = 0.05;
/// So many of the circles' minima are starts.
constexpr std::size_t kStarts = 4;

class Search {
 public:
  Search(const Convex& first, const Convex& second, const Vector3d& offset)
      : first_(first), second_(second), offset_(offset) {}

  Penetration find() {
    if (first_.is_box() && second_.is_box()) {
      search_boxes();
      return best_;
    }
    for (const Convex* solid : {&first_, &second_}) {
      if (solid->is_box()) continue;
      for (const Vector3d& d : {Vector3d(solid->axis()), Vector3d(-solid->axis())}) {
        offer(d);
        // Beside the axis, where its end's rim takes part.
        const Vector3d w = gradient(d) - solid->support(d);
        const Vector3d down = d * d.dot(w) - w;
        if (down.norm() > 0) {
          const Vector3d start = (d + kBesideAxis * down.normalized()).normalized();
          minima_.push_back({start, gradient(start).dot(start)});
        }
      }
    }
    for (const Convex* solid : {&first_, &second_})
      for (int i = solid->is_box() ? 0 : 2; i < 3 && !separated(); ++i)
        search_circle(solid->axes().col((i + 1) % 3), solid->axes().col((i + 2) % 3));
    if (!first_.is_box() && !second_.is_box()) {
      std::sort(minima_.begin(), minima_.end(),
                [](const Penetration& a, const Penetration& b) { return a.depth < b.depth; });
      if (minima_.size() > kStarts) minima_.resize(kStarts);
      for (const Penetration& start : minima_)
        if (!separated()) search_rims(start.normal);
    }
    return best_;
  }

 private:
  bool separated() const { return best_.depth < 0; }

  /// d overlap / d direction: the overlap is its product with the direction.
  Vector3d gradient(const Vector3d& d) const {
    return first_.support(d) + second_.support(d) - offset_;
  }

  void offer(const Vector3d& d) {
    const double overlap = gradient(d).dot(d);
    if (overlap < best_.depth) best_ = {d, overlap};
  }

  /// Of two boxes no more than their faces' normals and those of pairs of edges count.
  void search_boxes() {
    for (const Convex* box : {&first_, &second_})
      for (int i = 0; i < 3; ++i) offer_both(box->axes().col(i));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Vector3d across = first_.axes().col(i).cross(second_.axes().col(j));
        if (across.norm() > kParallel) offer_both(across.normalized());
      }
    }
  }

  void offer_both(const Vector3d& d) {
    offer(d);
    offer(-d);
  }

  /// A direction on a circle and the gradient there, in the circle's plane.
  struct Sample {
    Vector2d d, w;
    double overlap() const { return w.dot(d); }
    double slope() const { return w.y() * d.x() - w.x() * d.y(); }
  };

  void search_circle(const Vector3d& u, const Vector3d& v) {
    const auto at = [&](const Vector2d& d) -> Sample {
      const Vector3d w = gradient(d.x() * u + d.y() * v);
      return {d, {w.dot(u), w.dot(v)}};
    };
    std::array<Sample, kSamples> around;
    for (int i = 0; i < kSamples; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSamples;
      around[i] = at({std::cos(angle), std::sin(angle)});
      if (around[i].overlap() < 0) {
        best_ = {around[i].d.x() * u + around[i].d.y() * v, around[i].overlap()};
        return;
      }
    }
    for (int i = 0; i < kSamples && !separated(); ++i) {
      Sample left = around[i], right = around[(i + 1) % kSamples];
      if (left.slope() >= 0 || right.slope() < 0) continue;
      Sample least = left.overlap() < right.overlap() ? left : right;
      for (int k = 0; k < kRefinements; ++k) {
        const Vector2d difference = left.w - right.w;
        Vector2d d = Vector2d(-difference.y(), difference.x()).normalized();
        if (d.dot(left.d + right.d) < 0) d = -d;
        if (!(left.w.dot(d) < best_.depth)) break;
        const Sample middle = at(d);
        if (middle.overlap() <= least.overlap()) least = middle;
        const bool rises = middle.slope() >= 0;
        if ((d - (rises ? right : left).d).norm() <= kSameDirection) break;
        (rises ? right : left) = middle;
      }
      const Vector3d d = least.d.x() * u + least.d.y() * v;
      minima_.push_back({d, least.overlap()});
      offer(d);
    }
  }

  /// Newton's method on the overlap of one rim of each cylinder, from `start`.
  void search_rims(const Vector3d& start) {
    for (const double side1 : {-1.0, 1.0}) {
      for (const double side2 : {-1.0, 1.0}) {
        const bool plausible = side1 * first_.axis().dot(start) > -kEitherRim &&
                               side2 * second_.axis().dot(start) > -kEitherRim;
        if (plausible) descend(start, side1, side2);
      }
    }
  }

  void descend(Vector3d d, double side1, double side2) {
    const auto rims = [&](const Vector3d& at) -> Vector3d {
      return first_.rim_support(at, side1) + second_.rim_support(at, side2) - offset_;
    };
    const double size = first_.radius() + second_.radius();
    Vector3d w = rims(d);
    for (int k = 0; k < kNewtonSteps; ++k) {
      Eigen::Matrix<double, 3, 2> plane;
      plane.col(0) = d.unitOrthogonal();
      plane.col(1) = d.cross(plane.col(0));
      // On the far side of a plane the other rim is the farther one.
      if (std::min(side1 * first_.axis().dot(d), side2 * second_.axis().dot(d)) < -kFarSide) return;
      const Vector2d slope = plane.transpose() * w;
      if (slope.norm() <= kFlatSlope * size) break;
      Matrix2d curvature = -w.dot(d) * Matrix2d::Identity();
      for (const Convex* solid : {&first_, &second_}) {
        const Vector3d tangent = solid->axis().cross(d);
        const double sine = tangent.norm();
        if (sine == 0) return;  // along an axis: no rim takes part
        const Vector2d across = plane.transpose() * (tangent / sine);
        curvature += solid->radius() / sine * across * across.transpose();
      }
      // With curvatures made positive a step leads down from saddles, too.
      Eigen::SelfAdjointEigenSolver<Matrix2d> principal;
      principal.computeDirect(curvature);
      const Vector2d curvatures =
          principal.eigenvalues().cwiseAbs().cwiseMax(kLeastCurvature * size);
      const Vector2d rates = principal.eigenvectors().transpose() * slope;
      Vector2d step = -principal.eigenvectors() * rates.cwiseQuotient(curvatures);
      step *= std::min(1.0, kLongestStep / step.norm());
      bool lower = false;
      for (int halving = 0; halving < kNewtonHalvings && !lower; ++halving, step /= 2) {
        const Vector3d trial = (d + plane * step).normalized();
        const Vector3d w_trial = rims(trial);
        lower = w_trial.dot(trial) < w.dot(d);
        if (lower) {
          d = trial;
          w = w_trial;
        }
      }
      if (!lower) break;
    }
    offer(d);
  }

  const Convex &first_, &second_;
  Vector3d offset_;
  std::vector<Penetration> minima_;
  Penetration best_{Vector3d::UnitZ(), std::numeric_limits<double>::infinity()};
};

}  // namespace

Convex::Convex(const Geometry& geometry, const Matrix3d& R) : R_(R) {
  if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
    radius_ = cylinder->radius;
    half_ = {0, 0, cylinder->length / 2};
  } else {
    half_ = std::get<Box>(geometry).edges / 2;
  }
}

Vector3d Convex::support(const Vector3d& direction) const {
  const Vector3d d = R_.transpose() * direction;
  if (!is_box()) return rim_support(direction, d.z() < 0 ? -1 : 1);
  return R_ * Vector3d(std::copysign(half_.x(), d.x()), std::copysign(half_.y(), d.y()),
                       std::copysign(half_.z(), d.z()));
}

Vector3d Convex::rim_support(const Vector3d& direction, double side) const {
  const Vector3d d = R_.transpose() * direction;
  const double across = std::hypot(d.x(), d.y());
  const double scale = across > 0 ? radius_ / across : 0;
  return R_ * Vector3d(scale * d.x(), scale * d.y(), side * half_.z());
}

Convex::Face Convex::face(const Vector3d& direction, double flat) const {
  const Vector3d d = R_.transpose() * direction;
  std::vector<Vector3d> points;
  double round = 0;
  if (is_box()) {
    // Counter-clockwise in the plane of the free axes.
    constexpr std::array<std::array<double, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    std::vector<int> free;
    for (int i = 0; i < 3; ++i)
      if (std::abs(d(i)) <= flat) free.push_back(i);
    const int count = 1 << free.size();
    for (int k = 0; k < count; ++k) {
      Vector3d point;
      for (int i = 0; i < 3; ++i) point(i) = std::copysign(half_(i), d(i));
      for (std::size_t i = 0; i < free.size(); ++i) point(free[i]) = signs[k][i] * half_(free[i]);
      points.push_back(point);
    }
  } else {
    const double across = std::hypot(d.x(), d.y());
    const double end = std::copysign(half_.z(), d.z());
    const double turn = across > kSameDirection ? std::atan2(d.y(), d.x()) : 0;
    const auto at_rim = [&](double angle, double z) {
      points.emplace_back(radius_ * std::cos(angle), radius_ * std::sin(angle), z);
    };
    if (across <= flat) {
      constexpr int corners = 8;
      for (int k = 0; k < corners; ++k) at_rim(turn + 2 * std::numbers::pi * k / corners, end);
    } else if (std::abs(d.z()) <= flat) {
      at_rim(turn, -half_.z());
      at_rim(turn, half_.z());
      round = radius_;
    } else {
      at_rim(turn, end);
    }
  }
  for (Vector3d& point : points) point = R_ * point;
  return {std::move(points), round};
}

Penetration penetration(const Convex& first, const Convex& second, const Vector3d& offset) {
  return Search(first, second, offset).find();
}

}  // namespace lcp::collision
