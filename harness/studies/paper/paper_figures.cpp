#include "harness/studies/paper/paper_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "harness/present/gnuplot_page.h"
#include "harness/studies/paper/dance_figure.h"
#include "harness/studies/paper/force_figure.h"
#include "harness/present/scenes/scene_panels.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

constexpr Index kMoments = 8;
constexpr double kPanelWidth = 300, kBelow = 10;  // of figure 4, pixels

constexpr struct {
  const char* scene;
  double moments[3];          // over the scene's duration
  double azimuth, elevation;  // degrees
  double height;              // pixels
} kFilms[] = {
    {"hoist", {0, 0.5, 1}, -52, 14, 240},
    {"ring", {0, 0.5, 1}, -52, 14, 420},
    {"net", {0, 0.1, 1}, -52, 30, 240},
};

void prepare(const std::filesystem::path& directory, const NamedScene& scene) {
  const std::size_t handles = scene.setup.system.handles.size();
  if (handles != 2)
    throw std::invalid_argument(fmt::format(
        "{}: has {} links that may touch something, expected a scene with two: the left "
        "and the right foot",
        scene.spelling, handles));
  make_directories(directory);
}

/// Shows frames to the snapshots first.
FrameLook looking_too(Snapshots& snapshots, const FrameLook& look) {
  return [&](const Simulation& simulation, const Frame& frame, const FrameRecord& record) {
    snapshots.look(frame);
    if (look) look(simulation, frame, record);
  };
}

/// A row of panels per scene.
void draw_rows(const std::vector<ScenePanels>& rows, const std::string& title,
               const std::filesystem::path& svg) {
  GnuplotPage page;
  page.title = title;
  for (const ScenePanels& row : rows) {
    page.width = std::max(page.width, row.width());
    page.height += row.height() + kBelow;
  }
  ScenePanels::Place place;
  for (const ScenePanels& row : rows) {
    page.commands += row.script(page.width, page.height, place);
    page.data += row.data();
    place.top += row.height() + kBelow;
    place.first_set += row.sets();
  }
  draw_with_gnuplot(svg, page);
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
  LoopRun run =
      run_in_the_loop(scene, solver, acceptance, looking_too(snapshots, look), interrupted);
  if (!(interrupted && !run.broken.empty()))
    write_dance_figure(run, scene, snapshots.taken(), directory / "fig3.svg");
  return run;
}

std::vector<FilmedScene> figure_4_scenes() {
  std::vector<FilmedScene> filmed;
  for (const auto& film : kFilms) {
    filmed.push_back({.scene = make_scene(film.scene),
                      .times = {},
                      .azimuth = film.azimuth,
                      .elevation = film.elevation,
                      .height = film.height});
    for (const double share : film.moments)
      filmed.back().times.push_back(share * filmed.back().scene.setup.duration);
  }
  return filmed;
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
  std::vector<ScenePanels> rows;
  std::string csv = "scene,time_s,link,x_m,y_m,z_m\n";
  for (std::size_t i = 0; i < filmed.size(); ++i) {
    const FilmedScene& film = filmed[i];
    runs.push_back(run_in_the_loop(film.scene, solver, acceptance, looking_too(snapshots[i], look),
                                   interrupted));
    if (interrupted && !runs.back().broken.empty()) return runs;
    csv += moments_csv(film.scene, snapshots[i].taken());
    rows.emplace_back(film.scene, snapshots[i].taken(),
                      ScenePanels::Layout{.height = film.height,
                                          .most_width = kPanelWidth,
                                          .least_width = kPanelWidth,
                                          .name = film.scene.info.name + ", ",
                                          .contacts = false,
                                          .azimuth = film.azimuth,
                                          .elevation = film.elevation});
  }
  draw_rows(rows, fmt::format("Simulations with {} in the loop.", solver.spelling),
            directory / "fig4.svg");
  replace_file(directory / "fig4.csv", csv);
  return runs;
}

}  // namespace lcp
