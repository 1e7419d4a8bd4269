#include "harness/studies/loop/loop.h"

#include <fmt/format.h>

#include "harness/cli/loop_options.h"
#include "harness/cli/page.h"
#include "harness/cli/quantity.h"
#include "harness/cli/stability/parts.h"
#include "harness/cli/study_output.h"

namespace lcp::cli {

namespace {

struct LoopArguments {
  std::string scene;
  std::vector<std::string> solvers;
  std::string reference = "best-first:refactor_every=1";
  LoopOptions loop;
  std::string limit = "2min", silence = "1min";
  double disturbance = 1e-12, departure = 1;
  StudyOutput output;
};

LoopPlan plan_of(const LoopArguments& arguments) {
  LoopPlan plan;
  plan.scene = make_scene(arguments.scene).spelling;
  plan.dt = arguments.loop.dt_s();
  plan.duration = arguments.loop.duration_s();
  plan.reference = make_solver(arguments.reference).spelling;
  for (const NamedSolver& solver : make_solvers(arguments.solvers))
    plan.solvers.push_back(solver.spelling);
  plan.acceptance = arguments.loop.acceptance();
  plan.disturbance = arguments.disturbance;
  plan.departure = 1e-3 * arguments.departure;
  plan.limit = std::chrono::duration<double>(parse_duration(arguments.limit, "--limit")).count();
  plan.silence = parse_duration(arguments.silence, "--silence");
  return plan;
}

int drive(const LoopArguments& arguments) {
  const LoopPlan plan = plan_of(arguments);
  if (!arguments.output.dry_run)
    return publish(arguments.output, "loop", [&](const auto& progress, const auto& interrupted) {
      return described(loop_study(plan, progress, interrupted));
    });
  fmt::print(
      "{}, each for {} of computing at most:\n  {} (the reference)\n  the same, disturbed\n"
      "  the same, half the time step\n",
      plan.scene, printed_duration(plan.limit), plan.reference);
  for (const std::string& solver : plan.solvers) fmt::print("  {}\n", solver);
  return done;
}

void loop_study_options(CLI::App& page, LoopArguments& arguments) {
  add(page, "SCENE", arguments.scene, "NAME[:key=value,...] (see: lcpbench list scenes)")
      ->required();
  add(page, "--solver", arguments.solvers,
      "NAME[:key=value,...], all, own, or a pattern; repeatable")
      ->required();
  add_with_default(page, "--reference", arguments.reference,
                   "NAME[:key=value,...] whose motion the others are compared with");
  add_loop_options(page, arguments.loop);
  add_with_default(page, "--disturbance", arguments.disturbance,
                   "Of the velocities at the start, for the reference disturbed, m/s and rad/s",
                   CLI::PositiveNumber);
  add_with_default(page, "--departure", arguments.departure,
                   "Distance from the reference at which motions count as parted, mm",
                   CLI::PositiveNumber);
  add_with_default(page, "--limit", arguments.limit,
                   "Computing time after which a simulation is stopped");
  add_with_default(page, "--silence", arguments.silence,
                   "Time without a step after which a simulation is given up");
  add_study_output(page, arguments.output, "loop");
}

}  // namespace

Verb add_stability_loop(CLI::App& stability) {
  return make_verb<LoopArguments>(
      stability, "loop", "Drive a scene with each solver: how far motions part, beside residuals",
      loop_study_options, drive,
      "Beside the solvers stand two controls: the reference with its start disturbed, and with "
      "half "
      "the time step. --format csv: curves over time.\n"
      "Example:\n"
      "  lcpbench stability loop squat --solver 'lexicographic*' --solver projected-gauss-seidel "
      "--duration 300ms\n"
      "  lcpbench stability loop hoist --solver lemke --duration 500ms --out runs/loop-hoist");
}

}  // namespace lcp::cli
