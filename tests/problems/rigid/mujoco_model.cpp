#include "tests/problems/rigid/mujoco_model.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "tests/harness/temporary_directory.h"

namespace lcp::cases {

namespace {

using Eigen::Quaterniond;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::string numbers(const VectorXd& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{:.17g} ", value);
  return text;
}

/// w x y z, as MuJoCo has it.
Eigen::Vector4d quaternion(const Matrix3d& R) {
  const Quaterniond turn = Quaterniond(R).normalized();
  return {turn.w(), turn.x(), turn.y(), turn.z()};
}

std::string name_of(Index link) { return fmt::format("link{}", link); }

std::string body_text(const Model& model, Index i) {
  const Link& link = model.link(i);
  std::string text = fmt::format("<body name=\"{}\" pos=\"{}\" quat=\"{}\">", name_of(i),
                                 numbers(link.in_parent.p), numbers(quaternion(link.in_parent.R)));
  if (link.joint == JointKind::free)
    text += "<freejoint/>";
  else if (link.joint == JointKind::ball)
    text += "<joint type=\"ball\"/>";
  else if (link.joint != JointKind::fixed)
    text += fmt::format("<joint type=\"hinge\" axis=\"{}\"/>", numbers(link.axis));
  const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(link.inertia);
  Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  text += fmt::format("<inertial mass=\"{:.17g}\" pos=\"{}\" quat=\"{}\" diaginertia=\"{}\"/>",
                      link.mass, numbers(link.centre), numbers(quaternion(axes)),
                      numbers(principal.eigenvalues()));
  for (Index child = i + 1; child < model.size(); ++child)
    if (model.link(child).parent == i) text += body_text(model, child);
  return text + "</body>\n";
}

std::string mjcf(const Model& model, const Vector3d& gravity) {
  std::string text = fmt::format(
      "<mujoco><compiler angle=\"radian\"/><option gravity=\"{}\">"
      "<flag contact=\"disable\" constraint=\"disable\"/></option><worldbody>\n",
      numbers(gravity));
  for (Index i = 0; i < model.size(); ++i)
    if (model.link(i).parent == Link::world) text += body_text(model, i);
  return text + "</worldbody></mujoco>\n";
}

mjModel* load(const Model& model, const Vector3d& gravity) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("model.xml");
  write_text(path, mjcf(model, gravity));
  std::array<char, 1000> error{};
  mjModel* loaded = mj_loadXML(path.c_str(), nullptr, error.data(), error.size());
  if (!loaded) throw std::runtime_error(fmt::format("MuJoCo: {}", error.data()));
  return loaded;
}

}  // namespace

MuJoCoModel::MuJoCoModel(const Model& model, const Vector3d& gravity)
    : ours_(model),
      model_(load(model, gravity), mj_deleteModel),
      data_(mj_makeData(model_.get()), mj_deleteData) {
  for (Index i = 0; i < model.size(); ++i)
    body_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, name_of(i).c_str()));
}

void MuJoCoModel::set(const State& state) {
  for (Index i = 0; i < ours_.size(); ++i) {
    const JointKind kind = ours_.link(i).joint;
    if (kind == JointKind::fixed) continue;
    Index to = model_->jnt_qposadr[model_->body_jntadr[body(i)]], from = ours_.q_of(i);
    if (kind == JointKind::free)
      for (int k = 0; k < 3; ++k) data_->qpos[to++] = state.q(from++);
    if (kind == JointKind::revolute || kind == JointKind::prescribed) {
      data_->qpos[to] = state.q(from);
    } else {
      data_->qpos[to] = state.q(from + 3);
      for (int k = 0; k < 3; ++k) data_->qpos[to + 1 + k] = state.q(from + k);
    }
  }
  Eigen::Map<VectorXd> velocity(data_->qvel, model_->nv);
  mj_kinematics(model_.get(), data_.get());  // rotations, which the map needs
  velocity = velocity_map() * state.u;
  mj_forward(model_.get(), data_.get());
}

MatrixXd MuJoCoModel::velocity_map() const {
  MatrixXd T = MatrixXd::Zero(model_->nv, ours_.velocities());
  for (Index i = 0; i < ours_.size(); ++i) {
    const Index to = model_->body_dofadr[body(i)], from = ours_.u_of(i);
    if (ours_.link(i).joint != JointKind::free) {
      const Index size = velocities(ours_.link(i).joint);
      if (size > 0) T.block(to, from, size, size).setIdentity();
      continue;
    }
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R(data_->xmat +
                                                                           9 * body(i));
    T.block<3, 3>(to, from + 3).setIdentity();
    T.block<3, 3>(to + 3, from) = R.transpose();
  }
  return T;
}

MatrixXd MuJoCoModel::mass_matrix() const {
  RowMatrix M(model_->nv, model_->nv);
  mj_fullM(model_.get(), M.data(), data_->qM);
  const MatrixXd T = velocity_map();
  return T.transpose() * M * T;
}

VectorXd MuJoCoModel::bias() const {
  return velocity_map().transpose() * Eigen::Map<const VectorXd>(data_->qfrc_bias, model_->nv);
}

MatrixXd MuJoCoModel::jacobian(Index link, const Vector3d& origin) const {
  RowMatrix turning(3, model_->nv), moving(3, model_->nv);
  mj_jac(model_.get(), data_.get(), moving.data(), turning.data(), origin.data(), body(link));
  MatrixXd J(6, model_->nv);
  J << turning, moving;
  return J * velocity_map();
}

VectorXd MuJoCoModel::accelerations(const std::vector<Index>& handles, const VectorXd& forces,
                                    const Vector3d& origin, const VectorXd& torques) {
  const MatrixXd T = velocity_map();
  VectorXd driven = torques;
  for (Index i = 0; i < ours_.size(); ++i)
    if (ours_.link(i).joint == JointKind::free) driven.segment<6>(ours_.u_of(i)).setZero();
  Eigen::Map<VectorXd>(data_->qfrc_applied, model_->nv) = T * driven;
  Eigen::Map<VectorXd> applied(data_->xfrc_applied, 6 * model_->nbody);
  applied.setZero();
  for (std::size_t h = 0; h < handles.size(); ++h) {
    const Index at = body(handles[h]);
    const Eigen::Map<const Vector3d> centre(data_->xipos + 3 * at);
    const Vector3d moment = forces.segment<3>(6 * h), force = forces.segment<3>(6 * h + 3);
    applied.segment<3>(6 * at) += force;
    applied.segment<3>(6 * at + 3) += moment + (origin - centre).cross(force);
  }
  mj_forward(model_.get(), data_.get());
  // T is constant enough: d/dt (R' omega) = R' d(omega)/dt, since omega x omega = 0.
  return T.transpose() * Eigen::Map<const VectorXd>(data_->qacc, model_->nv);
}

}  // namespace lcp::cases
