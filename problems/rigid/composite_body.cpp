#include <fmt/format.h>

#include <stdexcept>

#include "problems/rigid/forward_dynamics.h"

namespace lcp {

namespace {

Matrix6d composite_inertia(const Model& model, const Kinematics& k) {
  Matrix6d M = Matrix6d::Zero();
  for (Index i = 0; i < model.size(); ++i) M += link_inertia(model, k, i);
  return M;
}

/// Why the system does not move as one body; empty where it does.
std::string what_moves_apart(const Model& model) {
  if (model.size() == 0) return "the model has no links";
  if (!model.loops().empty()) return "the model has loops";
  for (Index i = 0; i < model.size(); ++i) {
    const Link& link = model.link(i);
    const bool rigid = link.joint == JointKind::prescribed || link.joint == JointKind::fixed;
    if (i == 0 ? link.joint != JointKind::free : !rigid || link.parent == Link::world)
      return fmt::format(
          "link {} '{}' does not move with the first, expected a free link that carries prescribed "
          "and fixed joints",
          i, link.name);
  }
  return "";
}

}  // namespace

bool moves_as_one_body(const Model& model) { return what_moves_apart(model).empty(); }

CompositeBody::CompositeBody(const Model& model, std::vector<Index> handles)
    : model_(&model), handles_(std::move(handles)) {
  check_handles(model, handles_, "composite body");
  if (const std::string obstacle = what_moves_apart(model); !obstacle.empty())
    throw std::invalid_argument("composite body: " + obstacle);
}

HandleDynamics CompositeBody::handle_dynamics(const Kinematics& k, const Vector3d& gravity) const {
  // Accelerations while the first link's is zero, and the force that would take.
  std::vector<Vector6d> relative(model_->size(), Vector6d::Zero());
  Vector6d force = Vector6d::Zero();
  for (Index i = 0; i < model_->size(); ++i) {
    const Link& link = model_->link(i);
    if (i > 0) relative[i] = relative[link.parent] + k.sigma[i];
    const Matrix6d M = link_inertia(*model_, k, i);
    force += M * relative[i] + cross_force(k.velocity[i], M * k.velocity[i]) -
             force_at(k.from_origin(k.pose[i] * link.centre), link.mass * gravity);
  }
  const Matrix6d M = composite_inertia(*model_, k);
  const Eigen::LLT<Matrix6d> factor(M);
  const Matrix6d inverse = factor.solve(Matrix6d::Identity());
  const Matrix6d Phi = 0.5 * (inverse + inverse.transpose());
  const Vector6d first = -factor.solve(force);

  const Index n = static_cast<Index>(handles_.size());
  HandleDynamics dynamics{Phi.replicate(n, n), VectorXd(6 * n),
                          std::vector<Vector3d>(n, Vector3d::Zero())};
  for (Index h = 0; h < n; ++h) dynamics.phi.segment<6>(6 * h) = first + relative[handles_[h]];
  return dynamics;
}

MatrixXd CompositeBody::contact_factor(const Kinematics& k, const MatrixXd& J) const {
  MatrixXd all = MatrixXd::Zero(J.rows(), 6);  // J acts on the sum of its blocks
  for (Index h = 0; h < J.cols() / 6; ++h) all += J.middleCols<6>(6 * h);
  const Matrix6d L = composite_inertia(*model_, k).llt().matrixL();
  return L.triangularView<Eigen::Lower>().solve(MatrixXd(all.transpose()));
}

}  // namespace lcp
