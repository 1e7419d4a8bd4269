#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lcp {

struct DotSeries {
  std::size_t style = 0;       ///< Place in the legend, which decides colour and marker.
  std::vector<double> values;  ///< As the panel's rows; NaN for none.
};

/// Values of rows along an axis, a mark per row and series. The axis begins at 0, but is logarithmic where
/// all values are positive and the largest is more than 30 times the least.
struct DotPanel {
  std::string title;
  std::vector<std::string> rows;  ///< From the top down.
  std::vector<DotSeries> series;
};

/// A picture of a table: a panel per quantity, each with its own axis.
struct DotPage {
  std::string title;
  std::vector<std::string> legend;
  std::vector<DotPanel> panels;
  std::string caption;  ///< Below; one line.
};

/// Writes `svg` with its script and data beside it; throws as draw_with_gnuplot does, and
/// std::invalid_argument where a series is not as long as its panel's rows.
void draw_dots(const std::filesystem::path& svg, const DotPage& page);

}  // namespace lcp
