#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/present/scenes/snapshots.h"
#include "harness/studies/loop/in_the_loop.h"

namespace lcp {

/// A time during which a handle carries vertical force, but for gaps of less than 10 ms.
struct Stance {
  std::size_t handle = 0;
  double begin = 0, end = 0;  ///< s.
  bool struck = false;        ///< Begins after at least 10 ms without force: the handle strikes.
};

/// Of all handles, by handle, then time.
std::vector<Stance> stances(const LoopRun& run);

/// Time (s), turn of the first link since the start (degrees), vertical force of each handle (N) and
/// whether it strikes, a line per frame.
std::string dance_csv(const LoopRun& run);

/// Draws `snapshots` as ScenePanels, below them the turn (yaw) over time with the moments of the
/// pictures, and when each handle stands and strikes. Writes `svg` with .csv, .gp and .dat beside it.
/// Throws as draw_picture does.
void write_dance_figure(const LoopRun& run, const NamedScene& scene,
                        const std::vector<Snapshot>& snapshots, const std::filesystem::path& svg);

}  // namespace lcp
