#include "solvers/linalg/pivoting_options.h"

namespace lcp {

OptionTable tableau_option_table(PivotingOptions& options) {
  return {
      real("pivot", options.pivot, 0, 1,
           "pivot tolerance: m'_i < -pivot may be a pivot; in the scale worked in")
          .accuracy({"1e-06", "1e-08", "1e-10", "1e-12", "0"}),
      flag("scale", options.scale, "work on the problem scaled by s_z, s_w; off: in its own units"),
      count_or("max_pivots", options.max_pivots, 1, 1'000'000'000, "auto",
               "basis changes before `limit`; auto: max(1000, 50 n), 2^(n+1) where exponential"),
      choice("restart", options.restart,
             "when a starting basis is singular: claim `singular`, or solve from scratch"),
  };
}

OptionTable factorised_option_table(PivotingOptions& options) {
  OptionTable table = tableau_option_table(options);
  table.push_back(count("refactor_every", options.refactor_every, 1, 1000,
                        "pivots between two factorisations of the basis"));
  return table;
}

}  // namespace lcp
