#include "harness/runs/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <tuple>

#include "harness/judge/judge.h"

namespace lcp {

namespace {

bool solved(const Record& record) { return record.verdict == Verdict::solved; }

/// Milliseconds of a record's samples: `0.24 (0.23 ... 0.25)`.
std::string printed_times(const Record& record) {
  const auto [low, high] = std::minmax_element(record.times_ns.begin(), record.times_ns.end());
  const auto ms = [](std::int64_t ns) { return static_cast<double>(ns) * 1e-6; };
  return fmt::format("{:.3g} ms ({:.3g} ... {:.3g})", ms(*record.median_ns()), ms(*low), ms(*high));
}

double ratio_of(double after, double before) { return after / std::max(before, 1.0); }

/// How many times slower; 0 unless every sample of `after` is longer than every one of `before`.
double slowdown(const Record& before, const Record& after) {
  if (before.times_ns.empty() || after.times_ns.empty()) return 0;
  if (*std::min_element(after.times_ns.begin(), after.times_ns.end()) <=
      *std::max_element(before.times_ns.begin(), before.times_ns.end()))
    return 0;
  return ratio_of(static_cast<double>(*after.median_ns()),
                  static_cast<double>(*before.median_ns()));
}

void compare_pair(const Record& before, const Record& after, const CompareOptions& options,
                  Comparison& found) {
  if (before.tolerance != after.tolerance)
    throw std::invalid_argument(
        fmt::format("{} of {} was judged at {} and at {}: runs are compared at one tolerance",
                    before.solver, before.instance, before.tolerance, after.tolerance));
  ++found.compared;
  if (!solved(before)) {
    found.gained += solved(after);
    return;
  }
  using Kind = Regression::Kind;
  const auto worse = [&](Kind kind, double ratio, std::string was, std::string is) {
    found.regressions.push_back({kind, key_of(before), ratio, std::move(was), std::move(is)});
  };
  if (!solved(after))
    return worse(Kind::lost, 0, to_string(before.verdict), to_string(after.verdict));
  const auto pivots_before = static_cast<double>(before.work.pivots);
  const auto pivots_after = static_cast<double>(after.work.pivots);
  if (pivots_after > (1 + options.pivot_growth) * pivots_before)
    worse(Kind::pivots, ratio_of(pivots_after, pivots_before),
          fmt::format("{} pivots", before.work.pivots),
          fmt::format("{} pivots", after.work.pivots));
  if (const double times = slowdown(before, after); times > options.time_ratio)
    worse(Kind::time, times, printed_times(before), printed_times(after));
}

}  // namespace

const char* to_string(Regression::Kind kind) {
  return std::array{"lost", "pivots", "time"}.at(static_cast<std::size_t>(kind));
}

Comparison compare(const std::vector<Record>& before, const std::vector<Record>& after,
                   const CompareOptions& options) {
  std::map<PairKey, const Record*> later;
  for (const Record& record : after) later.emplace(key_of(record), &record);
  Comparison found;
  for (const Record& record : before) {
    const auto same = later.find(key_of(record));
    if (same == later.end())
      ++found.only_old;
    else
      compare_pair(record, *same->second, options, found);
  }
  found.only_new = after.size() - found.compared;
  std::stable_sort(found.regressions.begin(), found.regressions.end(),
                   [](const Regression& a, const Regression& b) {
                     return std::tuple(a.kind, -a.ratio) < std::tuple(b.kind, -b.ratio);
                   });
  return found;
}

}  // namespace lcp
