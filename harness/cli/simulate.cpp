#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>

#include "harness/cli/interrupt.h"
#include "harness/cli/loop_options.h"
#include "harness/cli/progress.h"
#include "harness/cli/verbs.h"
#include "harness/present/scenes/scene_picture.h"
#include "harness/studies/loop/summary.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"
#include "problems/scenes/dump.h"

namespace lcp::cli {

namespace {

struct SimulateArguments {
  std::string scene;
  std::string solver = "best-first";
  LoopOptions loop;
  std::string dump, log, picture;
  Index every = 1;
  bool failed_only = false;
  std::vector<std::string> at;
  bool json = false;
};

/// Times at which to draw, s.
std::vector<double> picture_times(const std::vector<std::string>& at, double duration) {
  if (at.empty()) return evenly_spread(duration, 3);
  std::vector<double> times;
  for (const std::string& text : at) {
    double time = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, time);
    if (error != std::errc() || stop != end)
      throw std::invalid_argument(
          fmt::format("--at {}: expected numbers of seconds with commas between", text));
    times.push_back(time);
  }
  return times;
}

bool is_dumped(const SimulateArguments& arguments, const FrameRecord& record) {
  if (arguments.failed_only && record.frictional == Verdict::solved) return false;
  return record.frame % arguments.every == 0;
}

/// Refuses a picture that could not be written when the simulation is over.
void check_picture(const std::string& picture) {
  const std::filesystem::path path(picture);
  if (path.extension() != ".svg")
    throw std::invalid_argument(fmt::format("--picture {}: expected a name in .svg", picture));
  const std::filesystem::path directory = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::is_directory(directory))
    throw UnwritableOutput(fmt::format("{}: cannot write: no such directory", picture));
}

int simulate(const SimulateArguments& arguments) {
  NamedScene scene = make_scene(arguments.scene);
  scene.setup.duration = arguments.loop.duration_s().value_or(scene.setup.duration);
  scene.setup.stepping.dt = arguments.loop.dt_s().value_or(scene.setup.stepping.dt);
  const NamedSolver solver = make_solver(arguments.solver);
  if (arguments.dump.empty() && (arguments.every != 1 || arguments.failed_only))
    throw std::invalid_argument("--every, --failed-only: expected --dump DIR with them");
  if (!arguments.at.empty() && arguments.picture.empty())
    throw std::invalid_argument("--at: expected --picture FILE with it");
  std::optional<Snapshots> snapshots;
  if (!arguments.picture.empty()) {
    check_picture(arguments.picture);
    snapshots.emplace(picture_times(arguments.at, scene.setup.duration), scene.setup.stepping.dt,
                      scene.setup.duration);
  }
  std::optional<CorpusDump> dump;
  if (!arguments.dump.empty()) dump.emplace(arguments.dump, scene.spelling, solver.spelling);

  const std::atomic<bool>& interrupted = catch_interruptions();
  const std::size_t steps =
      static_cast<std::size_t>(std::lround(scene.setup.duration / scene.setup.stepping.dt));
  LoopRun run;
  {
    ProgressBar bar;
    run = run_in_the_loop(
        scene, solver, arguments.loop.acceptance(),
        [&](const Simulation& simulation, const Frame& frame, const FrameRecord& record) {
          if (dump && is_dumped(arguments, record)) dump->add(simulation, frame);
          if (snapshots) snapshots->look(frame);
          bar.update({static_cast<std::size_t>(record.frame), steps, scene.spelling});
        },
        interrupted);
  }
  if (dump) dump->close();
  if (!arguments.log.empty()) replace_file(arguments.log, frames_csv(run));

  const LoopSummary summary =
      summarise(run, scene.setup.system.model.mass(), scene.setup.system.gravity);
  if (arguments.json) {
    fmt::print("{}\n", figures_of(summary).dump(1));
  } else {
    fmt::print("{}", render(summary));
  }
  if (snapshots && !snapshots->taken().empty()) {
    draw_picture(scene, snapshots->taken(), arguments.picture);
    fmt::print(stderr, "{} moments are drawn in {}\n", snapshots->taken().size(),
               arguments.picture);
  }
  if (dump) fmt::print(stderr, "{} instances are in {}\n", dump->instances(), arguments.dump);
  return interrupted ? interrupted_by_user : done;
}

}  // namespace

Verb add_simulate(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "simulate", "Simulate a scene with a solver in the loop; dump its LCPs");
  auto arguments = std::make_shared<SimulateArguments>();
  page->add_option("SCENE", arguments->scene, "NAME[:key=value,...] (see: lcpbench list scenes)")
      ->required();
  page->add_option("--solver", arguments->solver, "NAME[:key=value,...] that finds the forces")
      ->capture_default_str();
  add_loop_options(*page, arguments->loop);
  page->add_option("--dump", arguments->dump,
                   "New directory for the LCPs of every frame, a corpus of HDF5 files");
  page->add_option("--every", arguments->every, "Dump one frame in so many only")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_flag("--failed-only", arguments->failed_only,
                 "Dump only frames whose frictional LCP failed");
  page->add_option("--log", arguments->log, "File for a line of CSV per frame");
  page->add_option("--picture", arguments->picture,
                   "File (.svg) for drawings of the scene; script and data are kept beside it");
  page->add_option("--at", arguments->at,
                   "Times of the drawings, s. Default: the start, the middle and the end")
      ->delimiter(',');
  page->add_flag("--json", arguments->json, "Print the summary as JSON");
  page->footer(
      "Where the frictional LCP fails the frictionless answer acts, and where both fail none "
      "does.\n"
      "Example:\n"
      "  lcpbench simulate squat\n"
      "  lcpbench simulate squat:reduction=paper --solver lexicographic:delta=1e-8 --criterion "
      "paper\n"
      "  lcpbench simulate squat:start=previous --solver best-first:restart=cold\n"
      "  lcpbench simulate squat --picture squat.svg --at 0,0.25,0.5\n"
      "  lcpbench simulate tap-dance --dump runs/tap --log runs/tap.csv\n"
      "  lcpbench simulate hoist --dump runs/hoist --every 100");
  return {page, [arguments] { return simulate(*arguments); }};
}

}  // namespace lcp::cli
