#include "harness/studies/loop/loop.h"

#include <fmt/format.h>

#include <memory>

#include "harness/cli/interrupt.h"
#include "harness/cli/loop_options.h"
#include "harness/cli/output_directory.h"
#include "harness/cli/quantity.h"
#include "harness/cli/stability/parts.h"
#include "harness/cli/table_formats.h"
#include "harness/measure/environment.h"
#include "harness/cli/progress.h"
#include "problems/io/replace_file.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp::cli {

namespace {

struct LoopArguments {
  std::string scene;
  std::vector<std::string> solvers;
  std::string reference = "best-first:refactor_every=1";
  LoopOptions loop;
  std::string limit = "2min", silence = "1min";
  double disturbance = 1e-12, departure = 1;
  std::string format = "text";
  bool json = false, dry_run = false;
  std::string out;
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
  if (arguments.dry_run) {
    fmt::print(
        "{}, each for {} of computing at most:\n  {} (the reference)\n  the same, disturbed\n"
        "  the same, half the time step\n",
        plan.scene, printed_duration(plan.limit), plan.reference);
    for (const std::string& solver : plan.solvers) fmt::print("  {}\n", solver);
    return done;
  }
  if (!arguments.out.empty()) require_new(arguments.out);
  const std::atomic<bool>& interrupted = catch_interruptions();
  std::optional<LoopStudy> study;
  {
    ProgressBar bar;
    study = loop_study(
        plan, [&bar](const Progress& progress) { bar.update(progress); }, interrupted);
  }
  if (!study) {
    fmt::print(stderr, "interrupted: nothing is written\n");
    return interrupted_by_user;
  }
  if (!arguments.out.empty())
    write_directory(arguments.out, [&](const std::filesystem::path& into) {
      replace_file((into / "loop.txt").string(), render(*study, TableFormat::text));
      replace_file((into / "loop.csv").string(), render(*study, TableFormat::csv));
      replace_file((into / "loop.json").string(), render(*study, TableFormat::json));
      replace_file((into / "env.json").string(), describe_environment(1).dump(1) + "\n");
      draw_loop_study(*study, into / "loop.svg");
    });
  fmt::print("{}", render(*study, chosen_format(arguments.format, arguments.json)));
  if (!arguments.out.empty())
    fmt::print(stderr, "table, curves and picture are in {}\n", arguments.out);
  return done;
}

}  // namespace

Verb add_stability_loop(CLI::App& stability) {
  CLI::App* page = stability.add_subcommand(
      "loop", "Drive a scene with each solver: how far motions part, beside residuals");
  auto arguments = std::make_shared<LoopArguments>();
  page->add_option("SCENE", arguments->scene, "NAME[:key=value,...] (see: lcpbench list scenes)")
      ->required();
  page->add_option("--solver", arguments->solvers,
                   "NAME[:key=value,...], all, own, or a pattern; repeatable")
      ->required()
      ->allow_extra_args(false);
  page->add_option("--reference", arguments->reference,
                   "NAME[:key=value,...] whose motion the others are compared with")
      ->capture_default_str();
  add_loop_options(*page, arguments->loop);
  page->add_option("--disturbance", arguments->disturbance,
                   "Of the velocities at the start, for the reference disturbed, m/s and rad/s")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--departure", arguments->departure,
                   "Distance from the reference at which motions count as parted, mm")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--limit", arguments->limit,
                   "Computing time after which a simulation is stopped")
      ->capture_default_str();
  page->add_option("--silence", arguments->silence,
                   "Time without a step after which a simulation is given up")
      ->capture_default_str();
  page->add_option("--format", arguments->format, "How it is printed; csv: curves over time")
      ->check(CLI::IsMember({"text", "csv", "json"}))
      ->capture_default_str();
  page->add_flag("--json", arguments->json, "The same as --format json");
  page->add_flag("--dry-run", arguments->dry_run, "Print the simulations, make none");
  page->add_option("--out", arguments->out,
                   "New directory for loop.txt, .csv, .json, .svg and env.json");
  page->footer(
      "Beside the solvers stand two controls: the reference with its start disturbed, and with "
      "half "
      "the time step.\n"
      "Example:\n"
      "  lcpbench stability loop squat --solver 'lexicographic*' --solver projected-gauss-seidel "
      "--duration 300ms\n"
      "  lcpbench stability loop hoist --solver lemke --duration 500ms --out runs/loop-hoist");
  return {page, [arguments] { return drive(*arguments); }, {}};
}

}  // namespace lcp::cli
