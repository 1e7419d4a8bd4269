#pragma once

#include <map>
#include <optional>
#include <string>

#include "harness/studies/replay/high_dictionary.h"
#include "solvers/registry.h"

namespace lcp {

/// The pivoting rule of a row of the Lemke family, to be followed in 113 bits: the tolerances are the
/// row's own, what they are compared with is exact up to Estimate::error.
struct PathRule {
  bool lexicographic = false;  ///< Else the lowest of the exactly tied rows.
  double delta = 0;            ///< Tie threshold, lexicographic rows only.
  double z0 = 0;               ///< z0's row is taken within this of the least ratio.
  double pivot = 0;            ///< m'_i < -pivot may be a pivot.
  bool scale = false;          ///< The scale worked in.
  Index max_pivots = 0;        ///< 0: the problem's own limit.
};

/// The rule of a row whose pivots are those of one complementary path, with the options it is set to;
/// empty for other rows.
std::optional<PathRule> path_rule(const NamedSolver& solver);

/// The settings of a solver's options, by name.
std::map<std::string, std::string> settings_of(const NamedSolver& solver);

/// The choice of Step 0 or Step 1; row -1: nothing blocks.
struct HighChoice {
  Index row = -1;
  Estimate ratio = {};
  Estimate pivot = {};  ///< m'_s; where nothing blocks, nothing.
  Index tied = 0;
  /// Whether a row blocks, or where, 113 bits do not say (Estimate::doubt).
  bool undecided = false;
};

/// Step 0: least q'_i / c_i, the lowest row of exact ties; of the lexicographic rule the last within
/// delta. `zero` as in HighDictionary, here and below.
HighChoice high_step0(const HighDictionary& dictionary, const PathRule& rule, double zero);

/// Step 1 on the column of `driving`, as in solvers/linalg/ratio_test.h. `first` holds the basic
/// variables of the first dictionary.
HighChoice high_step1(const HighDictionary& dictionary, Variable driving,
                      const std::vector<Variable>& first, const PathRule& rule, double zero);

/// Whether a < b beyond the error of either.
bool surely_less(const Estimate& a, const Estimate& b, double zero);

/// Whether m' is surely below minus a pivot tolerance.
bool may_be_pivot(const Estimate& m, double pivot, double zero);

/// -q / m with its error; m is not 0.
Estimate ratio_of(const Estimate& q, const Estimate& m);

}  // namespace lcp
