#pragma once

#include <Eigen/Dense>

namespace lcp {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Spatial vectors in world axes at one point O, at rest, that all bodies share: a motion
/// (omega; v_O) holds a body's angular velocity and the velocity of its point at O, a force (n_O; f)
/// the moment about O and the force. Pairing them, m'f, is power.
///
/// Source: R. Featherstone, Rigid Body Dynamics Algorithms (2008), 2.
using Vector6d = Eigen::Vector<double, 6>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
/// Columns span a space of motions or forces; at most 6, on the stack.
using Space = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

/// Where a body's frame stands: x_world = R x_body + p.
struct Pose {
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero();

  Vector3d operator*(const Vector3d& x) const { return R * x + p; }
  Pose operator*(const Pose& inner) const { return {R * inner.R, R * inner.p + p}; }
};

/// Up to rounding.
inline bool is_rotation(const Matrix3d& R) {
  constexpr double rounding = 1e-9;
  return R.allFinite() && R.determinant() > 0 && (R.transpose() * R).isIdentity(rounding);
}

inline Vector6d stack(const Vector3d& top, const Vector3d& bottom) {
  Vector6d whole;
  whole << top, bottom;
  return whole;
}

/// [v]x, so that [v]x u = v x u.
inline Matrix3d skew(const Vector3d& v) {
  Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// v x m: how fast a motion m that is carried along with v changes.
inline Vector6d cross_motion(const Vector6d& v, const Vector6d& m) {
  return stack(v.head<3>().cross(m.head<3>()),
               v.head<3>().cross(m.tail<3>()) + v.tail<3>().cross(m.head<3>()));
}

/// v x* f: the same for a force.
inline Vector6d cross_force(const Vector6d& v, const Vector6d& f) {
  return stack(v.head<3>().cross(f.head<3>()) + v.tail<3>().cross(f.tail<3>()),
               v.head<3>().cross(f.tail<3>()));
}

/// A force `f` acting at `r` (from O).
inline Vector6d force_at(const Vector3d& r, const Vector3d& f) { return stack(r.cross(f), f); }

/// Velocity of the point at `r` (from O) of a body with motion v.
inline Vector3d velocity_at(const Vector3d& r, const Vector6d& v) {
  return v.tail<3>() + v.head<3>().cross(r);
}

/// Takes motions at a point to where they are at another, `d` from it; its transpose takes forces
/// back.
inline Matrix6d moved_by(const Vector3d& d) {
  Matrix6d X = Matrix6d::Identity();
  X.bottomLeftCorner<3, 3>() = -skew(d);
  return X;
}

/// A force at the point that is `d` from where it is now.
inline Vector6d force_moved(const Vector6d& f, const Vector3d& d) {
  return stack(f.head<3>() - d.cross(f.tail<3>()), f.tail<3>());
}

/// A motion likewise.
inline Vector6d motion_moved(const Vector6d& m, const Vector3d& d) {
  return stack(m.head<3>(), m.tail<3>() - d.cross(m.head<3>()));
}

/// Inertia of a body at O: centre of mass at c (from O), inertia I_c about it in world axes.
inline Matrix6d spatial_inertia(double mass, const Vector3d& c, const Matrix3d& I_c) {
  const Matrix3d cx = skew(c);
  Matrix6d M;
  M << I_c - mass * cx * cx, mass * cx, -mass * cx, mass * Matrix3d::Identity();
  return M;
}

/// Its inverse, built from 1/mass and I_c^-1: no small difference of large numbers.
inline Matrix6d inverse_spatial_inertia(double mass, const Vector3d& c,
                                        const Matrix3d& I_c_inverse) {
  const Matrix3d cx = skew(c);
  const Matrix3d lower = cx * I_c_inverse;
  Matrix6d inverse;
  inverse << I_c_inverse, lower.transpose(), lower, Matrix3d::Identity() / mass - lower * cx;
  return inverse;
}

}  // namespace lcp
