#include "harness/studies/paper/quantities.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace lcp {

namespace {

constexpr const char *whole = "{:.0f}", *truth = "1 if so";
constexpr bool by_criterion = true;

}  // namespace

PaperQuantity::PaperQuantity(std::string key_, std::string heading_, std::string unit_,
                             std::string number_, double scale_, bool judged_)
    : unit(std::move(unit_)), judged(judged_) {
  key = std::move(key_);
  heading = std::move(heading_);
  number = std::move(number_);
  scale = scale_;
}

Cell PaperQuantity::stated(const std::optional<double>& value) const {
  return value && number == whole ? Cell(static_cast<Index>(*value)) : cell_of(value);
}

Cell PaperQuantity::for_reader(const Cell& value) const {
  return unit == truth && !value.is_null() ? Cell(value != 0) : value;
}

const std::vector<PaperQuantity>& paper_quantities() {
  static const std::vector<PaperQuantity> all = {
      {"duration", "duration (s)", "s", "{:g}"},
      {"delta", "threshold delta", "", "{:.0e}"},
      {"contacts", "contacts", "", "{:.2f}"},
      {"active", "active", "", "{:.2f}"},
      {"total_frames", "total frames", "frames"},
      {"success", "success", "frames", whole, 1, by_criterion},
      {"failure", "failure", "frames", whole, 1, by_criterion},
      {"no_solution", "  no solution", "frames", whole, 1, by_criterion},
      {"cycle", "  cycle", "frames", whole, 1, by_criterion},
      {"error", "  error", "frames", whole, 1, by_criterion},
      {"unsupported", "unsupported", "frames", whole, 1, by_criterion},
      {"lcp_time_ms", "LCP solve time (ms)", "ms", "{:.3f}"},
      {"simulation_time_ms", "simulation time (ms)", "ms", "{:.3f}"},
      {"total_pivots", "total pivots", "pivots"},
      {"frictionless_failures", "frictionless failed", "frames", whole, 1, by_criterion},
      {"both_failures", "both failed", "frames", whole, 1, by_criterion},
      {"fell", "fell", truth},
      {"tilt_max", "tilt at most (deg)", "rad", "{:.1f}", 180 / M_PI},
      {"depth_max", "penetration (mm)", "m", "{:.3g}", 1e3},
      {"energy_excess", "energy excess (%)", "", "{:.2g}", 100},
      {"work", "work of pulls (J)", "J", "{:.3g}"},
      {"gap_end", "loops open (mm)", "m", "{:.1e}", 1e3},
      {"force_mismatch", "force mismatch (%)", "", "{:.2g}", 100},
      {"residual_median", "residual, median", "", "{:.1e}", 1, by_criterion},
      {"residual_max", "residual, largest", "", "{:.1e}", 1, by_criterion},
      {"nodes", "nodes, mean", "", "{:.1f}"},
      {"pivots", "pivots, mean", "", "{:.1f}"},
      {"wrong", "wrong", "frames", whole, 1, by_criterion},
      {"unclaimed", "unclaimed", "frames", whole, 1, by_criterion},
      {"not_run", "not run", "frames"},
      {"trivial", "trivial, of success", "frames", whole, 1, by_criterion},
      {"time_median_ms", "median time (ms)", "ms", "{:.3f}"},
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
