#include "harness/studies/paper/quantities.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "solvers/registry.h"

namespace lcp {

namespace {

std::optional<double> nothing(const CorpusColumn&) { return std::nullopt; }
std::optional<double> nowhere(const LoopColumn&) { return std::nullopt; }

/// Empty for a column that crashed before its first frame, and for what is no number.
template <class Value>
std::function<std::optional<double>(const LoopColumn&)> in_loop(Value LoopSummary::*field) {
  return [field](const LoopColumn& column) -> std::optional<double> {
    const double value = static_cast<double>(column.summary.*field);
    if (column.summary.steps == 0 || std::isnan(value)) return std::nullopt;
    return value;
  };
}

std::function<std::optional<double>(const CorpusColumn&)> on_corpus(Index TableRow::*field) {
  return [field](const CorpusColumn& column) { return static_cast<double>(column.counts.*field); };
}

std::function<std::optional<double>(const CorpusColumn&)> on_corpus(
    std::optional<double> TableRow::*field) {
  return [field](const CorpusColumn& column) { return column.counts.*field; };
}

/// The threshold of ties, where the solver has one.
std::optional<double> delta_of(const std::string& solver) {
  const NamedSolver named = make_solver(solver);  // which the options' getters refer to
  for (const Option& option : named.solver->options())
    if (option.name == "delta") return std::stod(option.get());
  return std::nullopt;
}

PaperQuantity count(std::string key, std::string label, Index LoopSummary::*field,
                    Index TableRow::*corpus_field, bool judged = true) {
  return {.key = std::move(key),
          .label = std::move(label),
          .unit = "frames",
          .in_loop = in_loop(field),
          .on_corpus = on_corpus(corpus_field),
          .counted = true,
          .judged = judged};
}

std::vector<PaperQuantity> make_quantities() {
  const auto pivots = [](const CorpusColumn& c) { return static_cast<double>(c.pivots); };
  return {
      {.key = "duration",
       .label = "duration (s)",
       .unit = "s",
       .number = "{:g}",
       .in_loop = in_loop(&LoopSummary::duration),
       .on_corpus = nothing},
      {.key = "delta",
       .label = "threshold delta",
       .number = "{:.0e}",
       .in_loop = [](const LoopColumn& c) { return delta_of(c.question.solver); },
       .on_corpus = [](const CorpusColumn& c) { return delta_of(c.solver); }},
      {.key = "contacts",
       .label = "contacts",
       .number = "{:.2f}",
       .in_loop = in_loop(&LoopSummary::contacts),
       .on_corpus = on_corpus(&TableRow::contacts)},
      {.key = "active",
       .label = "active",
       .number = "{:.2f}",
       .in_loop = in_loop(&LoopSummary::active),
       .on_corpus = on_corpus(&TableRow::active)},
      count("total_frames", "total frames", &LoopSummary::total_frames, &TableRow::instances,
            false),
      count("success", "success", &LoopSummary::success, &TableRow::success),
      count("failure", "failure", &LoopSummary::failure, &TableRow::failure),
      count("no_solution", "  no solution", &LoopSummary::no_solution, &TableRow::no_solution),
      count("cycle", "  cycle", &LoopSummary::cycle, &TableRow::cycle),
      count("error", "  error", &LoopSummary::error, &TableRow::error),
      count("unsupported", "unsupported", &LoopSummary::unsupported, &TableRow::unsupported),
      {.key = "lcp_time_ms",
       .label = "LCP solve time (ms)",
       .unit = "ms",
       .number = "{:.3f}",
       .in_loop = in_loop(&LoopSummary::lcp_ms),
       .on_corpus = [](const CorpusColumn& c) { return std::optional(c.lcp_ms); }},
      {.key = "simulation_time_ms",
       .label = "simulation time (ms)",
       .unit = "ms",
       .number = "{:.3f}",
       .in_loop = in_loop(&LoopSummary::simulation_ms),
       .on_corpus = nothing},
      {.key = "total_pivots",
       .label = "total pivots",
       .unit = "pivots",
       .in_loop = in_loop(&LoopSummary::pivots),
       .on_corpus = pivots,
       .counted = true},
      {.key = "frictionless_failures",
       .label = "frictionless failed",
       .unit = "frames",
       .in_loop = in_loop(&LoopSummary::frictionless_failures),
       .on_corpus =
           [](const CorpusColumn& c) { return static_cast<double>(c.frictionless_failures); },
       .counted = true,
       .judged = true},
      {.key = "both_failures",
       .label = "both failed",
       .unit = "frames",
       .in_loop = in_loop(&LoopSummary::both_failures),
       .on_corpus = [](const CorpusColumn& c) { return static_cast<double>(c.both_failures); },
       .counted = true,
       .judged = true},
      {.key = "fell",
       .label = "fell",
       .unit = "1 if so",
       .in_loop = [](const LoopColumn& c) { return std::optional<double>(c.fell()); },
       .on_corpus = nothing,
       .counted = true},
      {.key = "tilt_max",
       .label = "tilt at most (deg)",
       .unit = "rad",
       .scale = 180 / M_PI,
       .number = "{:.1f}",
       .in_loop = in_loop(&LoopSummary::tilt_max),
       .on_corpus = nothing},
      {.key = "depth_max",
       .label = "penetration (mm)",
       .unit = "m",
       .scale = 1e3,
       .number = "{:.3g}",
       .in_loop = in_loop(&LoopSummary::depth_max),
       .on_corpus = nothing},
      {.key = "energy_excess",
       .label = "energy excess (%)",
       .scale = 100,
       .number = "{:.2g}",
       .in_loop = in_loop(&LoopSummary::energy_excess),
       .on_corpus = nothing},
      {.key = "work",
       .label = "work of pulls (J)",
       .unit = "J",
       .number = "{:.3g}",
       .in_loop = in_loop(&LoopSummary::work),
       .on_corpus = nothing},
      {.key = "gap_end",
       .label = "loops open (mm)",
       .unit = "m",
       .scale = 1e3,
       .number = "{:.1e}",
       .in_loop = [](const LoopColumn& c) -> std::optional<double> {
         if (c.summary.gap_max == 0) return std::nullopt;  // no loops
         return c.summary.gap_end;
       },
       .on_corpus = nothing},
      {.key = "force_mismatch",
       .label = "force mismatch (%)",
       .scale = 100,
       .number = "{:.2g}",
       .in_loop = in_loop(&LoopSummary::force_mismatch),
       .on_corpus = nothing},
      {.key = "residual_median",
       .label = "residual, median",
       .number = "{:.1e}",
       .in_loop = in_loop(&LoopSummary::residual_median),
       .on_corpus = on_corpus(&TableRow::residual_median),
       .judged = true},
      {.key = "residual_max",
       .label = "residual, largest",
       .number = "{:.1e}",
       .in_loop = in_loop(&LoopSummary::residual_max),
       .on_corpus = on_corpus(&TableRow::residual_max),
       .judged = true},
      {.key = "nodes",
       .label = "nodes, mean",
       .number = "{:.1f}",
       .in_loop = [](const LoopColumn& c) -> std::optional<double> {
         if (c.summary.total_frames == 0) return std::nullopt;
         return static_cast<double>(c.summary.nodes) / static_cast<double>(c.summary.total_frames);
       },
       .on_corpus = on_corpus(&TableRow::nodes)},
      {.key = "pivots",
       .label = "pivots, mean",
       .number = "{:.1f}",
       .in_loop = [](const LoopColumn& c) -> std::optional<double> {
         if (c.summary.total_frames == 0) return std::nullopt;
         return static_cast<double>(c.summary.pivots) / static_cast<double>(c.summary.total_frames);
       },
       .on_corpus = on_corpus(&TableRow::pivots)},
      {.key = "wrong",
       .label = "wrong",
       .unit = "frames",
       .in_loop = nowhere,
       .on_corpus = on_corpus(&TableRow::wrong),
       .counted = true,
       .judged = true},
      {.key = "unclaimed",
       .label = "unclaimed",
       .unit = "frames",
       .in_loop = nowhere,
       .on_corpus = on_corpus(&TableRow::unclaimed),
       .counted = true,
       .judged = true},
      {.key = "not_run",
       .label = "not run",
       .unit = "frames",
       .in_loop = nowhere,
       .on_corpus = on_corpus(&TableRow::not_run),
       .counted = true},
      {.key = "trivial",
       .label = "trivial, of success",
       .unit = "frames",
       .in_loop = nowhere,
       .on_corpus = on_corpus(&TableRow::trivial),
       .counted = true,
       .judged = true},
      {.key = "time_median_ms",
       .label = "median time (ms)",
       .unit = "ms",
       .number = "{:.3f}",
       .in_loop = nowhere,
       .on_corpus = on_corpus(&TableRow::time_median_ms)},
  };
}

}  // namespace

const std::vector<PaperQuantity>& paper_quantities() {
  static const std::vector<PaperQuantity> all = make_quantities();
  return all;
}

const PaperQuantity& paper_quantity(const std::string& key) {
  for (const PaperQuantity& quantity : paper_quantities())
    if (quantity.key == key) return quantity;
  throw std::invalid_argument(fmt::format("no quantity '{}' in the paper's tables", key));
}

std::string printed(const PaperQuantity& quantity, double value) {
  if (quantity.key == "fell") return value != 0 ? "yes" : "no";
  if (value == 0) return "0";
  return fmt::format(fmt::runtime(quantity.number), quantity.scale * value);
}

}  // namespace lcp
