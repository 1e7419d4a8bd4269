#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "harness/cli/interrupt.h"
#include "harness/cli/loop_options.h"
#include "harness/cli/page.h"
#include "harness/cli/progress.h"
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
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, times.emplace_back());
    if (error != std::errc() || stop != end)
      throw std::invalid_argument(
          fmt::format("--at {}: expected numbers of seconds with commas between", text));
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
  const auto steps = static_cast<std::size_t>(steps_to_make(scene));
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
  fmt::print("{}", arguments.json ? figures_of(summary).dump(1) + "\n" : render(summary));
  if (snapshots && !snapshots->taken().empty()) {
    draw_picture(scene, snapshots->taken(), arguments.picture);
    fmt::print(stderr, "{} moments are drawn in {}\n", snapshots->taken().size(),
               arguments.picture);
  }
  if (dump) fmt::print(stderr, "{} instances are in {}\n", dump->instances(), arguments.dump);
  return interrupted ? interrupted_by_user : done;
}

void simulate_options(CLI::App& page, SimulateArguments& arguments) {
  add(page, "SCENE", arguments.scene, "NAME[:key=value,...] (see: lcpbench list scenes)")
      ->required();
  add_with_default(page, "--solver", arguments.solver,
                   "NAME[:key=value,...] that finds the forces");
  add_loop_options(page, arguments.loop);
  add(page, "--dump", arguments.dump,
      "New directory for the LCPs of every frame, a corpus of HDF5 files");
  add_with_default(page, "--every", arguments.every, "Dump one frame in so many only",
                   CLI::PositiveNumber);
  page.add_flag("--failed-only", arguments.failed_only,
                "Dump only frames whose frictional LCP failed");
  add(page, "--log", arguments.log, "File for a line of CSV per frame");
  add(page, "--picture", arguments.picture,
      "File (.svg) for drawings of the scene; script and data are kept beside it");
  page.add_option("--at", arguments.at,
                  "Times of the drawings, s. Default: the start, the middle and the end")
      ->delimiter(',');
  page.add_flag("--json", arguments.json, "Print the summary as JSON");
}

}  // namespace

Verb add_simulate(CLI::App& program) {
  return make_verb<SimulateArguments>(
      program, "simulate", "Simulate a scene with a solver in the loop; dump its LCPs",
      simulate_options, simulate,
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
}

}  // namespace lcp::cli
