#include "problems/rigid/model.h"

#include <fmt/format.h>

#include <cmath>

#include "solvers/errors.h"

namespace lcp {

namespace {

using Eigen::Quaterniond;

/// How far an axis may be from unit length and an inertia from symmetry (relative): rounding.
constexpr double kRounding = 1e-9;

void check_link(const std::vector<Link>& links, Index i) {
  const Link& link = links[i];
  const auto require = [&](bool holds, const std::string& what) {
    if (!holds) throw InvalidArgument("link {} '{}': {}", i, link.name, what);
  };
  require(link.parent >= Link::world && link.parent < i,
          fmt::format("parent is {}, expected -1 (the world) ... {}", link.parent, i - 1));
  require(link.joint != JointKind::free || link.parent == Link::world,
          "a free joint needs the world as parent");
  require(link.mass > 0 && std::isfinite(link.mass),
          fmt::format("mass is {} kg, expected more than 0", link.mass));
  require(std::abs(link.axis.norm() - 1) <= kRounding, "axis is not of unit length");
  require(link.centre.allFinite() && link.in_parent.p.allFinite(),
          "centre of mass or place in the parent is not finite");
  require(is_rotation(link.in_parent.R), "frame in the parent is not a rotation");
  const bool symmetric = (link.inertia - link.inertia.transpose()).cwiseAbs().maxCoeff() <=
                         kRounding * link.inertia.cwiseAbs().maxCoeff();
  require(link.inertia.allFinite() && symmetric && link.inertia.llt().info() == Eigen::Success,
          "inertia is not symmetric and positive definite");
  const bool damps = link.joint == JointKind::revolute || link.joint == JointKind::ball;
  require(link.damping == 0 || (damps && link.damping > 0 && std::isfinite(link.damping)),
          fmt::format("damping is {} N m s/rad, expected 0, or more in a revolute or ball joint",
                      link.damping));
}

void check_loop(const std::vector<Loop>& loops, Index i, Index links) {
  const Loop& loop = loops[i];
  const auto require = [&](bool holds, const std::string& what) {
    if (!holds) throw InvalidArgument("loop {} '{}': {}", i, loop.name, what);
  };
  require(loop.link1 >= Link::world && loop.link1 < links && loop.link2 >= 0 &&
              loop.link2 < links && loop.link1 != loop.link2,
          fmt::format("joins {} and {}, expected two of the links 0 ... {}, the first perhaps -1 "
                      "(the world)",
                      loop.link1, loop.link2, links - 1));
  require(loop.joint == JointKind::ball || loop.joint == JointKind::revolute ||
              loop.joint == JointKind::fixed,
          "the joint is neither ball nor revolute nor fixed");
  require(std::abs(loop.axis.norm() - 1) <= kRounding, "axis is not of unit length");
  for (const Pose* pose : {&loop.in_link1, &loop.in_link2})
    require(pose->p.allFinite() && is_rotation(pose->R), "a frame is not finite and a rotation");
  require(loop.closing_rate >= 0 && std::isfinite(loop.closing_rate),
          fmt::format("closing rate is {} 1/s, expected at least 0", loop.closing_rate));
}

void write_quaternion(const Quaterniond& rotation, VectorXd& q, Index at) {
  q.segment<4>(at) = rotation.coeffs();
}

Quaterniond rotation_by(const Vector3d& angles) {
  const double angle = angles.norm();
  if (angle == 0) return Quaterniond::Identity();
  return Quaterniond(Eigen::AngleAxisd(angle, angles / angle));
}

}  // namespace

Model::Model(std::vector<Link> links, std::vector<Loop> loops)
    : links_(std::move(links)), loops_(std::move(loops)) {
  for (Index i = 0; i < size(); ++i) {
    check_link(links_, i);
    q_of_.push_back(coordinates_);
    u_of_.push_back(velocities_);
    coordinates_ += lcp::coordinates(links_[i].joint);
    velocities_ += lcp::velocities(links_[i].joint);
    inverse_inertia_.push_back(links_[i].inertia.inverse());
    if (links_[i].joint == JointKind::prescribed) prescribed_.push_back(i);
  }
  for (Index i = 0; i < static_cast<Index>(loops_.size()); ++i) check_loop(loops_, i, size());
}

double Model::mass() const {
  double sum = 0;
  for (const Link& link : links_) sum += link.mass;
  return sum;
}

Index Model::find(const std::string& name) const {
  for (Index i = 0; i < size(); ++i)
    if (links_[i].name == name) return i;
  throw InvalidArgument("model has no link '{}'", name);
}

State state_at_zero(const Model& model) {
  State state{VectorXd::Zero(model.coordinates()), VectorXd::Zero(model.velocities()), 0};
  for (Index i = 0; i < model.size(); ++i)
    if (const Index at = joint_sizes(model.link(i).joint).quaternion; at >= 0)
      state.q(model.q_of(i) + at + 3) = 1;
  return state;
}

VectorXd coordinate_rates(const Model& model, const VectorXd& q, const VectorXd& u) {
  VectorXd rates(model.coordinates());
  for (Index i = 0; i < model.size(); ++i) {
    const JointKind kind = model.link(i).joint;
    const Index at = model.q_of(i), from = model.u_of(i);
    if (kind == JointKind::revolute || kind == JointKind::prescribed) {
      rates(at) = u(from);
    } else if (kind == JointKind::ball) {  // angular velocity in link axes: from the right
      const Quaterniond spin(0, u(from), u(from + 1), u(from + 2));
      rates.segment<4>(at) = 0.5 * (read_quaternion(q, at) * spin).coeffs();
    } else if (kind == JointKind::free) {  // in world axes: from the left
      const Quaterniond spin(0, u(from), u(from + 1), u(from + 2));
      rates.segment<3>(at) = u.segment<3>(from + 3);
      rates.segment<4>(at + 3) = 0.5 * (spin * read_quaternion(q, at + 3)).coeffs();
    }
  }
  return rates;
}

VectorXd damping_torques(const Model& model, const VectorXd& u) {
  VectorXd torques = VectorXd::Zero(model.velocities());
  for (Index i = 0; i < model.size(); ++i) {
    const Index at = model.u_of(i), size = velocities(model.link(i).joint);
    torques.segment(at, size) = -model.link(i).damping * u.segment(at, size);
  }
  return torques;
}

VectorXd moved(const Model& model, const VectorXd& q, const VectorXd& u, double dt) {
  VectorXd after = q;
  for (Index i = 0; i < model.size(); ++i) {
    const JointKind kind = model.link(i).joint;
    const Index at = model.q_of(i), from = model.u_of(i);
    if (kind == JointKind::revolute || kind == JointKind::prescribed) {
      after(at) += dt * u(from);
    } else if (kind == JointKind::ball) {
      write_quaternion(read_quaternion(q, at) * rotation_by(dt * u.segment<3>(from)), after, at);
    } else if (kind == JointKind::free) {
      after.segment<3>(at) += dt * u.segment<3>(from + 3);
      write_quaternion(rotation_by(dt * u.segment<3>(from)) * read_quaternion(q, at + 3), after,
                       at + 3);
    }
  }
  normalise(model, after);
  return after;
}

void normalise(const Model& model, VectorXd& q) {
  for (Index i = 0; i < model.size(); ++i)
    if (const Index at = joint_sizes(model.link(i).joint).quaternion; at >= 0)
      q.segment<4>(model.q_of(i) + at).normalize();
}

}  // namespace lcp
