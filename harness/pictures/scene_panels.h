#pragma once

#include <string>
#include <vector>

#include "harness/pictures/camera.h"
#include "harness/pictures/scene_boxes.h"
#include "harness/pictures/snapshots.h"
#include "problems/scenes/scene.h"

namespace lcp {

/// Moments of a scene side by side, seen from the same place at the same scale: links as shaded
/// boxes, those that may touch something in another colour; links without a box as bones; the floor
/// z = 0, where the bodies stay above it, with a grid and what they hide of it from above; contact
/// points, filled where a force acts, and the forces as arrows. The part of a page that gnuplot
/// draws.
class ScenePanels {
 public:
  struct Layout {
    std::size_t most_in_a_row = 5;
    double height = 300;      ///< Of a panel without its title, pixels,
    double most_width = 400;  ///< unless it became wider than this.
    bool letters = false;     ///< (a), (b), ... before the times.
    double azimuth = -52;  ///< Where the viewer stands, degrees: what faces x faces right and us.
  };

  /// Throws std::invalid_argument when there is no snapshot.
  ScenePanels(const NamedScene& scene, std::vector<Snapshot> snapshots, const Layout& layout);

  /// Of all panels with titles and legend, pixels.
  double width() const;
  double height() const;

  /// gnuplot's data sets, `sets_per_panel` for each panel.
  std::string data() const;
  static constexpr std::size_t sets_per_panel = 4;

  /// Commands that draw the panels at the top of a page of that size (pixels), in a multiplot; DATA
  /// is the file that begins with data().
  std::string script(double page_width, double page_height) const;

 private:
  struct Range {
    double low, high;
    double length() const { return high - low; }
  };

  void find_floor();
  void find_scales();
  std::string floor(const Snapshot& snapshot) const;
  std::string grid() const;
  std::string surfaces(const Snapshot& snapshot) const;
  std::string contacts(const Snapshot& snapshot) const;
  std::string legend(double page_width, double page_height) const;
  std::size_t columns() const;
  std::size_t rows() const;
  double panel_width() const { return pixels_per_metre_ * x_.length(); }
  double panel_height() const { return pixels_per_metre_ * y_.length(); }

  std::string title_;
  std::vector<SceneBox> boxes_;
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
