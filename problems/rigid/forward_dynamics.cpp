#include "problems/rigid/forward_dynamics.h"

#include <algorithm>

#include "problems/decompositions.h"
#include "problems/rigid/assembly_plan.h"
#include "problems/rigid/transmission.h"
#include "solvers/errors.h"

namespace lcp {

namespace {

/// A part of the plan with its numbers.
struct Part : AssemblyPart {
  explicit Part(AssemblyPart plan) : AssemblyPart(std::move(plan)) {}

  MatrixXd Phi;  ///< Of `open`.
  VectorXd b;
  MatrixXd g;                                                            ///< 6 |merged| x 6.
  Vector3d child_arm = Vector3d::Zero(), parent_arm = Vector3d::Zero();  ///< To the joint.
  Matrix6d W = Matrix6d::Zero();
  Vector6d f = Vector6d::Zero();  ///< Joint force on the child without forces on `open`.
  VectorXd force;                 ///< On `merged` (joint) or on the body, during disassembly.
};

using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

/// Inverse of a symmetric positive semidefinite matrix on its range, relative to `scale`, > 0: the
/// diagonal of what it would be if nothing were redundant. Directions whose eigenvalue so scaled is
/// below `tolerance` are left out.
Small inverse_on_range(const Small& gamma, const Small& scale, double tolerance) {
  const Eigen::Vector<double, Eigen::Dynamic> unit = scale.diagonal().cwiseSqrt().cwiseInverse();
  const SymmetricEigen scaled = symmetric_eigen(unit.asDiagonal() * gamma * unit.asDiagonal());
  const Small vectors = scaled.vectors;
  Small inverse = Small::Zero(gamma.rows(), gamma.cols());
  for (Index i = 0; i < gamma.rows(); ++i) {
    if (!(scaled.values(i) > tolerance)) continue;
    const auto direction = vectors.col(i).cwiseProduct(unit);
    inverse += direction * direction.transpose() / scaled.values(i);
  }
  return inverse;
}

}  // namespace

void check_handles(const Model& model, const std::vector<Index>& handles,
                   const std::string& where) {
  for (std::size_t h = 0; h < handles.size(); ++h) {
    const bool ascending = h == 0 || handles[h] > handles[h - 1];
    if (handles[h] < 0 || handles[h] >= model.size() || !ascending)
      throw InvalidArgument("{}: handle {} is link {}, expected ascending links 0 ... {}", where, h,
                            handles[h], model.size() - 1);
  }
}

HandleDynamics at_origin(const HandleDynamics& dynamics) {
  HandleDynamics moved = dynamics;
  const Index n = static_cast<Index>(dynamics.points.size());
  for (Index i = 0; i < n; ++i) {
    const Matrix6d X = moved_by(-dynamics.points[i]);
    moved.Phi.middleRows<6>(6 * i) = (X * moved.Phi.middleRows<6>(6 * i)).eval();
    moved.Phi.middleCols<6>(6 * i) = (moved.Phi.middleCols<6>(6 * i) * X.transpose()).eval();
    moved.phi.segment<6>(6 * i) = (X * moved.phi.segment<6>(6 * i)).eval();
    moved.points[i].setZero();
  }
  return moved;
}

class ForwardDynamics::Impl {
 public:
  Impl(const Model& model, std::vector<Index> handles, const AssemblyOptions& options)
      : model_(model), handles_(std::move(handles)), options_(options) {
    check_handles(model, handles_, "forward dynamics");
    AssemblyPlan plan = plan_assembly(model_, handles_);
    for (AssemblyPart& part : plan.parts) parts_.emplace_back(std::move(part));
    roots_ = std::move(plan.roots);
  }

  void assemble(const Kinematics& k, const VectorXd& torques, const Vector3d& gravity,
                const std::vector<Vector6d>& forces) {
    if (!forces.empty() && forces.size() != static_cast<std::size_t>(model_.size()))
      throw InvalidArgument("assembly: forces on {} links, expected {} or none", forces.size(),
                            model_.size());
    kinematics_ = k;
    for (Part& part : parts_) {
      if (part.is_body())
        set_body(part, gravity, forces);
      else
        join(part, torques);
    }
  }

  HandleDynamics handle_dynamics() const {
    const Index n = static_cast<Index>(handles_.size());
    HandleDynamics dynamics{MatrixXd::Zero(6 * n, 6 * n), VectorXd::Zero(6 * n), {}};
    for (const Index handle : handles_) dynamics.points.push_back(point(handle));
    for (const Index root : roots_) {
      const Part& part = parts_[root];
      for (std::size_t i = 0; i < part.open.size(); ++i) {
        const Index row = handle_place(part.open[i]);
        if (row < 0) continue;  // a free body that nobody asked for
        dynamics.phi.segment<6>(6 * row) = part.b.segment<6>(6 * i);
        for (std::size_t j = 0; j < part.open.size(); ++j)
          dynamics.Phi.block<6, 6>(6 * row, 6 * handle_place(part.open[j])) =
              part.Phi.block<6, 6>(6 * i, 6 * j);
      }
    }
    return dynamics;
  }

  Accelerations disassemble(const VectorXd& forces) {
    if (forces.size() != 6 * static_cast<Index>(handles_.size()))
      throw InvalidArgument("disassembly: {} forces, expected {}", forces.size(),
                            6 * handles_.size());
    Accelerations found{VectorXd::Zero(model_.velocities()),
                        std::vector<Vector6d>(model_.size(), Vector6d::Zero())};
    for (const Index root : roots_) {
      Part& part = parts_[root];
      VectorXd outer = VectorXd::Zero(6 * part.open.size());
      for (std::size_t i = 0; i < part.open.size(); ++i)
        if (const Index row = handle_place(part.open[i]); row >= 0)
          outer.segment<6>(6 * i) = force_moved(forces.segment<6>(6 * row), point(part.open[i]));
      push(part, outer);
    }
    // Parts come before what they are part of, so this goes from the whole to the bodies.
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
      if (part->is_body()) {
        if (const Index i = part->open.front(); !is_world(i))
          found.links[i] = motion_moved(part->Phi * part->force + part->b, -point(i));
        continue;
      }
      const Index left = 6 * static_cast<Index>(parts_[part->left].open.size());
      push(parts_[part->left], part->force.head(left));
      if (part->right >= 0) push(parts_[part->right], part->force.tail(part->force.size() - left));
    }
    set_joint_accelerations(found);
    return found;
  }

  const std::vector<Index>& handles() const { return handles_; }

 private:
  /// Where a link's forces and accelerations are taken, from O.
  Vector3d point(Index link) const { return kinematics_.from_origin(kinematics_.pose[link].p); }

  /// From there to `joint` (from O).
  Vector3d arm(Index body, const Vector3d& joint) const {
    return is_world(body) ? Vector3d::Zero().eval() : Vector3d(joint - point(body));
  }

  void set_body(Part& part, const Vector3d& gravity, const std::vector<Vector6d>& forces) {
    const Index i = part.open.front();
    if (is_world(i)) {
      part.Phi.setZero(6, 6);
      part.b.setZero(6);
      return;
    }
    const Link& link = model_.link(i);
    const Matrix3d& R = kinematics_.pose[i].R;
    const Vector3d c = R * link.centre;
    const Vector6d v = motion_moved(kinematics_.velocity[i], point(i));
    part.Phi = link_mobility(model_, kinematics_, i);
    const Vector6d h = spatial_inertia(link.mass, c, R * link.inertia * R.transpose()) * v;
    Vector6d force = force_at(c, link.mass * gravity) - cross_force(v, h);
    if (!forces.empty()) force += force_moved(forces[i], point(i));
    part.b = part.Phi * force;
  }

  void join(Part& part, const VectorXd& torques) {
    const Part& left = parts_[part.left];
    const Part* right = part.right >= 0 ? &parts_[part.right] : nullptr;
    const Index size_left = left.b.size(), size = size_left + (right ? right->b.size() : 0);
    const Index p = 6 * part.parent, c = 6 * part.child;

    // Before the joint is closed the two sides do not feel one another.
    VectorXd& b = merged_b_;
    b.resize(size);
    b.head(size_left) = left.b;
    if (right) b.tail(size - size_left) = right->b;
    const Vector3d at = joint_point(part.joint);
    part.child_arm = arm(part.merged[part.child], at);
    part.parent_arm = arm(part.merged[part.parent], at);
    const Matrix6d to_child = moved_by(part.child_arm), to_parent = moved_by(part.parent_arm);
    part.g.setZero(size, 6);
    const auto add_column = [&](Index place, const Matrix6d& X) {
      if (place < size_left)
        part.g.topRows(size_left) += left.Phi.middleCols<6>(place) * X.transpose();
      else
        part.g.bottomRows(size - size_left) +=
            right->Phi.middleCols<6>(place - size_left) * X.transpose();
    };
    add_column(c, to_child);
    add_column(p, -to_parent);

    const Matrix6d Q = to_child * part.g.middleRows<6>(c) - to_parent * part.g.middleRows<6>(p);
    const Transmission joint = transmission_of(part.joint);
    part.W = constraint_stiffness(part, joint.T, Q);
    Vector6d drive = Vector6d::Zero();
    if (joint.F.cols() > 0)
      drive = joint.F * torques.segment(model_.u_of(part.joint), joint.F.cols());
    const Vector6d apart = to_child * b.segment<6>(c) - to_parent * b.segment<6>(p);
    part.f = drive - part.W * (Q * drive + apart - motion_moved(sigma(part.joint), at));

    const Index kept = static_cast<Index>(part.kept.size());
    part.Phi.setZero(6 * kept, 6 * kept);
    part.b.resize(6 * kept);
    for (Index j = 0; j < kept; ++j) {
      const Index to = 6 * part.kept[j];
      part.b.segment<6>(6 * j) = b.segment<6>(to) + part.g.middleRows<6>(to) * part.f;
      const Eigen::Matrix<double, 6, 6> pushed = part.W * part.g.middleRows<6>(to).transpose();
      for (Index i = 0; i <= j; ++i) {
        const Index from = 6 * part.kept[i];
        Matrix6d block = -part.g.middleRows<6>(from) * pushed;
        if (from < size_left && to < size_left)
          block += left.Phi.block<6, 6>(from, to);
        else if (from >= size_left && to >= size_left)
          block += right->Phi.block<6, 6>(from - size_left, to - size_left);
        if (i == j) block = (0.5 * (block + block.transpose())).eval();
        part.Phi.block<6, 6>(6 * i, 6 * j) = block;
        if (i != j) part.Phi.block<6, 6>(6 * j, 6 * i) = block.transpose();
      }
    }
  }

  bool is_loop(Index joint) const { return joint >= model_.size(); }

  Transmission transmission_of(Index joint) const {
    return is_loop(joint) ? loop_transmission(model_, kinematics_, joint - model_.size())
                          : link_transmission(model_, kinematics_, joint);
  }

  Vector3d joint_point(Index joint) const {
    return is_loop(joint) ? kinematics_.from_origin(kinematics_.loops[joint - model_.size()].pose.p)
                          : point(joint);
  }

  const Vector6d& sigma(Index joint) const {
    return is_loop(joint) ? kinematics_.loops[joint - model_.size()].sigma
                          : kinematics_.sigma[joint];
  }

  /// W = T Gamma^-1 T', or T Gamma^+ T' where the joint may hold what is held already.
  Matrix6d constraint_stiffness(const Part& part, const Space& T, const Matrix6d& Q) const {
    const Small gamma = T.transpose() * Q * T;
    Small weighted;
    if (part.redundant) {
      const auto at_joint = [&](Index place, const Vector3d& arm_of_joint) -> Matrix6d {
        const Matrix6d X = moved_by(arm_of_joint);
        return X * link_mobility(model_, kinematics_, part.merged[place]) * X.transpose();
      };
      const Matrix6d free =
          at_joint(part.child, part.child_arm) + at_joint(part.parent, part.parent_arm);
      weighted = inverse_on_range(0.5 * (gamma + gamma.transpose()), T.transpose() * free * T,
                                  options_.redundancy) *
                 T.transpose();
    } else {
      weighted = gamma.llt().solve(Small(T.transpose()));
    }
    const Matrix6d W = T * weighted;
    return 0.5 * (W + W.transpose());
  }

  /// Sets the forces inside a part on which `outer` (6 |open|) acts.
  static void push(Part& part, const VectorXd& outer) {
    if (part.is_body()) {
      part.force = outer;
      return;
    }
    part.force.setZero(part.g.rows());
    Vector6d f = part.f;
    for (std::size_t i = 0; i < part.kept.size(); ++i) {
      part.force.segment<6>(6 * part.kept[i]) = outer.segment<6>(6 * i);
      f -= part.W * (part.g.middleRows<6>(6 * part.kept[i]).transpose() * outer.segment<6>(6 * i));
    }
    part.force.segment<6>(6 * part.child) += force_moved(f, -part.child_arm);
    part.force.segment<6>(6 * part.parent) -= force_moved(f, -part.parent_arm);
  }

  void set_joint_accelerations(Accelerations& found) const {
    for (Index i = 0; i < model_.size(); ++i) {
      const Link& link = model_.link(i);
      const Index size = velocities(link.joint);
      if (size == 0) continue;
      const Vector6d parent =
          link.parent == Link::world ? Vector6d::Zero().eval() : found.links[link.parent];
      const Vector6d relative = found.links[i] - parent - kinematics_.sigma[i];
      auto joints = found.joints.segment(model_.u_of(i), size);
      if (link.joint == JointKind::free)  // S is square, (1, 0; [r]x, 1)
        joints << relative.head<3>(),
            relative.tail<3>() - kinematics_.S[i].bottomLeftCorner<3, 3>() * relative.head<3>();
      else
        joints = kinematics_.S[i].topRows<3>().transpose() * relative.head<3>();
    }
  }

  /// Place of a link among the handles; -1 where it is not one of them.
  Index handle_place(Index link) const {
    const auto place = std::lower_bound(handles_.begin(), handles_.end(), link);
    return place != handles_.end() && *place == link ? place - handles_.begin() : -1;
  }

  const Model& model_;
  std::vector<Index> handles_;
  AssemblyOptions options_;
  std::vector<Part> parts_;
  std::vector<Index> roots_;
  Kinematics kinematics_;
  VectorXd merged_b_;
};

ForwardDynamics::ForwardDynamics(const Model& model, std::vector<Index> handles,
                                 const AssemblyOptions& options)
    : impl_(std::make_unique<Impl>(model, std::move(handles), options)) {}
ForwardDynamics::~ForwardDynamics() = default;
ForwardDynamics::ForwardDynamics(ForwardDynamics&&) noexcept = default;
ForwardDynamics& ForwardDynamics::operator=(ForwardDynamics&&) noexcept = default;

void ForwardDynamics::assemble(const Kinematics& kinematics, const VectorXd& torques,
                               const Vector3d& gravity, const std::vector<Vector6d>& forces) {
  impl_->assemble(kinematics, torques, gravity, forces);
}
const std::vector<Index>& ForwardDynamics::handles() const { return impl_->handles(); }
HandleDynamics ForwardDynamics::handle_dynamics() const { return impl_->handle_dynamics(); }
Accelerations ForwardDynamics::disassemble(const VectorXd& forces) {
  return impl_->disassemble(forces);
}

}  // namespace lcp
