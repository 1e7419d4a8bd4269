#pragma once

#include <ostream>

#include "problems/scenes/humanoid/magnum.h"
#include "tests/problems/rigid/figures.h"
#include "tests/problems/rigid/random_models.h"

namespace lcp::cases {

/// A system and its handles, drawn from a seed.
struct DynamicsCase {
  std::string name;
  std::function<Model(Uniform&)> model;
  Index handles = 3;
  std::uint64_t seed = 1;
};
inline void PrintTo(const DynamicsCase& each, std::ostream* out) { *out << each.name; }

/// The robot with another kind of joint.
inline Model magnum_with(JointKind joint, JointKind base = JointKind::free) {
  std::vector<Link> links = magnum::model().links();
  for (Link& link : links) link.joint = link.parent == Link::world ? base : joint;
  return Model(std::move(links));
}

inline std::vector<DynamicsCase> dynamics_cases() {
  using enum JointKind;
  const auto random = [](const Recipe& recipe) {
    return [recipe](Uniform& uniform) { return random_model(recipe, uniform); };
  };
  std::vector<DynamicsCase> all{
      {"FreeTree", random({.joints = {revolute, ball}}), 3, 11},
      {"FreeTreeOfAllJoints", random({.links = 10, .joints = {revolute, prescribed, ball, fixed}}),
       4, 12},
      {"FixedBaseTree", random({.base = fixed, .joints = {revolute, ball, fixed}}), 3, 13},
      {"HangingTree", random({.base = revolute, .joints = {revolute, prescribed, ball}}), 2, 14},
      {"TreesInTheWorldAndOnePivot",
       random({.links = 9, .base = ball, .joints = {revolute, ball}, .second_root = true}), 4, 15},
      {"TwoFreeTrees", random({.joints = {revolute, ball}, .second_root = true}), 3, 16},
      {"HingedChain", random({.links = 12, .base = revolute, .joints = {revolute}, .chain = true}),
       2, 17},
      {"FreeChainOfBalls", random({.links = 12, .joints = {ball}, .chain = true}), 3, 18},
      {"MovedByTheWorld", random({.links = 6, .base = prescribed, .joints = {revolute}}), 2, 19},
      {"OneFreeBody", random({.links = 1}), 1, 20},
      {"MagnumWithTorques", [](Uniform&) { return magnum_with(revolute); }, 2, 21},
      {"MagnumPrescribed", [](Uniform&) { return magnum_with(prescribed); }, 2, 22},
      {"MagnumOnAStand", [](Uniform&) { return magnum_with(revolute, fixed); }, 2, 23},
  };
  return all;
}

/// A case with all that acts on it.
struct Situation {
  explicit Situation(const DynamicsCase& each) : Situation(each, Uniform(each.seed)) {}

  Model model;
  State state;
  Vector3d origin, gravity;
  VectorXd torques, acceleration;
  std::vector<Index> handles;  ///< The last links, of the robot its feet.
  VectorXd forces;

  Kinematics kinematics() const { return lcp::kinematics(model, state, origin, acceleration); }

 private:
  Situation(const DynamicsCase& each, Uniform uniform)
      : model(each.model(uniform)),
        state(random_state(model, uniform)),
        origin(state.q.size() >= 7 && model.link(0).joint == JointKind::free
                   ? Vector3d(state.q.head<3>())
                   : Vector3d(0.1, -0.2, 0.3)),
        gravity(0.3, -0.5, -9.80665),
        torques(random_numbers(model.velocities(), uniform)),
        acceleration(random_numbers(model.prescribed().size(), uniform)) {
    if (model.size() == 21) {
      handles = {magnum::foot(magnum::Side::left), magnum::foot(magnum::Side::right)};
    } else {
      for (Index h = model.size() - each.handles; h < model.size(); ++h) handles.push_back(h);
      handles.front() /= 2;
    }
    forces = 5 * random_numbers(6 * handles.size(), uniform);
  }
};

}  // namespace lcp::cases
