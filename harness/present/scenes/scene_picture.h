#pragma once

#include <filesystem>
#include <vector>

#include "harness/present/scenes/snapshots.h"
#include "problems/scenes/scene.h"

namespace lcp {

/// Draws the moments as ScenePanels with gnuplot into `svg`, and keeps script and data beside it
/// (.gp, .dat) to restyle: `gnuplot F.gp > F.svg`. Throws UnwritableOutput where they cannot be
/// written or gnuplot is missing or fails (`svg` is then left as it was), and std::invalid_argument
/// when there is no snapshot.
void draw_picture(const NamedScene& scene, const std::vector<Snapshot>& snapshots,
                  const std::filesystem::path& svg);

}  // namespace lcp
