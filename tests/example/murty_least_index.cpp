// Murty's least-index principal pivoting: exchange w_i and z_i for the lowest i with q'_i < 0.
//
// Source    K. Murty, Linear Complementarity, Linear and Nonlinear Programming (1988), 4.1.
// Class     Ends in the solution for P-matrices, after up to 2^n - 1 pivots; elsewhere it may cycle
//           (`limit`) or meet a zero diagonal (`singular`). In floating point `tolerance` decides
//           which q'_i are negative.

#include "solvers/linalg/basis.h"
#include "solvers/linalg/complementary_path.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

struct LeastIndexOptions {
  double tolerance = 1e-10;
  PivotingOptions pivoting = {.pivot = 1e-12, .scale = true};
};

OptionTable option_table(LeastIndexOptions& options) {
  OptionTable table = factorised_option_table(options.pivoting);
  table.push_back(real("tolerance", options.tolerance, 0, 1, "q'_i below minus this is negative")
                      .accuracy({"1e-04", "1e-06", "1e-08", "1e-10"}));
  return table;
}

Result solve(const Problem& problem, const LeastIndexOptions& options, const Call& call) {
  const ScaledProblem scaled(problem, options.pivoting.scale);
  Basis basis(scaled, starting_alpha(problem, call), options.pivoting);
  const Labels& labels = basis.labels();
  Work work;
  const auto finish = [&](Claim claim) { return basic_result(scaled, basis, work, claim, ""); };
  VectorXd column;
  while (basis.usable()) {
    Index i = 0;
    while (i < problem.size() && basis.q()(i) >= -options.tolerance) ++i;
    if (i == problem.size()) return finish(Claim::solved);
    if (work.pivots == pivot_limit(options.pivoting, problem)) return finish(Claim::limit);
    const Variable entering = labels.complement(labels.basic(i));
    basis.column(entering, column);
    if (!(std::abs(column(i)) > options.pivoting.pivot)) break;
    basis.pivot({i, entering}, column);
    ++work.pivots;
  }
  return finish(Claim::singular);
}

const Registration least_index{
    {"murty-least-index", "least-index principal pivoting", "Murty 1988, 4.1"},
    LeastIndexOptions{},
    option_table,
    solve};

}  // namespace
}  // namespace lcp
