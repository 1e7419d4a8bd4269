#pragma once

#include <string>
#include <vector>

#include "harness/present/scenes/camera.h"
#include "harness/present/scenes/polygons.h"
#include "harness/present/scenes/scene_bodies.h"
#include "harness/present/scenes/snapshots.h"
#include "harness/present/scenes/surfaces.h"
#include "problems/scenes/scene.h"

namespace lcp {

/// Moments of a scene side by side, seen from the same place at the same scale: bodies as
/// scene_bodies, of long rods and beams of the world what is near the links; the floor, where the
/// scene has one and the bodies stay above and near it, with a grid and what they hide of it from
/// above; contact points, filled where a force acts, and the forces as arrows. The part of a page
/// that gnuplot draws.
class ScenePanels {
 public:
  struct Layout {
    std::size_t most_in_a_row = 5;
    double height = 300;      ///< Of a panel without its title, pixels,
    double most_width = 400;  ///< unless it became wider than this.
    double least_width = 0;   ///< Pixels.
    std::string name = {};    ///< Before the times.
    bool letters = false;     ///< (a), (b), ... before the times.
    bool contacts = true;     ///< With contact points, forces and a legend.
    double azimuth = -52;   ///< Where the viewer stands, degrees: what faces x faces right and us.
    double elevation = 14;  ///< Of the viewer above the horizon, degrees.
  };

  /// Throws std::invalid_argument when there is no snapshot.
  ScenePanels(const NamedScene& scene, std::vector<Snapshot> snapshots, const Layout& layout);

  /// Of all panels with titles and legend, pixels.
  double width() const;
  double height() const;

  /// gnuplot's data sets, `sets_per_panel` for each panel.
  std::string data() const;
  static constexpr std::size_t sets_per_panel = 4;
  std::size_t sets() const { return sets_per_panel * snapshots_.size(); }

  struct Place {
    double top = 0;             ///< On the page, pixels.
    std::size_t first_set = 0;  ///< Of data() in the file.
  };

  /// Commands that draw the panels on a page of that size (pixels), in a multiplot; DATA is the
  /// file that holds data().
  std::string script(double page_width, double page_height, const Place& place = {0, 0}) const;

 private:
  struct Range {
    double low, high;
    double length() const { return high - low; }
  };

  void find_surfaces();
  void find_floor(bool in_the_scene);
  void find_scales();
  std::string floor(const Snapshot& snapshot) const;
  std::string grid() const;
  std::vector<Vector3d> corners(std::size_t body, const Snapshot& snapshot) const;  ///< World, m.
  unsigned colour(const Facet& facet) const;
  Polygon flat(const Facet& facet) const;
  void paint(std::string& data, const Facet& facet, const Polygon& polygon) const;
  void paint_whole(std::string& data, const Piece& piece) const;
  void paint_cut(std::string& data, const Piece& facets) const;
  std::string surfaces(const Snapshot& snapshot) const;
  std::string contacts(const Snapshot& snapshot) const;
  std::string legend(double page_width, double page_height, double top) const;
  std::size_t columns() const;
  std::size_t rows() const;
  double panel_width() const { return pixels_per_metre_ * x_.length(); }
  double panel_height() const { return pixels_per_metre_ * y_.length(); }

  std::string title_;
  std::vector<SceneBody> bodies_;
  std::vector<std::vector<Piece>> surfaces_;  ///< Of each body, in its shape's frame.
  std::vector<Snapshot> snapshots_;
  Layout layout_;
  Camera camera_;
  bool has_floor_ = false;
  double grid_ = 0;              ///< Its spacing, m.
  Range floor_x_{}, floor_y_{};  ///< m.
  Range x_{}, y_{};              ///< What a panel shows of the picture plane, m.
  double pixels_per_metre_ = 0;
  double largest_force_ = 0;      ///< N.
  double metres_per_newton_ = 0;  ///< 0 where no force acts.
};

}  // namespace lcp
