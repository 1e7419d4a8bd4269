#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "harness/cli/interrupt.h"
#include "harness/cli/output_directory.h"
#include "harness/cli/progress.h"
#include "harness/cli/quantity.h"
#include "harness/cli/table_formats.h"
#include "harness/cli/verbs.h"
#include "harness/measure/environment.h"
#include "harness/studies/sufficient/report.h"
#include "problems/io/replace_file.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp::cli {

namespace {

constexpr double kMostByDefault = 1;  // s, of simulated time

struct SufficientArguments {
  std::vector<std::string> scenes;
  std::string reference_solver = "best-first";
  std::vector<std::string> solvers;
  std::vector<std::string> durations;  ///< One for all scenes, or one for each.
  std::string reference_dt, window = "20ms", silence = "1min";
  double trajectory = 1, force = 2, penetration = 1, slip = 1;
  double disturbance = 1e-12, floor_share = 0.25, patience = 4;
  int rounds = 3;
  std::string format = "text";
  bool json = false, dry_run = false;
  std::string out;
};

double simulated_seconds(const std::string& text, const char* option) {
  return std::chrono::duration<double>(parse_duration(text, option)).count();
}

StudyPlan study_plan(const std::string& scene, const std::string& duration,
                     const SufficientArguments& arguments) {
  StudyPlan plan;
  std::optional<double> dt;
  if (!arguments.reference_dt.empty())
    dt = simulated_seconds(arguments.reference_dt, "--reference-dt");
  plan.ladder = make_ladder(scene, arguments.reference_solver, arguments.solvers, dt);
  plan.criteria = {.trajectory = 1e-3 * arguments.trajectory,
                   .force = 1e-2 * arguments.force,
                   .window = simulated_seconds(arguments.window, "--window"),
                   .penetration = 1e-3 * arguments.penetration,
                   .slip = 1e-3 * arguments.slip};
  plan.duration = duration.empty() ? std::min(kMostByDefault, make_scene(scene).setup.duration)
                                   : simulated_seconds(duration, "--duration");
  plan.disturbance = arguments.disturbance;
  plan.floor_share = arguments.floor_share;
  plan.patience = arguments.patience;
  plan.rounds = arguments.rounds;
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
  if (arguments.dry_run) {
    for (const StudyPlan& plan : plans) print_plan(plan);
    return done;
  }
  if (!arguments.out.empty()) require_new(arguments.out);
  const std::atomic<bool>& interrupted = catch_interruptions();
  std::vector<Study> studies;
  for (const StudyPlan& plan : plans) {
    std::unique_ptr<ProgressBar> bar = std::make_unique<ProgressBar>();
    std::size_t before = 0;
    std::optional<Study> made = study(
        plan,
        [&](const Progress& progress) {
          if (progress.done < before) bar = std::make_unique<ProgressBar>();  // another phase
          before = progress.done;
          bar->update(progress);
        },
        interrupted);
    if (!made) {
      fmt::print(stderr, "interrupted: nothing is written\n");
      return interrupted_by_user;
    }
    studies.push_back(std::move(*made));
  }
  if (!arguments.out.empty())
    write_directory(arguments.out, [&](const std::filesystem::path& into) {
      replace_file((into / "sufficient.txt").string(), render(studies, TableFormat::text));
      replace_file((into / "sufficient.csv").string(), render(studies, TableFormat::csv));
      replace_file((into / "sufficient.json").string(), render(studies, TableFormat::json));
      replace_file((into / "env.json").string(), describe_environment(1).dump(1) + "\n");
      draw_studies(studies, into / "sufficient.svg");
    });
  fmt::print("{}", render(studies, chosen_format(arguments.format, arguments.json)));
  if (!arguments.out.empty()) fmt::print(stderr, "tables and picture are in {}\n", arguments.out);
  return done;
}

}  // namespace

Verb add_sufficient(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "sufficient", "Which is the cheapest model of a scene that is enough, by physical error");
  auto arguments = std::make_shared<SufficientArguments>();
  page->add_option("SCENE", arguments->scenes,
                   "NAME[:key=value,...], or several; an axis whose knob is given is not varied")
      ->required();
  page->add_option("--reference-solver", arguments->reference_solver,
                   "NAME[:key=value,...] of the reference, and of every model but on the solvers' "
                   "axis")
      ->capture_default_str();
  page->add_option("--solver", arguments->solvers,
                   "NAME[:key=value,...] to try besides the ladder's; repeatable")
      ->allow_extra_args(false);
  page->add_option("--reference-dt", arguments->reference_dt,
                   "Time step of the reference, number with ms or s. Default: the scene's");
  page->add_option("--duration", arguments->durations,
                   "Simulated time, likewise; repeatable: one for each scene. Default: the "
                   "scene's, 1 s at most")
      ->allow_extra_args(false);
  page->add_option("--trajectory", arguments->trajectory,
                   "Tolerance: largest distance of a link's centre of mass, mm")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--force", arguments->force,
                   "Tolerance: contact forces on a mechanism, averaged, % of the weight")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--window", arguments->window, "Over which forces are averaged")
      ->capture_default_str();
  page->add_option("--penetration", arguments->penetration, "Tolerance: largest overlap, mm")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--slip", arguments->slip,
                   "Tolerance: way that a link slips on its contacts, mm")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--disturbance", arguments->disturbance,
                   "Of the reference's velocities at the start, for the noise floor, m/s and rad/s")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--floor-share", arguments->floor_share,
                   "Models are compared until the floor passes this share of a tolerance")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--rounds", arguments->rounds, "Simulations of each model, for its times")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  page->add_option("--patience", arguments->patience,
                   "Computing time over the reference's (1 s at least) at which a model is stopped")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--silence", arguments->silence,
                   "Time without a step after which a simulation is given up")
      ->capture_default_str();
  page->add_option("--format", arguments->format, "How it is printed")
      ->check(CLI::IsMember({"text", "csv", "json"}))
      ->capture_default_str();
  page->add_flag("--json", arguments->json, "The same as --format json");
  page->add_flag("--dry-run", arguments->dry_run, "Print the models, simulate none");
  page->add_option("--out", arguments->out,
                   "New directory for sufficient.txt, .csv, .json, .svg and env.json");
  page->footer(
      "Each axis (friction, contacts, inactive contacts, contact matrix, time step, solver) is "
      "varied alone, then what passes and saves most of each together; where that fails, axes are "
      "added to the best one by one. Judged against the richest model by what bodies do, not by "
      "residuals.\n"
      "Example:\n"
      "  lcpbench sufficient squat --duration 300ms\n"
      "  lcpbench sufficient hoist:links=12 --force 5 --solver lexicographic-revised --out "
      "runs/hoist");
  return {page, [arguments] { return sufficient(*arguments); }};
}

}  // namespace lcp::cli
