// Micro-benchmarks of what a step of `squat` is made of: 21 links, 2 handles, 16 contacts, n = 160.
// A step under RK4 assembles and disassembles four times and poses one LCP.

#include <benchmark/benchmark.h>

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

BENCHMARK(positions_and_velocities)->Unit(benchmark::kMicrosecond);
BENCHMARK(assembling)->Unit(benchmark::kMicrosecond);
BENCHMARK(disassembling)->Unit(benchmark::kMicrosecond);
BENCHMARK(contact_matrix)->Unit(benchmark::kMicrosecond);
BENCHMARK(posing_the_lcp)->Unit(benchmark::kMicrosecond);
BENCHMARK(whole_step)->Unit(benchmark::kMicrosecond)->Iterations(500);

}  // namespace
}  // namespace lcp

BENCHMARK_MAIN();
