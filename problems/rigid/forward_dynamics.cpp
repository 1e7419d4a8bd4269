#include "problems/rigid/forward_dynamics.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace lcp {

namespace {

/// Two perpendicular unit vectors across `axis`.
std::pair<Vector3d, Vector3d> across(const Vector3d& axis) {
  Index least;
  axis.cwiseAbs().minCoeff(&least);
  const Vector3d first = axis.cross(Vector3d::Unit(least)).normalized();
  return {first, axis.cross(first)};
}

/// What a joint transmits: T, and F with S'F = 1.
struct Transmission {
  Space T, F;
};

Transmission transmission(const Link& link, const Pose& pose, const Vector3d& r) {
  Transmission joint;
  const auto forces_through = [&](Index column) {
    for (Index k = 0; k < 3; ++k) joint.T.col(column + k) = force_at(r, Vector3d::Unit(k));
  };
  switch (link.joint) {
    case JointKind::fixed:
    case JointKind::prescribed:
      joint.T = Space::Identity(6, 6);
      joint.F.resize(6, 0);
      break;
    case JointKind::revolute: {
      const Vector3d axis = pose.R * link.axis;
      const auto [first, second] = across(axis);
      joint.T = Space::Zero(6, 5);
      joint.T.col(0).head<3>() = first;
      joint.T.col(1).head<3>() = second;
      forces_through(2);
      joint.F = stack(axis, Vector3d::Zero());
      break;
    }
    case JointKind::ball:
      joint.T = Space::Zero(6, 3);
      forces_through(0);
      joint.F = Space::Zero(6, 3);
      joint.F.topRows<3>() = pose.R;
      break;
    case JointKind::free:
      break;
  }
  return joint;
}

/// A part of the system: a body, or two parts and the joint between them. `open` are the bodies
/// that later joints or callers still push.
struct Part {
  Index left = -1, right = -1;    ///< Parts joined; -1 for a body.
  Index joint = -1;               ///< Link whose joint was closed.
  std::vector<Index> open;        ///< Bodies, by link number; Link::world is one.
  std::vector<Index> merged;      ///< Open bodies of left, then of right.
  std::vector<Index> kept;        ///< Places in `merged` of `open`.
  Index parent = -1, child = -1;  ///< Places in `merged` of the joint's bodies.
  MatrixXd Phi;                   ///< Of `open`.
  VectorXd b;
  MatrixXd g;  ///< 6 |merged| x 6.
  Matrix6d W = Matrix6d::Zero();
  Vector6d f = Vector6d::Zero();  ///< Joint force on the child without forces on `open`.
  VectorXd force;                 ///< On `merged` (joint) or on the body, during disassembly.
};

/// A joint between two bodies, as the plan sees it.
struct Edge {
  Index parent, child;
};

/// Orders the joints into a balanced tree of parts.
class Planner {
 public:
  Planner(const Model& model, const std::vector<Index>& handles) : handles_(handles) {
    for (Index i = 0; i < model.size(); ++i)
      if (model.link(i).joint != JointKind::free) edges_.push_back({model.link(i).parent, i});
  }

  /// Appends the parts that `bodies`, connected by joints, are assembled from; the whole comes last.
  void plan(const std::vector<Index>& bodies, std::vector<Part>& parts) const {
    if (bodies.size() == 1) {
      Part part;
      part.open = bodies;
      parts.push_back(std::move(part));
      return;
    }
    const Edge cut = halving_edge(bodies);
    const std::vector<Index> beyond = reach(cut.child, cut, bodies);
    std::vector<Index> rest;
    for (const Index body : bodies)
      if (!contains(beyond, body)) rest.push_back(body);
    Part part;
    plan(rest, parts);
    part.left = static_cast<Index>(parts.size()) - 1;
    plan(beyond, parts);
    part.right = static_cast<Index>(parts.size()) - 1;
    part.joint = cut.child;
    part.merged = parts[part.left].open;
    part.merged.insert(part.merged.end(), parts[part.right].open.begin(),
                       parts[part.right].open.end());
    for (Index place = 0; place < static_cast<Index>(part.merged.size()); ++place) {
      const Index body = part.merged[place];
      if (body == cut.parent) part.parent = place;
      if (body == cut.child) part.child = place;
      if (!stays_open(body, bodies)) continue;
      part.kept.push_back(place);
      part.open.push_back(body);
    }
    parts.push_back(std::move(part));
  }

  /// Bodies that joints connect with `start`.
  std::vector<Index> connected(Index start) const { return reach(start, {-2, -2}, {}); }

 private:
  static bool contains(const std::vector<Index>& bodies, Index body) {
    return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
  }

  /// Bodies reachable from `start` without the edge `cut`, inside `within` (empty: anywhere).
  std::vector<Index> reach(Index start, const Edge& cut, const std::vector<Index>& within) const {
    std::vector<Index> found{start};
    for (std::size_t next = 0; next < found.size(); ++next) {
      for (const Edge& edge : edges_) {
        if (edge.parent == cut.parent && edge.child == cut.child) continue;
        for (const auto& [from, to] :
             {std::pair(edge.parent, edge.child), {edge.child, edge.parent}})
          if (from == found[next] && !contains(found, to) &&
              (within.empty() || contains(within, to)))
            found.push_back(to);
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  Edge halving_edge(const std::vector<Index>& bodies) const {
    Edge best{};
    std::size_t least = bodies.size();
    for (const Edge& edge : edges_) {
      if (!contains(bodies, edge.parent) || !contains(bodies, edge.child)) continue;
      const std::size_t beyond = reach(edge.child, edge, bodies).size();
      const std::size_t larger = std::max(beyond, bodies.size() - beyond);
      if (larger < least) {
        least = larger;
        best = edge;
      }
    }
    return best;
  }

  /// Whether anything outside `bodies` will push `body`.
  bool stays_open(Index body, const std::vector<Index>& bodies) const {
    if (contains(handles_, body)) return true;
    return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
      return (edge.parent == body && !contains(bodies, edge.child)) ||
             (edge.child == body && !contains(bodies, edge.parent));
    });
  }

  const std::vector<Index>& handles_;
  std::vector<Edge> edges_;
};

}  // namespace

void check_handles(const Model& model, const std::vector<Index>& handles,
                   const std::string& where) {
  for (std::size_t h = 0; h < handles.size(); ++h) {
    const bool ascending = h == 0 || handles[h] > handles[h - 1];
    if (handles[h] < 0 || handles[h] >= model.size() || !ascending)
      throw std::invalid_argument(
          fmt::format("{}: handle {} is link {}, expected ascending links 0 ... {}", where, h,
                      handles[h], model.size() - 1));
  }
}

class ForwardDynamics::Impl {
 public:
  Impl(const Model& model, std::vector<Index> handles)
      : model_(model), handles_(std::move(handles)) {
    check_handles(model, handles_, "forward dynamics");
    const Planner planner(model_, handles_);
    std::vector<bool> planned(model.size(), false);
    for (Index i = 0; i < model.size(); ++i) {
      if (planned[i]) continue;
      const std::vector<Index> bodies = planner.connected(i);
      for (const Index body : bodies)
        if (body != Link::world) planned[body] = true;
      planner.plan(bodies, parts_);
      roots_.push_back(static_cast<Index>(parts_.size()) - 1);
    }
  }

  void assemble(const Kinematics& k, const VectorXd& torques, const Vector3d& gravity) {
    kinematics_ = k;
    for (Part& part : parts_) {
      if (part.left < 0)
        set_body(part, gravity);
      else
        join(part, torques);
    }
  }

  HandleDynamics handle_dynamics() const {
    const Index n = static_cast<Index>(handles_.size());
    HandleDynamics dynamics{MatrixXd::Zero(6 * n, 6 * n), VectorXd::Zero(6 * n)};
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
      throw std::invalid_argument(
          fmt::format("disassembly: {} forces, expected {}", forces.size(), 6 * handles_.size()));
    Accelerations found{VectorXd::Zero(model_.velocities()),
                        std::vector<Vector6d>(model_.size(), Vector6d::Zero())};
    for (const Index root : roots_) {
      Part& part = parts_[root];
      VectorXd outer = VectorXd::Zero(6 * part.open.size());
      for (std::size_t i = 0; i < part.open.size(); ++i)
        if (const Index row = handle_place(part.open[i]); row >= 0)
          outer.segment<6>(6 * i) = forces.segment<6>(6 * row);
      push(part, outer);
    }
    // Parts come before what they are part of, so this goes from the whole to the bodies.
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
      if (part->left < 0) {
        if (part->open.front() != Link::world)
          found.links[part->open.front()] = part->Phi * part->force + part->b;
        continue;
      }
      const Index left = 6 * static_cast<Index>(parts_[part->left].open.size());
      push(parts_[part->left], part->force.head(left));
      push(parts_[part->right], part->force.tail(part->force.size() - left));
    }
    set_joint_accelerations(found);
    return found;
  }

  const std::vector<Index>& handles() const { return handles_; }

 private:
  void set_body(Part& part, const Vector3d& gravity) {
    const Index i = part.open.front();
    if (i == Link::world) {
      part.Phi.setZero(6, 6);
      part.b.setZero(6);
      return;
    }
    const Link& link = model_.link(i);
    const Matrix3d& R = kinematics_.pose[i].R;
    const Vector3d c = kinematics_.from_origin(kinematics_.pose[i] * link.centre);
    const Vector6d& v = kinematics_.velocity[i];
    part.Phi = inverse_spatial_inertia(link.mass, c, R * model_.inverse_inertia(i) * R.transpose());
    const Vector6d h = link_inertia(model_, kinematics_, i) * v;
    part.b = part.Phi * (force_at(c, link.mass * gravity) - cross_force(v, h));
  }

  void join(Part& part, const VectorXd& torques) {
    const Part &left = parts_[part.left], &right = parts_[part.right];
    const Index size_left = left.b.size(), size = size_left + right.b.size();
    const Index p = 6 * part.parent, c = 6 * part.child;

    // Before the joint is closed the two sides do not feel one another.
    VectorXd& b = merged_b_;
    b.resize(size);
    b << left.b, right.b;
    part.g.setZero(size, 6);
    const auto add_column = [&](Index place, double sign) {
      if (place < size_left)
        part.g.topRows(size_left) += sign * left.Phi.middleCols<6>(place);
      else
        part.g.bottomRows(size - size_left) += sign * right.Phi.middleCols<6>(place - size_left);
    };
    add_column(c, 1);
    add_column(p, -1);

    const Link& link = model_.link(part.joint);
    const Pose& pose = kinematics_.pose[part.joint];
    const Transmission joint = transmission(link, pose, kinematics_.from_origin(pose.p));
    const Matrix6d Q = part.g.middleRows<6>(c) - part.g.middleRows<6>(p);
    using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
    const Small gamma = joint.T.transpose() * Q * joint.T;
    const Small weighted = gamma.llt().solve(Small(joint.T.transpose()));
    const Matrix6d W = joint.T * weighted;
    part.W = 0.5 * (W + W.transpose());
    Vector6d drive = Vector6d::Zero();
    if (joint.F.cols() > 0)
      drive = joint.F * torques.segment(model_.u_of(part.joint), joint.F.cols());
    part.f = drive - part.W * (Q * drive + b.segment<6>(c) - b.segment<6>(p) -
                               kinematics_.sigma[part.joint]);

    const Index kept = static_cast<Index>(part.kept.size());
    part.Phi.setZero(6 * kept, 6 * kept);
    part.b.resize(6 * kept);
    for (Index j = 0; j < kept; ++j) {
      const Index to = 6 * part.kept[j];
      part.b.segment<6>(6 * j) = b.segment<6>(to) + part.g.middleRows<6>(to) * part.f;
      const Eigen::Matrix<double, 6, 6> pushed = part.W * part.g.middleRows<6>(to).transpose();
      for (Index i = 0; i <= j; ++i) {
        const Index at = 6 * part.kept[i];
        Matrix6d block = -part.g.middleRows<6>(at) * pushed;
        if (at < size_left && to < size_left)
          block += left.Phi.block<6, 6>(at, to);
        else if (at >= size_left && to >= size_left)
          block += right.Phi.block<6, 6>(at - size_left, to - size_left);
        part.Phi.block<6, 6>(6 * i, 6 * j) = block;
        if (i != j) part.Phi.block<6, 6>(6 * j, 6 * i) = block.transpose();
      }
    }
  }

  /// Sets the forces inside a part on which `outer` (6 |open|) acts.
  static void push(Part& part, const VectorXd& outer) {
    if (part.left < 0) {
      part.force = outer;
      return;
    }
    part.force.setZero(part.g.rows());
    Vector6d f = part.f;
    for (std::size_t i = 0; i < part.kept.size(); ++i) {
      part.force.segment<6>(6 * part.kept[i]) = outer.segment<6>(6 * i);
      f -= part.W * (part.g.middleRows<6>(6 * part.kept[i]).transpose() * outer.segment<6>(6 * i));
    }
    part.force.segment<6>(6 * part.child) += f;
    part.force.segment<6>(6 * part.parent) -= f;
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

  /// Place of a link among the handles; -1 where it is none.
  Index handle_place(Index link) const {
    const auto place = std::lower_bound(handles_.begin(), handles_.end(), link);
    return place != handles_.end() && *place == link ? place - handles_.begin() : -1;
  }

  const Model& model_;
  std::vector<Index> handles_;
  std::vector<Part> parts_;
  std::vector<Index> roots_;
  Kinematics kinematics_;
  VectorXd merged_b_;
};

ForwardDynamics::ForwardDynamics(const Model& model, std::vector<Index> handles)
    : impl_(std::make_unique<Impl>(model, std::move(handles))) {}
ForwardDynamics::~ForwardDynamics() = default;
ForwardDynamics::ForwardDynamics(ForwardDynamics&&) noexcept = default;
ForwardDynamics& ForwardDynamics::operator=(ForwardDynamics&&) noexcept = default;

void ForwardDynamics::assemble(const Kinematics& kinematics, const VectorXd& torques,
                               const Vector3d& gravity) {
  impl_->assemble(kinematics, torques, gravity);
}
const std::vector<Index>& ForwardDynamics::handles() const { return impl_->handles(); }
HandleDynamics ForwardDynamics::handle_dynamics() const { return impl_->handle_dynamics(); }
Accelerations ForwardDynamics::disassemble(const VectorXd& forces) {
  return impl_->disassemble(forces);
}

}  // namespace lcp
