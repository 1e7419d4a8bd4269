#pragma once

#include <string>
#include <vector>

#include "harness/present/figure.h"

namespace lcp {

struct DotSeries {
  std::size_t entry = 0;       ///< Place in the legend, which decides its look.
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
  std::vector<LegendEntry> legend;
  std::vector<DotPanel> panels;
  std::string caption;
};

/// The panels from left to right with the names of their rows, which stand once where neighbours have
/// the same. Throws std::invalid_argument where a series is not as long as its panel's rows.
Figure figure_of(const DotPage& page);

}  // namespace lcp
