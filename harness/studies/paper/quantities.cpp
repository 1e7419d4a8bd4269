#include "harness/studies/paper/quantities.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace lcp {

namespace {

constexpr const char *whole_number = "{:.0f}", *truth_value = "1 if so";
constexpr bool by_criterion = true;

}  // namespace

Cell PaperQuantity::stated(const std::optional<double>& value) const {
  return value && number == whole_number ? Cell(static_cast<Index>(*value)) : cell_of(value);
}

Cell PaperQuantity::for_reader(const Cell& value) const {
  return unit == truth_value && !value.is_null() ? Cell(value != 0) : value;
}

const std::vector<PaperQuantity>& paper_quantities() {
  static const std::vector<PaperQuantity> all = {
      {{"duration", "duration (s)", "", "{:g}"}, "s"},
      {{"delta", "threshold delta", "", "{:.0e}"}, ""},
      {{"contacts", "contacts", "", "{:.2f}"}, ""},
      {{"active", "active", "", "{:.2f}"}, ""},
      {{"total_frames", "total frames", "", whole_number}, "frames"},
      {{"success", "success", "", whole_number}, "frames", by_criterion},
      {{"failure", "failure", "", whole_number}, "frames", by_criterion},
      {{"no_solution", "  no solution", "", whole_number}, "frames", by_criterion},
      {{"cycle", "  cycle", "", whole_number}, "frames", by_criterion},
      {{"error", "  error", "", whole_number}, "frames", by_criterion},
      {{"unsupported", "unsupported", "", whole_number}, "frames", by_criterion},
      {{"lcp_time_ms", "LCP solve time (ms)", "", "{:.3f}"}, "ms"},
      {{"simulation_time_ms", "simulation time (ms)", "", "{:.3f}"}, "ms"},
      {{"total_pivots", "total pivots", "", whole_number}, "pivots"},
      {{"frictionless_failures", "frictionless failed", "", whole_number}, "frames", by_criterion},
      {{"both_failures", "both failed", "", whole_number}, "frames", by_criterion},
      {{"fell", "fell", "", whole_number}, truth_value},
      {{"tilt_max", "tilt at most (deg)", "", "{:.1f}", 180 / M_PI}, "rad"},
      {{"depth_max", "penetration (mm)", "", "{:.3g}", 1e3}, "m"},
      {{"energy_excess", "energy excess (%)", "", "{:.2g}", 100}, ""},
      {{"work", "work of pulls (J)", "", "{:.3g}"}, "J"},
      {{"gap_end", "loops open (mm)", "", "{:.1e}", 1e3}, "m"},
      {{"force_mismatch", "force mismatch (%)", "", "{:.2g}", 100}, ""},
      {{"residual_median", "residual, median", "", "{:.1e}"}, "", by_criterion},
      {{"residual_max", "residual, largest", "", "{:.1e}"}, "", by_criterion},
      {{"nodes", "nodes, mean", "", "{:.1f}"}, ""},
      {{"pivots", "pivots, mean", "", "{:.1f}"}, ""},
      {{"wrong", "wrong", "", whole_number}, "frames", by_criterion},
      {{"unclaimed", "unclaimed", "", whole_number}, "frames", by_criterion},
      {{"not_run", "not run", "", whole_number}, "frames"},
      {{"trivial", "trivial, of success", "", whole_number}, "frames", by_criterion},
      {{"time_median_ms", "median time (ms)", "", "{:.3f}"}, "ms"},
  };
  return all;
}

const PaperQuantity& paper_quantity(const std::string& key) {
  for (const PaperQuantity& quantity : paper_quantities())
    if (quantity.key == key) return quantity;
  throw std::invalid_argument(fmt::format("no quantity '{}' in the paper's tables", key));
}

nlohmann::json values_of(const LoopColumn& column) {
  const LoopSummary& summary = column.summary;
  nlohmann::json values = nlohmann::json::object();
  if (summary.steps > 0) {
    values = figures_of(summary);
    for (nlohmann::json& value : values)
      if (value.is_number() && std::isnan(value.get<double>())) value = nullptr;
    if (summary.gap_max == 0) values["gap_end"] = nullptr;  // no loops
  }
  const auto frames = static_cast<double>(summary.total_frames);
  for (const auto& [key, total] : {std::pair("nodes", summary.nodes), {"pivots", summary.pivots}})
    values[key] =
        frames == 0 ? nlohmann::json() : nlohmann::json(static_cast<double>(total) / frames);
  values["fell"] = Index{column.fell()};
  return values;
}

}  // namespace lcp
