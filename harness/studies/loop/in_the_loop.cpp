#include "harness/studies/loop/in_the_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "harness/judge/judge.h"
#include "harness/measure/solve.h"
#include "problems/contact/islands.h"

namespace lcp {

namespace {

/// Of s_w: how fast a contact may close under the forces that act before it counts as violated.
constexpr double kViolation = 1e-6;

std::int64_t clock_ns(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

/// Wall-clock and processor time that passed.
struct Elapsed {
  std::int64_t wall_ns = 0, cpu_ns = 0;
};

/// Adds the time from where it is made to where it ends.
class Timed {
 public:
  explicit Timed(Elapsed& sum) : sum_(sum) {}
  ~Timed() {
    sum_.wall_ns += clock_ns(CLOCK_MONOTONIC) - begin_.wall_ns;
    sum_.cpu_ns += clock_ns(CLOCK_PROCESS_CPUTIME_ID) - begin_.cpu_ns;
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  Elapsed& sum_;
  const Elapsed begin_ = {clock_ns(CLOCK_MONOTONIC), clock_ns(CLOCK_PROCESS_CPUTIME_ID)};
};

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
      std::vector<Island> islands;
      if (const Timed splitting(outside_); has_islands(problem)) islands = split_islands(problem);
      const Timed solving(solves_.emplace_back());
      return islands.empty() ? solver_.solver->solve(problem, call)
                             : solve_islands(*solver_.solver, islands, problem.size(), call);
    };
    contact_solver_.accept = [this](const Problem& problem, const Result& result) {
      const Timed judging(outside_);
      Instance instance;
      instance.problem = problem;
      judgements_.push_back(judge(instance, result, acceptance_));
      return judgements_.back().verdict == Verdict::solved;
    };
  }

  FrameRecord step() {
    solves_.clear();
    judgements_.clear();
    outside_ = {};
    FrameRecord record;
    Elapsed all;
    {
      const Timed stepping(all);
      simulation_.step(contact_solver_, [&](const Frame& frame) {
        const Timed looking(outside_);
        describe(frame, record);
        if (look_) look_(simulation_, frame, record);
      });
    }
    record.step_ns = all.wall_ns - outside_.wall_ns;
    record.step_cpu_ns = all.cpu_ns - outside_.cpu_ns;
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

bool is_anchored(const Model& model) {
  for (const Link& link : model.links())
    if (link.parent == Link::world && link.joint != JointKind::free) return true;
  for (const Loop& loop : model.loops())
    if (loop.link1 == Link::world) return true;
  return false;
}

}  // namespace

LoopHeader loop_header(const NamedScene& scene, const std::string& solver) {
  return {scene.spelling, solver, scene.setup.stepping.dt};
}

Index steps_to_make(const NamedScene& scene) {
  return std::lround(scene.setup.duration / scene.setup.stepping.dt);
}

LoopRun run_in_the_loop(const NamedScene& scene, const NamedSolver& solver,
                        const Acceptance& acceptance, const FrameLook& look,
                        const std::atomic<bool>& interrupted, std::optional<double> limit) {
  const Model& model = scene.setup.system.model;
  LoopRun run{loop_header(scene, solver.spelling), acceptance, scene.setup.duration};
  run.driven = !model.prescribed().empty();
  run.anchored = is_anchored(model);
  const Index steps = steps_to_make(scene);
  DrivenSimulation driven(scene, solver, acceptance, look);
  run.frames.reserve(steps);
  const std::int64_t begin = clock_ns(CLOCK_MONOTONIC);
  run.trail.push_back(driven.centres());
  for (Index i = 0; i < steps && run.broken.empty(); ++i) {
    const auto computed = static_cast<double>(clock_ns(CLOCK_MONOTONIC) - begin);
    if (interrupted)
      run.broken = "interrupted";
    else if (limit && computed >= 1e9 * *limit)
      run.broken = fmt::format("stopped after {:g} s of computing at t = {:g} s", *limit,
                               static_cast<double>(i) * run.dt);
    run.stopped = !run.broken.empty();
    if (run.stopped) break;
    try {
      run.frames.push_back(driven.step());
      if ((i + 1) * trail_parts / steps > i * trail_parts / steps)
        run.trail.push_back(driven.centres());
    } catch (const SimulationBroke& error) {
      run.broken = error.what();
    }
  }
  return run;
}

}  // namespace lcp
