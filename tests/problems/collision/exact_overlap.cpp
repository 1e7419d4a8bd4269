#include "tests/problems/collision/exact_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lcp::cases {

namespace {

using namespace collision;

constexpr int kCircleSamples = 72;
constexpr int kCoarseSamples = 24;
constexpr int kSphereSamples = 600;
constexpr int kGoldenSteps = 60;
constexpr int kPolishing = 6;
constexpr int kBrackets = 3;  // refined of each circle

/// h(d) about the centre, by the sizes alone.
double support(const Solid& solid, const Vector3d& direction) {
  const Vector3d d = solid.pose.R.transpose() * direction;
  if (const auto* box = std::get_if<Box>(&solid.geometry)) return box->edges.dot(d.cwiseAbs()) / 2;
  const auto& cylinder = std::get<Cylinder>(solid.geometry);
  return cylinder.length / 2 * std::abs(d.z()) + cylinder.radius * std::hypot(d.x(), d.y());
}

double distance_outside(const Solid& solid, const Vector3d& point) {
  const Vector3d x = solid.pose.R.transpose() * (point - solid.pose.p);
  if (const auto* box = std::get_if<Box>(&solid.geometry)) {
    const Vector3d q = x.cwiseAbs() - box->edges / 2;
    return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&solid.geometry)) {
    const double side = std::hypot(x.x(), x.y()) - cylinder->radius;
    const double end = std::abs(x.z()) - cylinder->length / 2;
    return std::hypot(std::max(side, 0.0), std::max(end, 0.0)) + std::min(std::max(side, end), 0.0);
  }
  if (const auto* sphere = std::get_if<Sphere>(&solid.geometry)) return x.norm() - sphere->radius;
  const auto& capsule = std::get<Capsule>(solid.geometry);
  const double half = capsule.length / 2;
  return (x - Vector3d(0, 0, std::clamp(x.z(), -half, half))).norm() - capsule.radius;
}

/// Where in [low, high] a function with one minimum has it.
template <class Function>
double golden_section(const Function& f, double low, double high) {
  constexpr double share = 0.3819660112501051;
  double a = low + share * (high - low), b = high - share * (high - low);
  double fa = f(a), fb = f(b);
  for (int k = 0; k < kGoldenSteps; ++k) {
    if (fa < fb) {
      high = b, b = a, fb = fa;
      a = low + share * (high - low), fa = f(a);
    } else {
      low = a, a = b, fa = fb;
      b = high - share * (high - low), fb = f(b);
    }
  }
  return fa < fb ? a : b;
}

/// A sphere or capsule: by the distance of its axis' points from the other.
Overlap of_axis(const Solid& round, const Solid& other) {
  const auto* capsule = std::get_if<Capsule>(&round.geometry);
  const double half = capsule ? capsule->length / 2 : 0;
  const double radius = capsule ? capsule->radius : std::get<Sphere>(round.geometry).radius;
  const auto point = [&](double s) { return round.pose * Vector3d(0, 0, s); };
  const auto f = [&](double s) { return distance_outside(other, point(s)); };
  double least = golden_section(f, -half, half);
  for (const double end : {-half, half})
    if (f(end) < f(least)) least = end;
  constexpr double h = 1e-7;
  Vector3d gradient;
  for (int i = 0; i < 3; ++i) {
    const Vector3d step = h * Vector3d::Unit(i);
    gradient(i) =
        distance_outside(other, point(least) + step) - distance_outside(other, point(least) - step);
  }
  return {radius - f(least), gradient.normalized()};
}

class Directions {
 public:
  Directions(const Solid& first, const Solid& second, bool refine)
      : first_(first), second_(second), refine_(refine) {}

  Overlap least() {
    const bool cylinders = std::holds_alternative<Cylinder>(first_.geometry) &&
                           std::holds_alternative<Cylinder>(second_.geometry);
    for (const Solid* solid : {&first_, &second_}) {
      const Matrix3d& R = solid->pose.R;
      for (int i = std::holds_alternative<Box>(solid->geometry) ? 0 : 2; i < 3; ++i) {
        offer(R.col(i));
        offer(-R.col(i));
        circle(R.col(i), R.col((i + 1) % 3));
      }
    }
    if (cylinders && refine_) sphere();
    return best_;
  }

 private:
  double overlap(const Vector3d& d) const {
    return support(first_, d) + support(second_, d) - d.dot(first_.pose.p - second_.pose.p);
  }

  void offer(const Vector3d& d) {
    if (const double depth = overlap(d); depth < best_.depth) best_ = {depth, d};
  }

  void circle(const Vector3d& axis, const Vector3d& u) {
    const Vector3d v = axis.cross(u);
    const auto at = [&](double angle) -> Vector3d {
      return std::cos(angle) * u + std::sin(angle) * v;
    };
    const int count = refine_ ? kCircleSamples : kCoarseSamples;
    const double step = 2 * std::numbers::pi / count;
    std::vector<std::pair<double, double>> samples, minima;
    for (int k = 0; k < count; ++k) {
      samples.emplace_back(overlap(at(k * step)), k * step);
      offer(at(k * step));
    }
    if (!refine_) return;
    for (int k = 0; k < count; ++k)
      if (samples[k] <= samples[(k + 1) % count] &&
          samples[k].first <= samples[(k + count - 1) % count].first)
        minima.push_back(samples[k]);
    std::sort(minima.begin(), minima.end());
    if (minima.size() > kBrackets) minima.resize(kBrackets);
    for (const auto& [depth, angle] : minima)
      offer(
          at(golden_section([&](double x) { return overlap(at(x)); }, angle - step, angle + step)));
  }

  /// Pattern search from the best of samples all over the sphere.
  void sphere() {
    std::vector<std::pair<double, Vector3d>> samples;
    for (int k = 0; k < kSphereSamples; ++k) {
      const double z = 1 - (2 * k + 1.0) / kSphereSamples, r = std::sqrt(1 - z * z);
      const double angle = k * std::numbers::pi * (3 - std::sqrt(5.0));
      const Vector3d d(r * std::cos(angle), r * std::sin(angle), z);
      samples.emplace_back(overlap(d), d);
    }
    std::sort(samples.begin(), samples.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    constexpr int starts = 4, directions = 12;
    for (int start = 0; start < starts; ++start) {
      auto [least, d] = samples[start];
      constexpr double narrowest = 1e-3;
      for (double step = 0.05; step > narrowest;) {
        const Vector3d u = d.unitOrthogonal(), v = d.cross(u);
        bool lower = false;
        for (int k = 0; k < directions && !lower; ++k) {
          const double angle = 2 * std::numbers::pi * k / directions;
          const Vector3d trial =
              (d + step * (std::cos(angle) * u + std::sin(angle) * v)).normalized();
          if (const double there = overlap(trial); there < least) {
            least = there;
            d = trial;
            lower = true;
          }
        }
        if (!lower) step /= 2;
      }
      offer(d);
      for (int k = 0; k < kPolishing; ++k) {
        d = newton_step(d);
        offer(d);
      }
    }
  }

  /// By central differences in the plane across d.
  Vector3d newton_step(const Vector3d& d) const {
    constexpr double h = 1e-5;
    const Vector3d u = d.unitOrthogonal(), v = d.cross(u);
    const auto f = [&](double x, double y) { return overlap((d + x * u + y * v).normalized()); };
    const Eigen::Vector2d g((f(h, 0) - f(-h, 0)) / (2 * h), (f(0, h) - f(0, -h)) / (2 * h));
    Eigen::Matrix2d H;
    H(0, 0) = (f(h, 0) - 2 * f(0, 0) + f(-h, 0)) / (h * h);
    H(1, 1) = (f(0, h) - 2 * f(0, 0) + f(0, -h)) / (h * h);
    H(0, 1) = H(1, 0) = (f(h, h) - f(h, -h) - f(-h, h) + f(-h, -h)) / (4 * h * h);
    const Eigen::Vector2d step = -H.inverse() * g;
    if (!(step.norm() < 0.1)) return d;
    return (d + step.x() * u + step.y() * v).normalized();
  }

  const Solid &first_, &second_;
  bool refine_;
  Overlap best_{std::numeric_limits<double>::infinity(), Vector3d::UnitZ()};
};

bool is_round(const Solid& solid) {
  return std::holds_alternative<Sphere>(solid.geometry) ||
         std::holds_alternative<Capsule>(solid.geometry);
}

}  // namespace

Overlap exact_overlap(const Solid& first, const Solid& second, bool refine) {
  if (is_round(first)) return of_axis(first, second);
  if (is_round(second)) {
    const Overlap turned = of_axis(second, first);
    return {turned.depth, -turned.normal};
  }
  return Directions(first, second, refine).least();
}

}  // namespace lcp::cases
