#pragma once

#include "problems/rigid/kinematics.h"
#include "tests/problems/contact/contact_cases.h"

namespace lcp::cases {

inline Vector3d random_vector(Uniform& uniform) {
  const double x = uniform(), y = uniform();
  return {x, y, uniform()};
}

inline Eigen::Quaterniond random_turn(Uniform& uniform) {
  Eigen::Vector4d q;
  do
    for (double& entry : q) entry = uniform();
  while (q.norm() > 1 || q.norm() < 0.1);
  return Eigen::Quaterniond(q.normalized());
}

/// About the centre of mass of a box with edges a, kg m^2.
inline Matrix3d box_inertia(double mass, const Vector3d& a) {
  const Vector3d squares = a.cwiseAbs2();
  return mass / 12 * Matrix3d((squares.sum() - squares.array()).matrix().asDiagonal());
}

/// A link of 0.5 to 2 kg and edges of 5 to 30 cm, its joint about an axis askew.
inline Link random_link(Index parent, JointKind joint, Uniform& uniform) {
  Link link;
  link.parent = parent;
  link.joint = joint;
  link.axis = (random_turn(uniform) * Vector3d::UnitX());
  link.in_parent = {random_turn(uniform).toRotationMatrix(), 0.2 * random_vector(uniform)};
  link.mass = uniform.between(0.5, 2);
  link.centre = 0.1 * random_vector(uniform);
  const Vector3d edges(uniform.between(0.05, 0.3), uniform.between(0.05, 0.3),
                       uniform.between(0.05, 0.3));
  const Matrix3d R = random_turn(uniform).toRotationMatrix();
  const Matrix3d inertia = R * box_inertia(link.mass, edges) * R.transpose();
  link.inertia = (inertia + inertia.transpose()) / 2;
  return link;
}

/// What a random system is made of.
struct Recipe {
  Index links = 8;
  JointKind base = JointKind::free;    ///< Joint of the first link, in the world.
  std::vector<JointKind> joints = {};  ///< Of the others, in turn; one of these is drawn.
  bool chain = false;                  ///< Each link hangs on the one before, not on any of them.
  bool second_root = false;            ///< The middle link stands in the world as well.
};

inline Model random_model(const Recipe& recipe, Uniform& uniform) {
  std::vector<Link> links{random_link(Link::world, recipe.base, uniform)};
  for (Index i = 1; i < recipe.links; ++i) {
    const auto draw = [&](std::size_t count) {
      return static_cast<Index>(uniform.between(0, static_cast<double>(count)));
    };
    const Index parent = recipe.chain ? i - 1 : draw(links.size());
    const JointKind joint = recipe.joints[draw(recipe.joints.size())];
    const bool root = recipe.second_root && i == recipe.links / 2;
    links.push_back(random_link(root ? Link::world : parent, root ? recipe.base : joint, uniform));
  }
  for (std::size_t i = 0; i < links.size(); ++i) links[i].name = "link" + std::to_string(i);
  return Model(std::move(links));
}

/// Any place, velocities of about 1.
inline State random_state(const Model& model, Uniform& uniform) {
  State state = state_at_zero(model);
  for (double& entry : state.u) entry = uniform();
  for (Index i = 0; i < model.size(); ++i) {
    const Index at = model.q_of(i);
    switch (model.link(i).joint) {
      case JointKind::fixed:
        break;
      case JointKind::revolute:
      case JointKind::prescribed:
        state.q(at) = uniform.between(-2, 2);
        break;
      case JointKind::ball:
        state.q.segment<4>(at) = random_turn(uniform).coeffs();
        break;
      case JointKind::free:
        state.q.segment<3>(at) = random_vector(uniform);
        state.q.segment<4>(at + 3) = random_turn(uniform).coeffs();
        break;
    }
  }
  return state;
}

inline VectorXd random_numbers(Index count, Uniform& uniform) {
  return VectorXd::NullaryExpr(count, [&uniform] { return uniform(); });
}

/// Largest difference, relative to the largest entry of `expected`.
inline double relative_error(const MatrixXd& actual, const MatrixXd& expected) {
  const double largest = expected.cwiseAbs().maxCoeff();
  const double error = (actual - expected).cwiseAbs().maxCoeff();
  return largest > 0 ? error / largest : error;
}

}  // namespace lcp::cases
