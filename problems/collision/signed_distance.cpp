#include "problems/collision/signed_distance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lcp::collision {

namespace {

/// After so many halvings an interval of [0, 1] is as narrow as rounding.
constexpr int kHalvings = 54;

SignedDistance from_core(const Vector3d& away, double radius) {
  const double norm = away.norm();
  return {norm - radius, norm > 0 ? Vector3d(away / norm) : Vector3d::Zero(), norm};
}

struct Distance {
  const Vector3d& x;

  SignedDistance operator()(const Sphere& sphere) const { return from_core(x, sphere.radius); }
  SignedDistance operator()(const Capsule& capsule) const {
    const double half = capsule.length / 2;
    return from_core({x.x(), x.y(), x.z() - std::clamp(x.z(), -half, half)}, capsule.radius);
  }
  SignedDistance operator()(const Box& box) const {
    const Vector3d beyond = x.cwiseAbs() - box.edges / 2;
    const Vector3d outside = beyond.cwiseMax(0);
    SignedDistance found;
    if (outside.squaredNorm() > 0) {
      found = from_core(outside, 0);
    } else {
      Index face = 0;
      found.distance = found.to_core = beyond.maxCoeff(&face);
      found.normal(face) = 1;
    }
    for (int i = 0; i < 3; ++i) found.normal(i) = std::copysign(found.normal(i), x(i));
    return found;
  }
  SignedDistance operator()(const Cylinder& cylinder) const {
    const double r = std::hypot(x.x(), x.y());
    const double beyond_side = r - cylinder.radius;
    const double beyond_end = std::abs(x.z()) - cylinder.length / 2;
    const Vector3d radial = r > 0 ? Vector3d(x.x() / r, x.y() / r, 0) : Vector3d::Zero();
    const Vector3d axial(0, 0, std::copysign(1, x.z()));
    if (beyond_side > 0 && beyond_end > 0) {
      const double distance = std::hypot(beyond_side, beyond_end);
      return {distance, (beyond_side * radial + beyond_end * axial) / distance, distance};
    }
    if (beyond_side > beyond_end) return {beyond_side, radial, beyond_side};
    return {beyond_end, axial, beyond_end};
  }
  template <class Other>
  SignedDistance operator()(const Other&) const {
    throw std::logic_error("signed distance: expected a sphere, capsule, box or cylinder");
  }
};

}  // namespace

SignedDistance signed_distance(const Geometry& solid, const Vector3d& point) {
  return std::visit(Distance{point}, solid);
}

double DistanceAlong::nearest(const Vector3d& point) const {
  if (length_ == 0) return 0;
  return std::clamp((point - from_).dot(along_) / along_.squaredNorm(), 0.0, 1.0);
}

double DistanceAlong::rises_at(double slope) const {
  if (length_ == 0) return 0;
  const auto rises = [&](double s) { return at(s).normal.dot(along_) >= slope * length_; };
  if (rises(0)) return 0;
  if (!rises(1)) return 1;
  double below = 0, above = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (below + above) / 2;
    (rises(middle) ? above : below) = middle;
  }
  return above;
}

}  // namespace lcp::collision
