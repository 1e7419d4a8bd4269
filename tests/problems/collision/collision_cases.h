#pragma once

#include <numbers>

#include "problems/collision/collision.h"
#include "tests/problems/collision/exact_overlap.h"
#include "tests/problems/rigid/random_models.h"

namespace lcp::cases {

/// Links at these places.
inline Kinematics links_at(std::vector<Pose> poses) {
  Kinematics kinematics;
  kinematics.pose = std::move(poses);
  return kinematics;
}

/// Contacts of two solids, the first on link 1 (body 1 of the contacts), the second on link 0.
inline std::vector<ContactPoint> contacts_of(const Solid& first, const Solid& second) {
  collision::World world({{first.geometry, 1}, {second.geometry, 0}});
  return world.contacts(links_at({second.pose, first.pose}));
}

inline Pose random_pose(Uniform& uniform) {
  const Matrix3d R = random_turn(uniform).toRotationMatrix();
  return {R, 0.3 * random_vector(uniform)};
}

/// Of 1 to 10 cm.
inline collision::Geometry random_geometry(const std::string& kind, Uniform& uniform) {
  const double radius = uniform.between(0.005, 0.02), length = uniform.between(0.02, 0.1);
  const double x = uniform.between(0.01, 0.06), y = uniform.between(0.01, 0.06);
  if (kind == "sphere") return collision::Sphere{radius};
  if (kind == "capsule") return collision::Capsule{radius, length};
  if (kind == "cylinder") return collision::Cylinder{radius, length};
  return collision::Box{{x, y, length}};
}

/// Moves the first so that it overlaps the second by about `depth` (see exact_overlap: by less,
/// where samples are too large) in a random direction from it.
inline void bring_together(Solid& first, const Solid& second, double depth, Uniform& uniform) {
  const Vector3d away = random_vector(uniform).normalized();
  double near = 0, far = 0.3;
  constexpr int halvings = 14;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (near + far) / 2;
    first.pose.p = second.pose.p + middle * away;
    (exact_overlap(first, second, false).depth > depth ? near : far) = middle;
  }
}

/// A circle of `count` corners in the plane z = 0.
inline collision::Ring round_ring(double circle_radius, double wire_radius, Index count) {
  collision::Ring ring{{}, wire_radius};
  for (Index k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    ring.corners.emplace_back(circle_radius * std::cos(angle), circle_radius * std::sin(angle), 0);
  }
  return ring;
}

inline Pose turned_about(const Vector3d& axis, double angle, const Vector3d& place) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), place};
}

}  // namespace lcp::cases
