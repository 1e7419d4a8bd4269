#pragma once

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lcp {

/// A chart as data: panels with axes and series of marks, a legend, a title and a caption. Whoever draws
/// it needs nothing else: draw_figure here, the page of a report from its JSON.

/// 0xRRGGBB.
using Colour = unsigned;

/// How a solver, or any other thing with a name of its own, looks in every chart.
struct Look {
  Colour colour = 0;
  int marker = 0;  ///< Place in the list of markers: circle, square, triangle, diamond, ...
  int dash = 0;    ///< Place in the list of dashes; 0 is solid.
};

inline constexpr Colour mid_grey = 0xbbbbbb, dark_grey = 0x555555, pale_grey = 0xe6e6e6,
                        black = 0x222222;

/// The k-th look of a chart whose entries are no solvers: the colours of Okabe and Ito in turn.
Look look_at(std::size_t k);

/// The look of a row of the registry of solvers: the same in every chart of the program and in the page.
/// Rows that are not in the registry (of older runs) get the looks after its last.
Look look_of_solver(const std::string& row);

/// The looks of settings of these rows in one chart: a row's look, and where another one of that colour
/// has its dashes, dashes that none has, as long as there are any.
std::vector<Look> looks_of_settings(const std::vector<std::string>& rows);

struct Tick {
  double at = 0;
  std::string label;
};

struct Axis {
  enum class Scale { linear, log };
  std::string label = {};
  double low = 0, high = 1;  ///< low > high runs the other way.
  Scale scale = Scale::linear;
  std::vector<Tick> ticks = {};  ///< Empty: at round numbers, or at powers of ten.
  bool grid = true;              ///< A faint line at every tick.
};

/// One mark of a series, in the units of the panel's axes. What is NaN is not drawn.
struct Mark {
  double x = NAN, y = NAN;
  double x_low = NAN, x_high = NAN;  ///< Ends of a bar across, or sides of a box.
  double y_low = NAN, y_high = NAN;  ///< Ends of a bar upwards, or bottom and top of a box.
  std::string text = {};             ///< Of `text`; elsewhere a note for whoever hovers over it.
  Look look = {};
  bool filled = true;  ///< The marker.
};

struct Series {
  enum class Kind {
    line,    ///< Through the marks in turn; one without x or y breaks it. The first mark's look.
    points,  ///< A marker each, with bars where their ends are given.
    boxes,   ///< Filled boxes.
    area,    ///< Polygons, filled without outline, parted by a mark without x.
    text,    ///< Each mark's text at x, y, in its colour.
  };
  enum class Align { left, centre, right };
  Kind kind = Kind::line;
  std::vector<Mark> marks = {};
  double size = 1;            ///< Width of lines, relative size of markers; of text in points (11).
  double opacity = 1;         ///< Of boxes and areas.
  Align align = Align::left;  ///< Of text.
};

/// A rectangle on a page, pixels from its upper left corner.
struct PageArea {
  double left = 0, width = 0, top = 0, height = 0;
};

struct Panel {
  PageArea area = {};  ///< Of the plot proper: axes and titles stand outside.
  std::string title = {};
  Axis x = {}, y = {};
  bool axes = true;                 ///< False: nothing but marks, as in a list beside a chart.
  std::vector<Series> series = {};  ///< Later ones on top.
};

/// An entry of the legend: a stroke, a marker or both.
struct LegendEntry {
  std::string name;
  Look look = {};
  bool line = false, point = true, filled = true;
};

struct Figure {
  std::string title = {};
  std::string caption = {};           ///< Below; broken into lines.
  double width = 1000, height = 600;  ///< Pixels, without the lines of the caption.
  std::vector<Panel> panels = {};
  std::vector<LegendEntry> legend = {};
  PageArea legend_area =
      {};  ///< Entries run from left to right, or down where it is narrow. Height 0: no legend.
};

/// Draws with gnuplot. Writes `svg` with the script and the data it is made from beside it (.gp, .dat), so
/// that it can be restyled: `gnuplot F.gp > F.svg`. Throws UnwritableOutput where they cannot be
/// written or gnuplot is missing or fails; `svg` is then left as it was.
void draw_figure(const std::filesystem::path& svg, const Figure& figure);

/// The figure as the page draws it.
nlohmann::ordered_json to_json(const Figure& figure);
nlohmann::ordered_json to_json(const Look& look);  ///< {colour: "#rrggbb", marker, dash}.

/// Areas of `count` plots of one size, `abreast` in a row, in reading order; `left_of` and `above` pixels
/// are free before each, `below` under each.
struct PanelGrid {
  std::size_t abreast = 4;
  double width = 230, height = 190;
  double left_of = 84, above = 44, below = 66;
  double top = 0;  ///< Of the page, left free.

  PageArea area(std::size_t place) const;
  double page_width(std::size_t count) const;
  double page_height(std::size_t count) const;
};

/// Ticks at 1, 2, 5 x 10^k of a linear axis from 0 or of a short logarithmic one; at most `most`.
std::vector<Tick> round_ticks(double low, double high, std::size_t most, Axis::Scale scale);

}  // namespace lcp
