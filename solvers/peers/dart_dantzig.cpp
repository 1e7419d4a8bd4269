// DART's copy of ODE's Dantzig kernel, dSolveLCP.
//
// Source    DART, dart/external/odelcpsolver/lcp.h; R. Smith, ODE; D. Baraff 1994.
// Form      A x = b + w, so b = -q, bounds 0 and infinity, every friction index -1; A row by row,
//           rows padded to dPAD(n), and destroyed. It uses one triangle of A only: M must be
//           symmetric. It is meant for positive definite A: engines add 1e-9 ... 1e-5 to the
//           diagonal first, which `cfm` does here.
// Status    With early=on it returns false as soon as a pivot fails; with early=off, as DART itself
//           calls it first, it goes on and always returns true. No count of pivots, no limit, no
//           tolerance.

#include <dart/external/odelcpsolver/lcp.h>

#include "solvers/peers/outside_call.h"

namespace lcp {
namespace {

struct DantzigOptions : PeerOptions {
  double cfm = 0;
  bool early = true;
  double symmetry = 1e-8;
};

OptionTable option_table(DantzigOptions& options) {
  return {
      real("cfm", options.cfm, 0, 1, "added to the diagonal of M, in its largest entry")
          .accuracy({"1e-03", "1e-05", "1e-07", "1e-09", "1e-11", "0"}),
      flag("early", options.early,
           "ends when a pivot fails; without it the library claims success always"),
      real("symmetry", options.symmetry, 0, 1,
           "largest |M - M'|, in max |M|, that counts as symmetric"),
      scale_option(options),
  };
}

Result solve(const Problem& problem, const DantzigOptions& options, const Call& call) {
  const Index n = problem.size();
  if (call.start) return refuse(problem, any_start(call));
  if (n == 0) return solved_empty();
  const ScaledProblem scaled(problem, options.scale);
  const Obstacle obstacle = unsymmetric(scaled.M(), options.symmetry);
  if (!obstacle.empty()) return refuse(problem, obstacle);
  const int size = static_cast<int>(n);
  BoxedForm boxed(scaled, dPAD(size));
  boxed.A.diagonal().array() += options.cfm * scaled.M().diagonal().maxCoeff();
  bool success = false;
  {
    const OutsideCall under_way("dart-dantzig");
    success = dart::external::ode::dSolveLCP(size, boxed.A.data(), boxed.x.data(), boxed.b.data(),
                                             boxed.w.data(), 0, boxed.low.data(), boxed.high.data(),
                                             boxed.friction.data(), options.early);
  }
  return outside_result(scaled, success ? Claim::solved : Claim::singular,
                        success ? "" : "false: a pivot failed", std::move(boxed.x),
                        std::move(boxed.w), {});
}

const Registration dart_dantzig{
    {.name = "dart-dantzig",
     .summary = "Dantzig's principal pivoting, row after row, on an updated LDL'",
     .source = "DART, dSolveLCP, from ODE; Baraff 1994",
     .supports = "a symmetric M; made for positive definite ones, see cfm",
     .outside_library = "DART " LCPBENCH_DART_KERNEL_VERSION,
     .outside_constants = "none but early termination; cfm is what engines add themselves"},
    DantzigOptions{},
    option_table,
    solve};

}  // namespace
}  // namespace lcp
