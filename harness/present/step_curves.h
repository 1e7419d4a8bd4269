#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/present/curve.h"
#include "harness/present/tag_placement.h"

namespace lcp {

/// A page of curves that grow in steps: one large panel with a legend beside it, smaller ones below, all
/// with the same axes.
struct StepCurve {
  int style =
      -1;  ///< Place in the legend, which decides colour and dashes; -1 is grey, in the large panel alone.
  Curve curve;
};

struct StepPanel {
  std::string title;
  std::vector<StepCurve> curves;
};

struct StepCurvePage {
  std::string title;
  std::string x_label, y_label;
  LogRange x;                       ///< Of all panels.
  std::vector<std::string> legend;  ///< From the top down.
  std::vector<StepPanel> panels;    ///< The large one first; not empty.
  std::string caption;              ///< Below; broken into lines.
};

/// Writes `svg` with its script and data beside it; throws as draw_with_gnuplot does.
void draw_step_curves(const std::filesystem::path& svg, const StepCurvePage& page);

/// The corners of a curve's steps from one end of `x` to the other, no more than `columns` of them
/// apart: enough for a picture. Shares, not counts.
std::vector<Pixels> step_corners(const Curve& curve, const LogRange& x, int columns);

}  // namespace lcp
