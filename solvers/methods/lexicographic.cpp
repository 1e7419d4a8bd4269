// Lemke's algorithm with lexicographic order among tied rows, and a threshold for what is a tie.
//
// Source    R. Cottle, G. Dantzig (1968); K. Yamane, Y. Nakamura (2008), II-B and V-A; K. Murty
//           (1988), 2.2.8.
// Notation  as in lemke.cpp; delta is the paper's Delta. Columns of the basis inverse belong to w_1
//           ... w_n: minus their columns of the dictionary, unit vectors where they are basic.
// Cost      as in lemke.cpp, plus the entries of the tied rows for every column looked at.
// Class     From lexico-positive rows, in exact arithmetic, it ends after finitely many pivots, in
//           a solution or on a ray, degenerate or not. Step 0 therefore takes the last index among
//           tied minimal q_i. Floating-point numbers are never exactly tied, so rows within `delta`
//           count as tied: too small a delta leaves the choice to rounding, too large a one ties
//           what differs, and nothing says which delta suits a problem (II-B).
// Differs   from lemke.cpp in the choice among tied rows and in taking z0 as soon as it is tied.

#include <cmath>
#include <limits>

#include "solvers/linalg/basis.h"
#include "solvers/linalg/complementary_path.h"
#include "solvers/linalg/tableau.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

struct LexicographicOptions {
  double delta = 1e-8;
  double z0 = std::numeric_limits<double>::quiet_NaN();  ///< NaN: as delta.
  PivotingOptions pivoting;
};

OptionTable option_table(LexicographicOptions& options, OptionTable pivoting) {
  OptionTable table = {
      real("delta", options.delta, 0, 1,
           "tie threshold: ratios and entries within delta of the least are tied; scale worked in")
          .accuracy({"1e-03", "1e-04", "1e-06", "1e-08", "1e-10", "1e-12", "0"}),
      real_or("z0", options.z0, 0, 1, "delta",
              "z0 preference: z0's row is taken within this of the least ratio; scale worked in"),
  };
  for (Option& option : pivoting) table.push_back(std::move(option));
  return table;
}

OptionTable tableau_options(LexicographicOptions& options) {
  return option_table(options, tableau_option_table(options.pivoting));
}

OptionTable revised_options(LexicographicOptions& options) {
  return option_table(options, factorised_option_table(options.pivoting));
}

struct LexicographicRule {
  RatioTolerances tolerances;

  Index step0(const VectorXd& q, const VectorXd& c) const {
    const VectorXd ratio = q.cwiseQuotient(c);
    const double threshold = ratio.minCoeff() + tolerances.delta;
    Index r = ratio.size() - 1;
    while (!(ratio(r) <= threshold)) --r;
    return r;
  }
  template <class Dictionary>
  Blocking step1(Dictionary& dictionary, const VectorXd& m,
                 const std::vector<Variable>& first) const {
    return lexicographic_ratio_test(dictionary, m, first, tolerances);
  }
  /// A z0 this small would be taken at once.
  double accepted_infeasibility() const { return tolerances.z0; }
};

template <class Dictionary>
Result solve(const Problem& problem, const LexicographicOptions& options, const Call& call) {
  const double z0 = std::isnan(options.z0) ? options.delta : options.z0;
  return follow_complementary_path<Dictionary>(
      problem, options.pivoting, call,
      LexicographicRule{{options.pivoting.pivot, options.delta, z0}});
}

const InSuites at_four_deltas{.settings = {"delta=0", "delta=1e-8", "delta=1e-6", "delta=1e-4"},
                              .place = 1};

const Registration lexicographic{
    {.name = "lexicographic",
     .summary =
         "Lemke with lexicographic ties within delta on an explicit tableau, no pivot tolerance",
     .source = "Yamane and Nakamura 2008, II-B and V-A",
     .in_suites = at_four_deltas},
    LexicographicOptions{},
    tableau_options,
    solve<Tableau>};

const Registration lexicographic_pivot{{.name = "lexicographic-pivot",
                                        .summary = "the same with a pivot tolerance",
                                        .source = "lexicographic, ours",
                                        .in_suites = at_four_deltas},
                                       LexicographicOptions{.pivoting = {.pivot = 1e-10}},
                                       tableau_options,
                                       solve<Tableau>};

const Registration lexicographic_revised{
    {.name = "lexicographic-revised",
     .summary = "the same rule on a factorised basis, with a pivot tolerance, scaled",
     .source = "revised form of Yamane and Nakamura 2008, II-B",
     .in_suites = {.place = 2}},
    LexicographicOptions{.pivoting = {.pivot = 1e-12, .scale = true, .refactor_every = 16}},
    revised_options,
    solve<Basis>};

}  // namespace
}  // namespace lcp
