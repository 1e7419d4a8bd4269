#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/present/columns.h"
#include "harness/studies/paper/columns/loop_columns.h"

namespace lcp {

/// A row of the paper's tables, or one of ours: a key in JSON, CSV and paper/published.json, a heading
/// with the unit that a reader sees, named once for all that print it.
struct PaperQuantity : ColumnHead {
  std::string unit = {};  ///< Of the value in JSON and CSV; empty for plain numbers.
  bool judged = false;    ///< Depends on the criterion of success.

  /// A published value as JSON holds it: what is counted is a whole number.
  Cell stated(const std::optional<double>& value) const;
  /// A value of JSON as a reader gets it: yes or no where it is the truth of something.
  Cell for_reader(const Cell& value) const;
};

/// All, in the order of JSON.
const std::vector<PaperQuantity>& paper_quantities();

/// Throws std::invalid_argument on an unknown key.
const PaperQuantity& paper_quantity(const std::string& key);

/// The values of a simulation by the keys of the quantities, null or missing where there is none: all but
/// `fell` are for one that crashed before its first frame.
nlohmann::json values_of(const LoopColumn& column);

}  // namespace lcp
