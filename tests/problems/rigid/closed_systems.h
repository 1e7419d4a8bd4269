#pragma once

#include <ostream>

#include "tests/problems/rigid/joint_coordinates.h"
#include "tests/problems/rigid/random_models.h"

namespace lcp::cases {

/// Two links of a random tree, or one and the world, that a joint holds where they happen to stand.
struct Closure {
  Index link1, link2;
  JointKind joint;
};

struct LoopCase {
  std::string name;
  Recipe recipe;
  std::vector<Closure> closures;
  std::uint64_t seed;
};
inline void PrintTo(const LoopCase& each, std::ostream* out) { *out << each.name; }

/// A system with closed loops that moves as they allow.
struct ClosedSystem {
  Model model;
  State state;
  VectorXd torques;
  std::vector<Index> handles;
  VectorXd forces;
  Vector3d gravity{0.3, -0.5, -9.80665};

  explicit ClosedSystem(const LoopCase& each) : ClosedSystem(each, Uniform(each.seed)) {}

  Vector3d origin() const { return {0.1, -0.2, 0.3}; }
  Kinematics kinematics() const { return lcp::kinematics(model, state, origin()); }

 private:
  ClosedSystem(const LoopCase& each, Uniform uniform)
      : model(random_model(each.recipe, uniform)),
        state(random_state(model, uniform)),
        torques(random_numbers(model.velocities(), uniform)) {
    const Kinematics open = kinematics();
    std::vector<Loop> loops;
    for (const Closure& closure : each.closures) {
      Loop loop;
      loop.joint = closure.joint;
      loop.link1 = closure.link1;
      loop.link2 = closure.link2;
      loop.axis = random_turn(uniform) * Vector3d::UnitX();
      loop.in_link2 = {random_turn(uniform).toRotationMatrix(), 0.2 * random_vector(uniform)};
      const Pose joint = open.pose[loop.link2] * loop.in_link2;
      const Pose first = loop.link1 == Link::world ? Pose{} : open.pose[loop.link1];
      loop.in_link1 = {first.R.transpose() * joint.R, first.R.transpose() * (joint.p - first.p)};
      loops.push_back(loop);
    }
    model = Model(model.links(), loops);
    keep_loops_closed();
    for (Index h = 0; h < model.size(); h += 2) handles.push_back(h);
    forces = random_numbers(6 * handles.size(), uniform);
  }

  /// Takes out of u what would open a loop.
  void keep_loops_closed() {
    const Kinematics k = kinematics();
    const JointCoordinates joints = joint_coordinates(model, k, gravity);
    MatrixXd rates(0, model.velocities());
    for (std::size_t i = 0; i < model.loops().size(); ++i) {
      const Loop& loop = model.loops()[i];
      MatrixXd J = joints.J[loop.link2];
      if (loop.link1 != Link::world) J -= joints.J[loop.link1];
      const Vector3d r = k.from_origin(k.loops[i].pose.p), axis = k.loops[i].pose.R * loop.axis;
      const auto add = [&](const Vector6d& force) {
        rates.conservativeResize(rates.rows() + 1, Eigen::NoChange);
        rates.bottomRows<1>() = force.transpose() * J;
      };
      for (Index d = 0; d < 3; ++d) add(force_at(r, Vector3d::Unit(d)));
      for (Index d = 0; d < 3; ++d)
        if (loop.joint == JointKind::fixed)
          add(stack(Vector3d::Unit(d), Vector3d::Zero()));
        else if (loop.joint == JointKind::revolute)
          add(stack(Vector3d::Unit(d) - axis(d) * axis, Vector3d::Zero()));
    }
    state.u -= rates.completeOrthogonalDecomposition().solve(rates * state.u);
  }
};

inline std::vector<LoopCase> loop_cases() {
  using enum JointKind;
  return {
      {"ChainWithBothEndsFixed",
       {.links = 8, .base = ball, .joints = {ball}, .chain = true},
       {{Link::world, 7, ball}},
       31},
      {"ChainOfHingesHeldByAHinge",
       {.links = 9, .base = revolute, .joints = {revolute}, .chain = true},
       {{Link::world, 8, revolute}},
       32},
      {"FreeRing", {.links = 8, .joints = {ball}, .chain = true}, {{0, 7, ball}}, 33},
      {"TwoLoopsOfATree",
       {.links = 10, .joints = {ball, revolute}},
       {{2, 9, ball}, {4, 7, ball}},
       34},
      {"FreeTreeTiedToTheWorld",
       {.links = 8, .joints = {ball}},
       {{Link::world, 3, ball}, {Link::world, 7, ball}},
       35},
      {"TwoFreeChainsTied",
       {.links = 8, .joints = {ball}, .chain = true, .second_root = true},
       {{3, 7, fixed}},
       36},
      {"HeldTwice",
       {.links = 6, .base = ball, .joints = {ball}, .chain = true},
       {{1, 4, ball}, {1, 4, ball}},
       37},
  };
}

}  // namespace lcp::cases
