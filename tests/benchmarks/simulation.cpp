// Micro-benchmarks of what a step of `squat` is made of: 21 links, 2 handles, 16 contacts, n = 160.
// A step under RK4 assembles and disassembles four times and poses one LCP.
// Of a chain of 26 links on balls, all of which may touch, with 34 contacts: its assembly and
// disassembly, and its contact matrix from the assembly and as a product in joint space.
// And of collision: pairs of shapes that touch, and a chain of capsules over a rod.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/collision/collision.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

/// A frame in the middle of the squat, with all that the kernels start from.
struct Moment {
  NamedScene scene = make_scene("squat");
  ContactSolver solver;
  Simulation simulation{scene.setup.system, scene.setup.stepping};
  std::vector<ContactPoint> points;
  Kinematics kinematics;
  State state;
  LinkContacts links;
  ContactProblem contacts;

  Moment() {
    const NamedSolver best_first = make_solver("best-first");
    solver = {[best_first](const Problem& problem, const Call& call) {
                return best_first.solver->solve(problem, call);
              },
              [](const Problem&, const Result& result) { return result.claim == Claim::solved; }};
    for (int i = 0; i < 300; ++i)
      simulation.step(solver, [this](const Frame& frame) {
        points = frame.points;
        kinematics = frame.kinematics;
        state = frame.state;
        links = frame.links;
        contacts = frame.contacts;
      });
  }
};

const Moment& moment() {
  static const Moment one;
  return one;
}

void positions_and_velocities(benchmark::State& state) {
  const System& system = moment().scene.setup.system;
  for (auto _ : state)
    benchmark::DoNotOptimize(kinematics(system.model, moment().state).velocity.data());
}

void assembling(benchmark::State& state) {
  const System& system = moment().scene.setup.system;
  ForwardDynamics dynamics(system.model, system.handles);
  const VectorXd torques = VectorXd::Zero(system.model.velocities());
  for (auto _ : state) dynamics.assemble(moment().kinematics, torques, system.gravity);
}

void disassembling(benchmark::State& state) {
  const System& system = moment().scene.setup.system;
  ForwardDynamics dynamics(system.model, system.handles);
  dynamics.assemble(moment().kinematics, VectorXd::Zero(system.model.velocities()), system.gravity);
  const VectorXd forces = VectorXd::Ones(12);
  for (auto _ : state) benchmark::DoNotOptimize(dynamics.disassemble(forces).joints.data());
}

void contact_matrix(benchmark::State& state) {
  const System& system = moment().scene.setup.system;
  ForwardDynamics dynamics(system.model, system.handles);
  dynamics.assemble(moment().kinematics, VectorXd::Zero(system.model.velocities()), system.gravity);
  const HandleDynamics handles = dynamics.handle_dynamics();
  for (auto _ : state)
    benchmark::DoNotOptimize(contact_problem(moment().links, handles, 1e-3, {}).W.data());
}

void posing_the_lcp(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(friction_lcp(moment().contacts).M.data());
}

void whole_step(benchmark::State& state) {
  NamedScene scene = make_scene("squat");
  Simulation simulation(scene.setup.system, scene.setup.stepping);
  for (auto _ : state) simulation.step(moment().solver);
}

/// 26 links of 3 cm on balls, the first of them in the world, bent a little; 34 contacts with the
/// world.
struct BallChain {
  static constexpr Index links = 26, points = 34;
  Model model = chain();
  std::vector<Index> handles;
  Kinematics here;
  LinkContacts contacts;

  BallChain() {
    State state = state_at_zero(model);
    for (Index i = 0; i < links; ++i) {
      handles.push_back(i);
      state.q(model.q_of(i)) = 0.05 * std::sin(static_cast<double>(i));
    }
    normalise(model, state.q);
    here = kinematics(model, state);
    std::vector<ContactPoint> touching(points);
    for (Index i = 0; i < points; ++i)
      touching[i] = {.position = here.pose[i % links] * Vector3d(0, 0.005, -0.015),
                     .normal = Vector3d::UnitY(),
                     .id = {body_of(i % links), 0, i}};
    contacts = link_contacts(touching, 0.5, here, handles);
  }

  static Model chain() {
    std::vector<Link> all(links);
    for (Index i = 0; i < links; ++i) {
      all[i].parent = i - 1;
      all[i].joint = JointKind::ball;
      all[i].in_parent.p = {0, 0, i > 0 ? -0.03 : 0};
      all[i].mass = 0.02;
      all[i].centre = {0, 0, -0.015};
      all[i].inertia = Vector3d(1.6e-6, 1.6e-6, 2.5e-7).asDiagonal();
    }
    return Model(std::move(all));
  }

  ForwardDynamics assembled() const {
    ForwardDynamics dynamics(model, handles);
    dynamics.assemble(here, VectorXd::Zero(model.velocities()), {0, 0, -9.80665});
    return dynamics;
  }
};

void chain_assembling(benchmark::State& state) {
  const BallChain chain;
  ForwardDynamics dynamics(chain.model, chain.handles);
  const VectorXd torques = VectorXd::Zero(chain.model.velocities());
  for (auto _ : state) dynamics.assemble(chain.here, torques, {0, 0, -9.80665});
}

void chain_disassembling(benchmark::State& state) {
  const BallChain chain;
  ForwardDynamics dynamics = chain.assembled();
  const VectorXd forces = VectorXd::Ones(6 * BallChain::links);
  for (auto _ : state) benchmark::DoNotOptimize(dynamics.disassemble(forces).joints.data());
}

void chain_contact_matrix(benchmark::State& state) {
  const BallChain chain;
  const HandleDynamics handles = chain.assembled().handle_dynamics();
  for (auto _ : state)
    benchmark::DoNotOptimize(contact_problem(chain.contacts, handles, 1e-3, {}).W.data());
}

void chain_joint_space_factor(benchmark::State& state) {
  const BallChain chain;
  const JointSpace joints(chain.model, chain.handles);
  for (auto _ : state)
    benchmark::DoNotOptimize(joints.contact_factor(chain.here, chain.contacts.J).data());
}

void chain_joint_space_matrix(benchmark::State& state) {
  const BallChain chain;
  const JointSpace joints(chain.model, chain.handles);
  const HandleDynamics handles = chain.assembled().handle_dynamics();
  for (auto _ : state)
    benchmark::DoNotOptimize(contact_problem(chain.contacts, handles,
                                             joints.contact_factor(chain.here, chain.contacts.J),
                                             1e-3, {})
                                 .W.data());
}

Pose turned(double angle, const Vector3d& axis, const Vector3d& place) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), place};
}

collision::Ring round_ring(double circle_radius, double wire_radius) {
  constexpr int corners = 64;
  collision::Ring ring{{}, wire_radius};
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    ring.corners.emplace_back(circle_radius * std::cos(angle), circle_radius * std::sin(angle), 0);
  }
  return ring;
}

void collide(benchmark::State& state, std::vector<collision::Shape> shapes, std::vector<Pose> poses,
             const std::vector<collision::LinkPair>& excluded = {}) {
  collision::World world(std::move(shapes), excluded);
  Kinematics kinematics;
  kinematics.pose = std::move(poses);
  std::size_t points = 0;
  for (auto _ : state) points = world.contacts(kinematics).size();
  state.counters["points"] = static_cast<double>(points);
}

/// The first, at `pose`, touches the second, which stands at the origin.
void pair_of_shapes(benchmark::State& state, const collision::Geometry& first, const Pose& pose,
                    const collision::Geometry& second) {
  collide(state, {{first, 0}, {second}}, {pose});
}

/// 30 links of 2 cm lie half round a rod, and hang down on both sides.
void chain_on_a_rod(benchmark::State& state) {
  constexpr Index links = 30;
  const double rod = 0.08, radius = 0.005, length = 0.02;
  const double round = rod + radius - 2e-4;  // of the links' middles about the rod
  std::vector<collision::Shape> shapes = {
      {collision::Cylinder{rod, 1}, Link::world,
       turned(std::numbers::pi / 2, Vector3d::UnitX(), Vector3d::Zero())}};
  std::vector<Pose> poses;
  std::vector<collision::LinkPair> neighbours;
  for (Index i = 0; i < links; ++i) {
    shapes.push_back({collision::Capsule{radius, length}, i});
    const double along = length * (static_cast<double>(i) - (links - 1) / 2.0);
    const double quarter = std::numbers::pi / 2 * round;
    const double angle = std::clamp(along, -quarter, quarter) / round;
    const double down = std::abs(along) - std::min(std::abs(along), quarter);
    const Vector3d place(round * std::sin(angle), 0, round * std::cos(angle) - down);
    poses.push_back(turned(angle + std::numbers::pi / 2, Vector3d::UnitY(), place));
    if (i > 0) neighbours.emplace_back(i - 1, i);
  }
  collide(state, std::move(shapes), std::move(poses), neighbours);
}

void box_on_cylinder(benchmark::State& state) {
  pair_of_shapes(state, collision::Box{{0.06, 0.04, 0.02}},
                 turned(0.3, Vector3d::UnitZ(), {0.005, 0, 0.0298}),
                 collision::Cylinder{0.02, 0.04});
}

void cylinder_on_cylinder(benchmark::State& state) {
  pair_of_shapes(state, collision::Cylinder{0.02, 0.2},
                 turned(1.2, Vector3d::UnitX(), {0.0398, 0, 0}), collision::Cylinder{0.02, 0.2});
}

void ring_on_ring(benchmark::State& state) {
  const collision::Ring ring = round_ring(0.02, 0.0015);
  pair_of_shapes(state, ring, turned(1.4, Vector3d::UnitX(), {0.0373, 0.0004, 0.0003}), ring);
}

void ring_on_ring_as_meshes(benchmark::State& state) {
  const collision::Mesh mesh = mesh_of(round_ring(0.02, 0.0015), 12);
  pair_of_shapes(state, mesh, turned(1.4, Vector3d::UnitX(), {0.0373, 0.0004, 0.0003}), mesh);
}

BENCHMARK(box_on_cylinder)->Unit(benchmark::kMicrosecond);
BENCHMARK(cylinder_on_cylinder)->Unit(benchmark::kMicrosecond);
BENCHMARK(ring_on_ring)->Unit(benchmark::kMicrosecond);
BENCHMARK(ring_on_ring_as_meshes)->Unit(benchmark::kMicrosecond);
BENCHMARK(chain_on_a_rod)->Unit(benchmark::kMicrosecond);

BENCHMARK(positions_and_velocities)->Unit(benchmark::kMicrosecond);
BENCHMARK(assembling)->Unit(benchmark::kMicrosecond);
BENCHMARK(disassembling)->Unit(benchmark::kMicrosecond);
BENCHMARK(contact_matrix)->Unit(benchmark::kMicrosecond);
BENCHMARK(chain_assembling)->Unit(benchmark::kMicrosecond);
BENCHMARK(chain_disassembling)->Unit(benchmark::kMicrosecond);
BENCHMARK(chain_contact_matrix)->Unit(benchmark::kMicrosecond);
BENCHMARK(chain_joint_space_factor)->Unit(benchmark::kMicrosecond);
BENCHMARK(chain_joint_space_matrix)->Unit(benchmark::kMicrosecond);
BENCHMARK(posing_the_lcp)->Unit(benchmark::kMicrosecond);
BENCHMARK(whole_step)->Unit(benchmark::kMicrosecond)->Iterations(500);

}  // namespace
}  // namespace lcp

BENCHMARK_MAIN();
