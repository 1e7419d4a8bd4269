#pragma once

#include <string>
#include <vector>

#include "problems/contact/contact_problem.h"

namespace lcp {

/// A free rigid body at one instant. Its twist (v, omega) is about its centre of mass, in world axes.
struct RigidBody {
  double mass = 0;                                             ///< kg.
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();           ///< Principal moments, kg m^2.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();          ///< Principal axes, as columns.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();            ///< m.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< v, m/s.
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< omega, rad/s.
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N, besides weight, at the centre.
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m.

  /// Velocity of the body's point at `position`, m/s.
  Eigen::Vector3d velocity_at(const Eigen::Vector3d& position) const {
    return velocity + angular_velocity.cross(position - centre);
  }
};

/// A contact with the place where it is.
struct PlacedContact {
  Contact contact;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m.
  double depth = 0;  ///< m: overlap, negative where there is a gap.
};

/// Principal moments of a homogeneous box with edges `size` (m) along its axes, kg m^2.
Eigen::Vector3d box_inertia(double mass, const Eigen::Vector3d& size);

/// M^-1/2 J' of one body for a unit force along `axis` at `position` (6): (axis / sqrt(m),
/// moment / sqrt(I)), the moment in principal axes.
Eigen::Vector<double, 6> weighted_push(const RigidBody& body, const Eigen::Vector3d& position,
                                       const Eigen::Vector3d& axis);

/// Points at equal shares of each edge of a rectangle of `length` along x and `width` along y in the
/// plane z = centre.z(), from the corner at +x, +y towards -x. With 4 k points all corners are among
/// them.
std::vector<Eigen::Vector3d> rectangle_outline(const Eigen::Vector3d& centre, double length,
                                               double width, Index points);

/// The contact problem of free bodies under gravity (9.81 m/s^2 along -z), body 0 of a ContactId
/// standing for the world and b for bodies[b - 1]. With A = M^-1/2 J',
///
///     W = dt A'A,   vbar = J (nu + dt M^-1 h),   v_before = J nu,
///
/// h holding weight, force, moment and the gyroscopic moment. The normal entry of vbar of a contact
/// with depth > 0 has 0.005 depth / dt taken off, which pushes the bodies apart.
///
/// Throws std::invalid_argument when an id names no body.
ContactProblem contact_problem(const std::vector<RigidBody>& bodies,
                               const std::vector<PlacedContact>& contacts, double dt);

/// `x,y,z` of every contact, separated by blanks, m, to the last digit: for provenance.
std::string spell_positions(const std::vector<PlacedContact>& contacts);

}  // namespace lcp
