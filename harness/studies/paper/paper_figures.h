#pragma once

#include <atomic>
#include <filesystem>
#include <vector>

#include "harness/studies/loop/in_the_loop.h"

namespace lcp {

/// Fig. 2 or 3 of the paper, as `figure` says: simulates the scene with the solver in the loop and
/// writes figN.{csv,svg,gp,dat} into `directory`, which is made where it is missing.
///
/// 2: the vertical force of each foot, and their sum against weight + m a (see write_force_figure);
/// the paper's scene is `squat`. The curve that the paper measured is not public.
/// 3: eight moments of a dance, its turn over time and when each foot stands and strikes (see
/// write_dance_figure), with the image of the bodies (.png); the paper's scene is `tap-dance`.
///
/// Returns the run. Interrupted, it has `broken` set and nothing is written; what ended by itself
/// before its time is drawn as far as it came. Throws std::invalid_argument unless the scene has two
/// handles, left foot first, and UnwritableOutput, before the simulation where that can be known.
LoopRun write_figure(int figure, const std::filesystem::path& directory, const NamedScene& scene,
                     const NamedSolver& solver, const Acceptance& acceptance, const FrameLook& look,
                     const std::atomic<bool>& interrupted);

/// A scene with the moments that a figure shows of it.
struct FilmedScene {
  NamedScene scene;
  std::vector<double> times;  ///< s.
  double azimuth = 0;         ///< Where the viewer stands, degrees from x towards y.
  double elevation = 14;      ///< Of the viewer above the horizon, degrees.
  double height = 240;        ///< Of its pictures, pixels.
};

/// What the paper's Fig. 4 shows, from the top row.
std::vector<FilmedScene> figure_4_scenes();

/// Fig. 4: simulates each scene with the solver in the loop until its last moment, and writes
/// fig4.{csv,svg,gp,dat,png} with a row of pictures per scene, without contacts; the data (.csv) are the
/// link frames' origins at those moments.
///
/// Returns the runs, up to the interrupted one: then nothing is written. A scene that broke has the
/// moments before. Throws std::invalid_argument when there is no scene or a moment is not within
/// its duration, and UnwritableOutput, before the simulations where that can be known.
std::vector<LoopRun> write_figure_4(const std::filesystem::path& directory,
                                    std::vector<FilmedScene> filmed, const NamedSolver& solver,
                                    const Acceptance& acceptance, const FrameLook& look,
                                    const std::atomic<bool>& interrupted);

}  // namespace lcp
