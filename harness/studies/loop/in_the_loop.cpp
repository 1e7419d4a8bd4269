#include "harness/studies/loop/in_the_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>

#include "harness/judge/judge.h"
#include "harness/measure/solve.h"
#include "problems/contact/islands.h"

namespace lcp {

namespace {

using Clock = std::chrono::steady_clock;

/// Of s_w: how fast a contact may close under the forces that act before it counts as violated.
constexpr double kViolation = 1e-6;

std::int64_t since(Clock::time_point begin) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - begin).count();
}

/// Wall-clock and processor time that passed.
struct Elapsed {
  std::int64_t wall_ns = 0, cpu_ns = 0;

  Elapsed& operator+=(const Elapsed& more) {
    wall_ns += more.wall_ns;
    cpu_ns += more.cpu_ns;
    return *this;
  }
};

/// Runs from where it is made.
class Stopwatch {
 public:
  Elapsed read() const { return {since(begin_), processor_ns() - cpu_begin_}; }

 private:
  static std::int64_t processor_ns() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
  }

  Clock::time_point begin_ = Clock::now();
  std::int64_t cpu_begin_ = processor_ns();
};

/// Judges by the loop's criterion. A claim other than solved stays what it is.
Judgement judge_by(const Acceptance& acceptance, const Problem& problem, const Result& result) {
  const Instance instance{.name = "frame",
                          .problem = problem,
                          .provenance = {},
                          .known_solution = {},
                          .active_contacts = {},
                          .previous = {},
                          .sha256 = {}};
  return judge(instance, result, acceptance);
}

/// The angle nearest to `before` that stands for the same direction as `angle`.
double continued(double angle, double before) {
  const double turn = 2 * std::numbers::pi;
  return angle + turn * std::round((before - angle) / turn);
}

Index violated_contacts(const ContactSolution& solution) {
  const Problem& problem = solution.frictional;
  const FrictionBlocks& blocks = *problem.friction;
  const VectorXd velocity = post_velocities(blocks, solution.forces);
  Index count = 0;
  for (Index i = 0; i < blocks.contacts(); ++i)
    count += velocity(3 * i) < -kViolation * problem.s_w(blocks.normal_row[i]);
  return count;
}

/// One simulation: the solver's calls timed, its answers judged outside the clock.
class DrivenSimulation {
 public:
  DrivenSimulation(const NamedScene& scene, const NamedSolver& solver, const Acceptance& acceptance,
                   const FrameLook& look)
      : simulation_(scene.setup.system, scene.setup.stepping),
        solver_(solver),
        acceptance_(acceptance),
        look_(look) {
    contact_solver_.solve = [this](const Problem& problem, const Call& call) {
      const Stopwatch splitting;
      const std::vector<Island> islands =
          has_islands(problem) ? split_islands(problem) : std::vector<Island>{};
      outside_ += splitting.read();
      const Stopwatch solving;
      Result result = islands.empty()
                          ? solver_.solver->solve(problem, call)
                          : solve_islands(*solver_.solver, islands, problem.size(), call);
      solves_.push_back(solving.read());
      return result;
    };
    contact_solver_.accept = [this](const Problem& problem, const Result& result) {
      const Stopwatch judging;
      judgements_.push_back(judge_by(acceptance_, problem, result));
      outside_ += judging.read();
      return judgements_.back().verdict == Verdict::solved;
    };
  }

  FrameRecord step() {
    solves_.clear();
    judgements_.clear();
    outside_ = {};
    FrameRecord record;
    const Stopwatch stepping;
    simulation_.step(contact_solver_, [&](const Frame& frame) {
      const Stopwatch looking;
      describe(frame, record);
      if (look_) look_(simulation_, frame, record);
      outside_ += looking.read();
    });
    const Elapsed step = stepping.read();
    record.step_ns = step.wall_ns - outside_.wall_ns;
    record.step_cpu_ns = step.cpu_ns - outside_.cpu_ns;
    return record;
  }

  std::vector<Vector3d> centres() const {
    const Model& model = simulation_.system().model;
    return link_centres(model, kinematics(model, simulation_.state()));
  }

 private:
  /// By trapezoids over the steps.
  void count_work(const Frame& frame, FrameRecord& record) {
    const Kinematics& k = frame.kinematics;
    double power = 0;
    for (const PointForce& pull : frame.pulls) {
      record.pull += pull.force;
      power += pull.force.dot(velocity_at(k.from_origin(pull.position), k.velocity[pull.link]));
    }
    work_ += simulation_.stepping().dt * (power_ + power) / 2;
    power_ = power;
    record.pull_work = work_;
  }

  void describe(const Frame& frame, FrameRecord& record) {
    const Model& model = simulation_.system().model;
    const Kinematics& k = frame.kinematics;
    record.frame = frame.number;
    record.time = frame.state.time;
    record.points_found = frame.points_found;
    record.contacts = frame.contacts.size();
    record.centre_of_mass = centre_of_mass(model, k);
    record.com_velocity = momentum(model, k).tail<3>() / model.mass();
    const Matrix3d& R = k.pose.front().R;
    yaw_ = continued(std::atan2(R(1, 0), R(0, 0)), yaw_);
    record.yaw = yaw_;
    record.tilt = std::acos(std::clamp(R(2, 2), -1.0, 1.0));
    record.handle_forces.assign(simulation_.system().handles.size(), Vector3d::Zero());
    for (std::size_t h = 0; h < record.handle_forces.size(); ++h)
      record.handle_forces[h] = frame.link_forces.segment<3>(6 * h + 3);
    record.energy = energy(model, k, simulation_.system().gravity);
    record.kinetic = energy(model, k, Vector3d::Zero());
    record.gap = largest_gap(k);
    count_work(frame, record);
    if (record.contacts == 0) return;
    record.depth = frame.links.depth.maxCoeff();
    for (Index i = 0; i < record.contacts; ++i)
      record.approach = std::max(record.approach, -frame.links.velocity(3 * i));
    const ContactSolution& solution = frame.solution;
    record.n = solution.frictional.size();
    record.active = solution.active;
    record.frictionless = judgements_.front().verdict;
    record.frictional = judgements_.back().verdict;
    record.accuracy = judgements_.back().accuracy;
    record.message = solution.with_friction.message;
    record.applied = solution.applied;
    record.violated = violated_contacts(solution);
    record.work = solution.with_friction.work;
    for (const Elapsed& solve : solves_) record.lcp_cpu_ns += solve.cpu_ns;
    record.frictional_ns = solves_.back().wall_ns;
    if (solves_.size() == 1) return;  // no friction: the two are one
    record.frictionless_work = solution.without_friction.work;
    record.frictionless_ns = solves_.front().wall_ns;
  }

  Simulation simulation_;
  const NamedSolver& solver_;
  const Acceptance& acceptance_;
  const FrameLook& look_;
  ContactSolver contact_solver_;
  std::vector<Elapsed> solves_;        ///< Of the frame: frictionless, frictional.
  std::vector<Judgement> judgements_;  ///< Likewise.
  Elapsed outside_;                    ///< What the frame spent on judging and looking.
  double yaw_ = 0;
  double work_ = 0, power_ = 0;  ///< J, W, of what pulls.
};

/// Why a simulation at `time` (s) is not to go on; empty where it is.
std::string reason_to_stop(const std::atomic<bool>& interrupted, std::optional<double> limit,
                           Clock::time_point begin, double time) {
  if (interrupted) return "interrupted";
  if (limit && static_cast<double>(since(begin)) >= 1e9 * *limit)
    return fmt::format("stopped after {:g} s of computing at t = {:g} s", *limit, time);
  return "";
}

bool is_anchored(const Model& model) {
  for (const Link& link : model.links())
    if (link.parent == Link::world && link.joint != JointKind::free) return true;
  for (const Loop& loop : model.loops())
    if (loop.link1 == Link::world) return true;
  return false;
}

}  // namespace

LoopRun run_in_the_loop(const NamedScene& scene, const NamedSolver& solver,
                        const Acceptance& acceptance, const FrameLook& look,
                        const std::atomic<bool>& interrupted, std::optional<double> limit) {
  LoopRun run{.scene = scene.spelling,
              .solver = solver.spelling,
              .acceptance = acceptance,
              .dt = scene.setup.stepping.dt,
              .duration = scene.setup.duration,
              .frames = {},
              .broken = {},
              .stopped = false,
              .driven = !scene.setup.system.model.prescribed().empty(),
              .anchored = is_anchored(scene.setup.system.model),
              .trail = {}};
  const Index steps = std::lround(run.duration / run.dt);
  DrivenSimulation driven(scene, solver, acceptance, look);
  run.frames.reserve(steps);
  const Clock::time_point begin = Clock::now();
  run.trail.push_back(driven.centres());
  for (Index i = 0; i < steps; ++i) {
    run.broken = reason_to_stop(interrupted, limit, begin, static_cast<double>(i) * run.dt);
    run.stopped = !run.broken.empty();
    if (run.stopped) break;
    try {
      run.frames.push_back(driven.step());
      if ((i + 1) * trail_parts / steps > i * trail_parts / steps)
        run.trail.push_back(driven.centres());
    } catch (const SimulationBroke& error) {
      run.broken = error.what();
      break;
    }
  }
  return run;
}

}  // namespace lcp
