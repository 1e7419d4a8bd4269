#include "problems/rigid/joint_space.h"

#include <fmt/format.h>

#include <stdexcept>

#include "problems/rigid/transmission.h"

namespace lcp {

namespace {

/// Q'B for the orthonormal columns Q across the range of C, whose directions count as redundant
/// where the square of what the others leave of them is below `redundancy`.
MatrixXd what_is_left(const MatrixXd& C, MatrixXd B, double redundancy) {
  const Eigen::ColPivHouseholderQR<MatrixXd> held(C);
  const Index rank = (held.matrixQR().diagonal().array().square() > redundancy).count();
  B.applyOnTheLeft(held.householderQ().setLength(rank).adjoint());
  return B.bottomRows(B.rows() - rank);
}

}  // namespace

JointSpace::JointSpace(const Model& model, std::vector<Index> handles,
                       const AssemblyOptions& options)
    : model_(&model), handles_(std::move(handles)), options_(options) {
  check_handles(model, handles_, "joint space");
  for (Index i = 0; i < model.size(); ++i) {
    column_of_.push_back(velocities_);
    velocities_ += columns(i);
  }
}

Index JointSpace::columns(Index link) const {
  const JointKind kind = model_->link(link).joint;
  return kind == JointKind::prescribed ? 0 : lcp::velocities(kind);
}

/// M_ij = S_i' M_j^c S_j for j carried by i, with the inertia M_j^c of all that j carries.
MatrixXd JointSpace::mass_matrix(const Kinematics& k) const {
  std::vector<Matrix6d> carried(model_->size(), Matrix6d::Zero());
  MatrixXd M = MatrixXd::Zero(velocities_, velocities_);
  for (Index j = model_->size() - 1; j >= 0; --j) {
    carried[j] += link_inertia(*model_, k, j);
    const Index parent = model_->link(j).parent;
    if (parent != Link::world) carried[parent] += carried[j];
    if (columns(j) == 0) continue;
    const Space force = carried[j] * k.S[j];
    for (Index i = j; i != Link::world; i = model_->link(i).parent)
      if (columns(i) > 0)  // the lower triangle: parents come first
        M.block(column_of_[j], column_of_[i], columns(j), columns(i)) = force.transpose() * k.S[i];
  }
  return M;
}

/// Rows that act on the links' velocities (rows x 6 links) as rows that act on u (rows x n).
MatrixXd JointSpace::of_joints(const Kinematics& k, MatrixXd of_links) const {
  MatrixXd found(of_links.rows(), velocities_);
  for (Index i = model_->size() - 1; i >= 0; --i) {
    const auto own = of_links.middleCols<6>(6 * i);
    if (columns(i) > 0) found.middleCols(column_of_[i], columns(i)) = own * k.S[i];
    const Index parent = model_->link(i).parent;
    if (parent != Link::world) of_links.middleCols<6>(6 * parent) += own;
  }
  return found;
}

/// G, each row scaled so that the two links by themselves would answer by 1 to a unit force along
/// it: rows of angles and of lengths become comparable, and what a row answers is the share of
/// that.
MatrixXd JointSpace::loop_rates(const Kinematics& k) const {
  MatrixXd of_links(0, 6 * model_->size());
  for (Index i = 0; i < static_cast<Index>(model_->loops().size()); ++i) {
    const Loop& loop = model_->loops()[i];
    const Space T = loop_transmission(*model_, k, i).T;
    const Matrix6d free =
        link_mobility(*model_, k, loop.link1) + link_mobility(*model_, k, loop.link2);
    const VectorXd unit = (T.transpose() * free * T).diagonal().cwiseSqrt().cwiseInverse();
    const MatrixXd rows = unit.asDiagonal() * T.transpose();
    of_links.conservativeResize(of_links.rows() + T.cols(), Eigen::NoChange);
    auto added = of_links.bottomRows(T.cols());
    added.setZero();
    added.middleCols<6>(6 * loop.link2) = rows;
    if (loop.link1 != Link::world) added.middleCols<6>(6 * loop.link1) = -rows;
  }
  return of_joints(k, std::move(of_links));
}

MatrixXd JointSpace::contact_factor(const Kinematics& k, const MatrixXd& J) const {
  if (J.cols() != 6 * static_cast<Index>(handles_.size()))
    throw std::invalid_argument(
        fmt::format("joint space: J has {} columns, expected {}", J.cols(), 6 * handles_.size()));
  MatrixXd of_links = MatrixXd::Zero(J.rows(), 6 * model_->size());
  for (std::size_t h = 0; h < handles_.size(); ++h)
    of_links.middleCols<6>(6 * handles_[h]) = J.middleCols<6>(6 * h);
  MatrixXd B = of_joints(k, std::move(of_links)).transpose();
  if (velocities_ == 0) return B;

  const Eigen::LLT<MatrixXd> factor(mass_matrix(k));
  factor.matrixL().solveInPlace(B);
  if (model_->loops().empty()) return B;

  MatrixXd C = loop_rates(k).transpose();
  factor.matrixL().solveInPlace(C);
  return what_is_left(C, std::move(B), options_.redundancy);
}

}  // namespace lcp
