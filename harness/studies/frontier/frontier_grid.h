#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problems/instance.h"

namespace lcp {

/// A knob of a family and the values that one axis of a frontier gives it, ascending.
struct KnobAxis {
  std::string knob;
  std::vector<double> values;
  bool geometric = false;  ///< Interpolated and drawn by log10 of the value.

  std::size_t size() const { return values.size(); }
  /// Position on the axis: the value, or its log10.
  double position(std::size_t i) const;
  /// The value at a position.
  double value_at(double position) const;
};

/// Reads `KNOB=V,V,...` or `KNOB=FROM..TO/N`, N values from FROM to TO rounded to three digits;
/// with `,log` at its end the axis is geometric. Throws std::invalid_argument naming `option` and
/// what is expected: two values at least, finite, ascending, positive where geometric.
KnobAxis parse_axis(const std::string& text, const std::string& option);

/// A value for a reader: three digits, 31.6, 1000, 1e-05.
std::string three_digits(double value);

/// As parse_axis reads it: `mu=0.1,0.3,1,log`.
std::string to_string(const KnobAxis& axis);

/// The plane of two knobs of a family.
struct FrontierGrid {
  std::string family;  ///< `name:key=value,...`, without the two knobs.
  KnobAxis x, y;
};

/// `family` with the knobs of cell (column, row).
std::string cell_spelling(const FrontierGrid& grid, std::size_t column, std::size_t row);

/// Draw number `draw` of a cell: the first instance of the family at seed 1000 `seed` + `draw`, so
/// that draws are independent in families whose instances follow one another too, and all cells use
/// the same seeds. It is called FAMILY:key=value,.../SEED, with the family in full spelling, and
/// `lcpbench generate FAMILY:key=value,... --count 1 --seed SEED` makes it again. Throws
/// std::invalid_argument as generate() does, and for draws beyond most_draws.
Instance draw_of_cell(const FrontierGrid& grid, std::size_t column, std::size_t row,
                      std::uint64_t seed, Index draw);
inline constexpr Index most_draws = 1000;

/// Number of the draw that an instance's name tells; empty where it is no name of draw_of_cell.
std::optional<Index> draw_number(const std::string& instance);

/// Throws std::invalid_argument, with the list of what is allowed, unless the family has both
/// knobs, they differ and are not set in its spelling.
void check_knobs(const FrontierGrid& grid);

/// What the family says of a knob it has: one line, with unit or scale.
std::string knob_meaning(const FrontierGrid& grid, const std::string& knob);

}  // namespace lcp
