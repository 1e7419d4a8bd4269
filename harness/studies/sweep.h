#pragma once

#include <string>
#include <vector>

namespace lcp {

/// The settings of a sweep: the spelling `solver` with every value of the accuracy ladder of each of
/// `options`, one option at a time, fast and rough to slow and exact; without `options`, of every
/// option that has a ladder. Throws std::invalid_argument, with the list of what is allowed, for an
/// option without a ladder, one that `solver` itself sets, or a row that has none at all.
std::vector<std::string> sweep_settings(const std::string& solver,
                                        const std::vector<std::string>& options);

/// The solvers of a sweep.
struct SweepPlan {
  std::vector<std::string> settings;
  /// Spellings among `settings` that a pattern brought and that have no ladder to climb: they are run
  /// as they are.
  std::vector<std::string> without_ladder;
};

/// The same for several solvers, among them `own`, `all` and patterns as make_solvers takes them. Of
/// the rows that a pattern brings, each climbs those of `options` that it has a ladder for. Throws as
/// sweep_settings and make_solvers do, and when nothing has a ladder.
SweepPlan plan_sweep(const std::vector<std::string>& solvers,
                     const std::vector<std::string>& options);

}  // namespace lcp
