#include <fmt/format.h>

#include "harness/cli/loop_options.h"
#include "harness/cli/page.h"
#include "harness/cli/quantity.h"
#include "harness/cli/study_output.h"
#include "harness/studies/sufficient/report.h"

namespace lcp::cli {

namespace {

constexpr double kMostByDefault = 1;  // s, of simulated time

struct SufficientArguments {
  std::vector<std::string> scenes;
  std::string reference_solver = "best-first";
  std::vector<std::string> solvers;
  std::vector<std::string> durations;  ///< One for all scenes, or one for each.
  std::string reference_dt, window = "20ms", silence = "1min";
  StudyPlan plan;  ///< The rest of it; tolerances in the units of their kinds.
  StudyOutput output;
};

StudyPlan study_plan(const std::string& scene, const std::string& duration,
                     const SufficientArguments& arguments) {
  StudyPlan plan = arguments.plan;
  plan.ladder = make_ladder(scene, arguments.reference_solver, arguments.solvers,
                            parse_seconds(arguments.reference_dt, "--reference-dt"));
  for (const ErrorKind& kind : error_kinds) plan.criteria.*kind.tolerance /= kind.scale;
  plan.criteria.window = parse_seconds(arguments.window, "--window").value();
  plan.duration = duration.empty() ? std::min(kMostByDefault, make_scene(scene).setup.duration)
                                   : *parse_seconds(duration, "--duration");
  plan.silence = parse_duration(arguments.silence, "--silence");
  return plan;
}

/// Names every model that would be simulated without knowing which pass.
void print_plan(const StudyPlan& plan) {
  const ModelLadder& ladder = plan.ladder;
  const SceneModel reference = model_of(ladder, Rungs(ladder.axes.size(), 0));
  fmt::print("{}: up to {:g} s, {} rounds\n  reference: {} with {}\n", ladder.scene, plan.duration,
             plan.rounds, reference.scene, reference.solver);
  for (std::size_t axis = 0; axis < ladder.axes.size(); ++axis)
    for (std::size_t rung = 1; rung < ladder.axes[axis].rungs.size(); ++rung) {
      Rungs rungs(ladder.axes.size(), 0);
      rungs[axis] = rung;
      fmt::print("  {:<10} {}\n", ladder.axes[axis].name, model_of(ladder, rungs).label);
    }
  for (const std::string& kept : ladder.kept) fmt::print("  {:<10} kept as it is\n", kept);
}

int sufficient(const SufficientArguments& arguments) {
  std::vector<StudyPlan> plans;
  const std::size_t durations = arguments.durations.size();
  if (durations > 1 && durations != arguments.scenes.size())
    throw std::invalid_argument(
        fmt::format("--duration: {} of them for {} scenes, expected one for all or one for each",
                    durations, arguments.scenes.size()));
  for (std::size_t i = 0; i < arguments.scenes.size(); ++i)
    plans.push_back(study_plan(arguments.scenes[i],
                               durations == 0 ? "" : arguments.durations[durations == 1 ? 0 : i],
                               arguments));
  if (!arguments.output.dry_run)
    return publish(arguments.output, "sufficient",
                   [&](const auto& progress, const auto& interrupted) {
                     std::vector<Study> studies;
                     for (const StudyPlan& plan : plans)
                       studies.push_back(study(plan, progress, interrupted));
                     return described(studies);
                   });
  for (const StudyPlan& plan : plans) print_plan(plan);
  return done;
}

void sufficient_options(CLI::App& page, SufficientArguments& arguments) {
  StudyPlan& plan = arguments.plan;
  add(page, "SCENE", arguments.scenes,
      "NAME[:key=value,...], or several; an axis whose knob is given is not varied")
      ->required();
  add_with_default(
      page, "--reference-solver", arguments.reference_solver,
      "NAME[:key=value,...] of the reference, and of every model but on the solvers' axis");
  add(page, "--solver", arguments.solvers,
      "NAME[:key=value,...] to try besides the ladder's; repeatable");
  add(page, "--reference-dt", arguments.reference_dt,
      "Time step of the reference, number with ms or s. Default: the scene's");
  add(page, "--duration", arguments.durations,
      "Simulated time, likewise; repeatable: one for each scene. Default: the scene's, 1 s at "
      "most");
  const auto positive = [&](const char* name, double& value, const char* meaning) {
    add_with_default(page, name, value, meaning, CLI::PositiveNumber);
  };
  for (const ErrorKind& kind : error_kinds) {
    plan.criteria.*kind.tolerance *= kind.scale;
    positive(fmt::format("--{}", kind.name).c_str(), plan.criteria.*kind.tolerance,
             fmt::format("Tolerance, {}: {}", kind.unit, kind.meaning).c_str());
  }
  add_with_default(page, "--window", arguments.window, "Over which forces are averaged");
  positive("--disturbance", plan.disturbance,
           "Of the reference's velocities at the start, for the noise floor, m/s and rad/s");
  positive("--floor-share", plan.floor_share,
           "Models are compared until the floor passes this share of a tolerance");
  add_with_default(page, "--rounds", plan.rounds, "Simulations of each model, for its times",
                   CLI::Range(1, 1000));
  positive("--patience", plan.patience,
           "Computing time over the reference's (1 s at least) at which a model is stopped");
  add_with_default(page, "--silence", arguments.silence,
                   "Time without a step after which a simulation is given up");
  add_study_output(page, arguments.output, "sufficient");
}

}  // namespace

Verb add_sufficient(CLI::App& program) {
  return make_verb<SufficientArguments>(
      program, "sufficient",
      "Which is the cheapest model of a scene that is enough, by physical error",
      sufficient_options, sufficient,
      "Each axis (friction, contacts, inactive contacts, contact matrix, time step, solver) is "
      "varied alone, then what passes and saves most of each together; where that fails, axes are "
      "added to the best one by one. Judged against the richest model by what bodies do, not by "
      "residuals.\n"
      "Example:\n"
      "  lcpbench sufficient squat --duration 300ms\n"
      "  lcpbench sufficient hoist:links=12 --force 5 --solver lexicographic-revised --out "
      "runs/hoist");
}

}  // namespace lcp::cli
