#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "harness/studies/sheet/sheet.h"

namespace lcp {

namespace {

struct MeasureRow {
  const char* name;
  Index Work::*count;  ///< Null for time.
};

/// As enumerated.
constexpr MeasureRow measure_rows[] = {{"time", nullptr},
                                       {"pivots", &Work::pivots},
                                       {"nodes", &Work::nodes},
                                       {"factorisations", &Work::factorisations}};

const MeasureRow& row_of(Measure measure) { return measure_rows[static_cast<int>(measure)]; }

}  // namespace

const std::vector<Measure>& all_measures() {
  static const std::vector<Measure> all = {Measure::time, Measure::pivots, Measure::nodes,
                                           Measure::factorisations};
  return all;
}

std::string to_string(Measure measure) { return row_of(measure).name; }

std::string printed(Measure measure) {
  return measure == Measure::time ? "time (ms)" : to_string(measure);
}

Measure measure_from_string(const std::string& name) {
  std::vector<std::string> names;
  for (const Measure measure : all_measures()) {
    if (to_string(measure) == name) return measure;
    names.push_back(to_string(measure));
  }
  throw std::invalid_argument(
      fmt::format("unknown measure '{}', known are: {}", name, fmt::join(names, ", ")));
}

double cost_of(const Record& record, Measure measure) {
  if (measure != Measure::time) return static_cast<double>(record.work.*row_of(measure).count);
  const auto time = record.median_ns();
  return time ? 1e-6 * static_cast<double>(*time) : std::numeric_limits<double>::infinity();
}

void Mass::add(const Judged& judged) {
  ++instances;
  solved += judged.success();
  failed += judged.failure();
  trivial += judged.standing() == Standing::trivial;
  unsupported += judged.verdict == Verdict::unsupported;
  not_run += judged.verdict == Verdict::not_run;
}

}  // namespace lcp
