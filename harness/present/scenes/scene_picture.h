#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/present/gnuplot_page.h"
#include "harness/present/scenes/snapshots.h"
#include "problems/scenes/scene.h"

namespace lcp {

/// Moments of a scene side by side, seen from the same place at the same scale: bodies as
/// scene_bodies, of long rods and beams of the world what is near the links; the floor, where the
/// scene has one and the bodies stay above and near it, with a grid and what they hide of it from
/// above; contact points, filled where a force acts, and the forces as arrows.
struct SceneMoments {
  const NamedScene* scene = nullptr;
  std::vector<Snapshot> snapshots = {};
  std::size_t most_in_a_row = 5;
  double height = 300;      ///< Of a panel without its title, pixels.
  double most_width = 400;  ///< Of a panel, pixels; it is less high where it would be wider.
  double least_width = 0;   ///< Pixels.
  std::string name = {};    ///< Before the times.
  bool letters = false;     ///< (a), (b), ... before the times.
  bool contacts = true;     ///< With contact points, forces and a legend.
  double azimuth = -52;     ///< Where the viewer stands, degrees: what faces x faces right and us.
  double elevation = 14;    ///< Of the viewer above the horizon, degrees.
};

/// Scenes one below another. Its data sets are scene_page_sets: floors (x y), their grids (x y),
/// contact points (x y, force as arrow dx dy, force in N), all in pixels of the page; its image shows
/// the bodies. The lowest `below` pixels of the page stay empty, for further commands.
///
/// Throws std::invalid_argument where a scene has no snapshot.
GnuplotPage scene_page(const std::string& title, const std::vector<SceneMoments>& rows,
                       double below = 0);
inline constexpr std::size_t scene_page_sets = 3;

/// Draws the moments with gnuplot into `svg`, and keeps script, data and the image of the bodies
/// beside it (.gp, .dat, .png) to restyle: `gnuplot F.gp > F.svg`. Throws UnwritableOutput where they
/// cannot be written or gnuplot is missing or fails (`svg` is then left as it was), and
/// std::invalid_argument when there is no snapshot.
void draw_picture(const NamedScene& scene, const std::vector<Snapshot>& snapshots,
                  const std::filesystem::path& svg);

}  // namespace lcp
