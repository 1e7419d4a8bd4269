#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/studies/paper/columns/corpus_columns.h"
#include "harness/studies/paper/columns/loop_columns.h"

namespace lcp {

/// A row of the paper's tables, or one of ours: named once for all that compute and print it.
struct PaperQuantity {
  std::string key;                ///< In JSON and CSV, and in paper/published.json.
  std::string label;              ///< For a reader, with the unit.
  std::string unit = {};          ///< Of the value in JSON and CSV; empty for plain numbers.
  double scale = 1;               ///< What a reader sees is the value times this.
  const char* number = "{:.0f}";  ///< Format for a reader.
  std::function<std::optional<double>(const LoopColumn&)> in_loop;
  std::function<std::optional<double>(const CorpusColumn&)> on_corpus;
  bool counted = false;  ///< A whole number.
  bool judged = false;   ///< Depends on the criterion of success.
};

/// All, in the order of JSON.
const std::vector<PaperQuantity>& paper_quantities();

/// Throws std::invalid_argument on an unknown key.
const PaperQuantity& paper_quantity(const std::string& key);

/// A value as a reader sees it; `fell` is yes or no.
std::string printed(const PaperQuantity& quantity, double value);

}  // namespace lcp
