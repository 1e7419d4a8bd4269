// Lemke's algorithm, as the paper compares with.
//
// Source    C. Lemke, J. Howson (1964); K. Yamane, Y. Nakamura (2008), II-A and V-A; K. Murty,
//           Linear Complementarity, Linear and Nonlinear Programming (1988), ch. 2.
// Notation  basic = M' nonbasic + q' (5); y_r driving, y_s blocking variable; m' the column of y_r;
//           z0 the artificial variable with covering vector c (8).
// Cost      `lemke`: n (n + 1) multiply-adds a pivot and as many doubles. `lemke-revised`: 2/3 k^3
//           + 2 n k every `refactor_every` pivots, n k + k^2 at each, n k doubles, for k basic z.
// Class     Ends in a solution or on a ray when no ratio test is tied (non-degenerate); a ray means
//           that there is no solution for copositive-plus M and never happens for P-matrices. Ties
//           broken by the lowest row may cycle (Kostreva). In floating point every m'_i that should
//           be 0 but is -1e-17 is a pivot unless `pivot` forbids it, and dividing by it destroys
//           the tableau.
// Differs   from lexicographic.cpp only in how ties are broken.

#include "solvers/linalg/basis.h"
#include "solvers/linalg/complementary_path.h"
#include "solvers/linalg/tableau.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

/// Lowest index where floating-point numbers tie.
struct FirstIndex {
  double pivot;

  Index step0(const VectorXd& q, const VectorXd& c) const {
    Index r;
    q.cwiseQuotient(c).minCoeff(&r);
    return r;
  }
  template <class Dictionary>
  Blocking step1(const Dictionary& dictionary, const VectorXd& m,
                 const std::vector<Variable>&) const {
    return first_index_ratio_test(dictionary.q(), m, pivot);
  }
  double accepted_infeasibility() const { return 0; }
};

template <class Dictionary>
Result solve(const Problem& problem, const PivotingOptions& options, const Call& call) {
  return follow_complementary_path<Dictionary>(problem, options, call, FirstIndex{options.pivot});
}

const Registration lemke{
    {.name = "lemke",
     .summary =
         "Lemke on an explicit tableau: minimum ratio, lowest row on a tie, no pivot tolerance",
     .source = "Yamane and Nakamura 2008, II-A and V-A",
     .in_suites = {.place = 1}},
    PivotingOptions{},
    tableau_option_table,
    solve<Tableau>};

const Registration lemke_revised{
    {.name = "lemke-revised",
     .summary = "the same rule on a factorised basis, with a pivot tolerance, scaled",
     .source = "revised form of Yamane and Nakamura 2008, II-A",
     .in_suites = {.place = 2}},
    PivotingOptions{.pivot = 1e-12, .scale = true, .refactor_every = 16},
    factorised_option_table,
    solve<Basis>};

}  // namespace
}  // namespace lcp
