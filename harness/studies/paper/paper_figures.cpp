#include "harness/studies/paper/paper_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "harness/present/gnuplot_page.h"
#include "harness/present/scenes/scene_picture.h"
#include "harness/studies/paper/dance_figure.h"
#include "harness/studies/paper/force_figure.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

constexpr Index kMoments = 8;
constexpr double kPanelWidth = 300;  // of figure 4, pixels

/// Shows a scene at `moments`, over its duration.
FilmedScene filmed(const std::string& scene, const std::vector<double>& moments, double elevation,
                   double height) {
  FilmedScene film{make_scene(scene), {}, -52, elevation, height};
  for (const double share : moments) film.times.push_back(share * film.scene.setup.duration);
  return film;
}

/// Shows frames to the snapshots first.
FrameLook looking_too(Snapshots& snapshots, const FrameLook& look) {
  return [&](const Simulation& simulation, const Frame& frame, const FrameRecord& record) {
    snapshots.look(frame);
    if (look) look(simulation, frame, record);
  };
}

/// A line per moment and link.
std::string moments_csv(const NamedScene& scene, const std::vector<Snapshot>& moments) {
  const std::vector<Link>& links = scene.setup.system.model.links();
  std::string csv;
  for (const Snapshot& moment : moments)
    for (std::size_t i = 0; i < moment.links.size(); ++i) {
      const Vector3d& p = moment.links[i].p;
      csv += fmt::format("{},{:.9g},{},{:.9g},{:.9g},{:.9g}\n", scene.spelling, moment.time,
                         links[i].name, p.x(), p.y(), p.z());
    }
  return csv;
}

}  // namespace

LoopRun write_figure(int figure, const std::filesystem::path& directory, const NamedScene& scene,
                     const NamedSolver& solver, const Acceptance& acceptance, const FrameLook& look,
                     const std::atomic<bool>& interrupted) {
  const SceneSetup& setup = scene.setup;
  if (setup.system.handles.size() != 2)
    throw std::invalid_argument(fmt::format(
        "{}: has {} links that may touch something, expected a scene with two: the left "
        "and the right foot",
        scene.spelling, setup.system.handles.size()));
  make_directories(directory);
  Snapshots snapshots(evenly_spread(setup.duration, kMoments), setup.stepping.dt, setup.duration);
  LoopRun run =
      run_in_the_loop(scene, solver, acceptance, looking_too(snapshots, look), interrupted);
  if (interrupted && !run.broken.empty()) return run;
  if (figure == 2)
    write_force_figure(run, setup.system.model.mass(), setup.system.gravity,
                       directory / "fig2.svg");
  else
    write_dance_figure(run, scene, snapshots.taken(), directory / "fig3.svg");
  return run;
}

std::vector<FilmedScene> figure_4_scenes() {
  return {filmed("hoist", {0, 0.5, 1}, 14, 240), filmed("ring", {0, 0.5, 1}, 14, 420),
          filmed("net", {0, 0.1, 1}, 30, 240)};
}

std::vector<LoopRun> write_figure_4(const std::filesystem::path& directory,
                                    std::vector<FilmedScene> filmed, const NamedSolver& solver,
                                    const Acceptance& acceptance, const FrameLook& look,
                                    const std::atomic<bool>& interrupted) {
  if (filmed.empty()) throw std::invalid_argument("figure 4: no scene to show");
  std::vector<Snapshots> snapshots;
  for (FilmedScene& film : filmed) {
    SceneSetup& setup = film.scene.setup;
    snapshots.emplace_back(film.times, setup.stepping.dt, setup.duration);
    // One step more, so that the last moment is a frame of its own.
    const double last = film.times.empty() ? 0 : std::ranges::max(film.times);
    setup.duration = std::min(setup.duration, last + setup.stepping.dt);
  }
  make_directories(directory);
  std::vector<LoopRun> runs;
  std::vector<SceneMoments> rows;
  std::string csv = "scene,time_s,link,x_m,y_m,z_m\n";
  for (std::size_t i = 0; i < filmed.size(); ++i) {
    const FilmedScene& film = filmed[i];
    runs.push_back(run_in_the_loop(film.scene, solver, acceptance, looking_too(snapshots[i], look),
                                   interrupted));
    if (interrupted && !runs.back().broken.empty()) return runs;
    csv += moments_csv(film.scene, snapshots[i].taken());
    rows.push_back({.scene = &film.scene,
                    .snapshots = snapshots[i].taken(),
                    .height = film.height,
                    .most_width = kPanelWidth,
                    .least_width = kPanelWidth,
                    .name = film.scene.info.name + ", ",
                    .contacts = false,
                    .azimuth = film.azimuth,
                    .elevation = film.elevation});
  }
  draw_with_gnuplot(
      directory / "fig4.svg",
      scene_page(fmt::format("Simulations with {} in the loop.", solver.spelling), rows));
  replace_file(directory / "fig4.csv", csv);
  return runs;
}

}  // namespace lcp
