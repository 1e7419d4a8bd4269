#include "harness/pictures/paper_figures.h"

#include <fmt/format.h>

#include <stdexcept>

#include "harness/pictures/dance_figure.h"
#include "harness/pictures/force_figure.h"
#include "problems/io/errors.h"

namespace lcp {

namespace {

constexpr Index kMoments = 8;

void prepare(const std::filesystem::path& directory, const NamedScene& scene) {
  const std::size_t handles = scene.setup.system.handles.size();
  if (handles != 2)
    throw std::invalid_argument(fmt::format(
        "{}: has {} links that may touch something, expected a scene with two: the left "
        "and the right foot",
        scene.spelling, handles));
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    throw UnwritableOutput(
        fmt::format("{}: cannot create: {}", directory.string(), error.message()));
}

}  // namespace

LoopRun write_figure_2(const std::filesystem::path& directory, const NamedScene& scene,
                       const NamedSolver& solver, const Acceptance& acceptance,
                       const FrameLook& look, const std::atomic<bool>& interrupted) {
  prepare(directory, scene);
  LoopRun run = run_in_the_loop(scene, solver, acceptance, look, interrupted);
  if (!(interrupted && !run.broken.empty()))
    write_force_figure(run, scene.setup.system.model.mass(), scene.setup.system.gravity,
                       directory / "fig2.svg");
  return run;
}

LoopRun write_figure_3(const std::filesystem::path& directory, const NamedScene& scene,
                       const NamedSolver& solver, const Acceptance& acceptance,
                       const FrameLook& look, const std::atomic<bool>& interrupted) {
  prepare(directory, scene);
  Snapshots snapshots(evenly_spread(scene.setup.duration, kMoments), scene.setup.stepping.dt,
                      scene.setup.duration);
  const FrameLook look_twice = [&](const Simulation& simulation, const Frame& frame,
                                   const FrameRecord& record) {
    snapshots.look(frame);
    if (look) look(simulation, frame, record);
  };
  LoopRun run = run_in_the_loop(scene, solver, acceptance, look_twice, interrupted);
  if (!(interrupted && !run.broken.empty()))
    write_dance_figure(run, scene, snapshots.taken(), directory / "fig3.svg");
  return run;
}

}  // namespace lcp
