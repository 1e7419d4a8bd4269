#include "problems/rigid/joint_space.h"

#include "problems/rigid/transmission.h"
#include "solvers/errors.h"

namespace lcp {

namespace {

/// Of each link, at the origin of its frame.
std::vector<Matrix6d> own_inertias(const Model& model, const Kinematics& k) {
  std::vector<Matrix6d> inertias;
  for (Index i = 0; i < model.size(); ++i) {
    const Link& link = model.link(i);
    const Matrix3d& R = k.pose[i].R;
    inertias.push_back(
        spatial_inertia(link.mass, R * link.centre, R * link.inertia * R.transpose()));
  }
  return inertias;
}

/// S of a joint at its own point.
Space own_motions(const Model& model, const Kinematics& k, Index i) {
  if (model.link(i).joint == JointKind::free) return Space::Identity(6, 6);
  Space S = k.S[i];
  S.bottomRows<3>().setZero();
  return S;
}

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

/// M_ij = S_i' M_j^c S_j for j carried by i, with the inertia M_j^c of all that j carries; at each
/// joint's own point, as at O the entries of far light links would drown those along their axes.
MatrixXd JointSpace::mass_matrix(const Kinematics& k) const {
  std::vector<Matrix6d> carried = own_inertias(*model_, k);
  MatrixXd M = MatrixXd::Zero(velocities_, velocities_);
  for (Index j = model_->size() - 1; j >= 0; --j) {
    const Index parent = model_->link(j).parent;
    if (parent != Link::world) {
      const Matrix6d X = moved_by(k.pose[j].p - k.pose[parent].p);
      carried[parent] += X.transpose() * carried[j] * X;
    }
    if (columns(j) == 0) continue;
    const Space force = carried[j] * own_motions(*model_, k, j);
    for (Index i = j; i != Link::world; i = model_->link(i).parent) {
      if (columns(i) == 0) continue;  // the lower triangle: parents come first
      const Matrix6d X = moved_by(k.pose[j].p - k.pose[i].p);
      M.block(column_of_[j], column_of_[i], columns(j), columns(i)) =
          force.transpose() * X * own_motions(*model_, k, i);
    }
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
    const Vector3d& joint = k.loops[i].pose.p;
    Matrix6d free = Matrix6d::Zero();
    for (const Index link : {loop.link1, loop.link2}) {
      if (link == Link::world) continue;
      const Matrix6d X = moved_by(joint - k.pose[link].p);
      free += X * link_mobility(*model_, k, link) * X.transpose();
    }
    const VectorXd unit = (T.transpose() * free * T).diagonal().cwiseSqrt().cwiseInverse();
    const MatrixXd rows = unit.asDiagonal() * T.transpose() * moved_by(k.from_origin(joint));
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
    throw InvalidArgument("joint space: J has {} columns, expected {}", J.cols(),
                          6 * handles_.size());
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
