#pragma once

#include <string>
#include <vector>

#include "problems/instance.h"
#include "solvers/result.h"

namespace lcp {

/// What the judge, or the runner where there is nothing to judge, decides of one run.
enum class Verdict {
  solved,            ///< Claimed solved, natural residual within the tolerance.
  wrong,             ///< Claimed solved or infeasible, and fails the check.
  inaccurate,        ///< Only in re-judged tables: passed at the run's tolerance, not at a smaller one.
  ray,
  exhausted,
  infeasible,        ///< The certificate was checked.
  false_infeasible,  ///< Claimed infeasible, but a checked solution is known.
  cycle,
  limit,
  singular,
  timeout,
  memory,
  crash,
  unsupported,
  not_run,
};

const std::vector<Verdict>& all_verdicts();
std::string to_string(Verdict verdict);  ///< With '-' for '_': false-infeasible, not-run.
Verdict verdict_from_string(const std::string& name);

/// How good an answer is. Everything is computed from M, q and the answer in __float128 (113 bits)
/// and rounded at the end; a NaN or infinity in the answer makes every figure infinite.
struct Accuracy {
  double residual;           ///< max_i |min(z_i / s_z,i, w_i / s_w,i)|, w = M z + q recomputed.
  double residual_unscaled;  ///< max_i |min(z_i, w_i)|.
  double zero_residual;      ///< The first of these for z = 0.
  double paper_error;        ///< |w - M z - q - z0 c|_inf of the solver's own w, z0; NaN without.
  double min_z;
  double min_w;
  double max_zw;             ///< max_i |z_i w_i|.
  double backward_error;     ///< omega: componentwise backward error of the basis.
};

Accuracy measure(const Problem& problem, const Result& result);

struct Judgement {
  Verdict verdict;
  bool unclaimed;  ///< Claims a failure while its z passes.
  bool trivial;    ///< z = 0 passes: kept apart, not counted as success.
  Accuracy accuracy;
};

/// Judges one answer: `solved` needs residual <= tolerance (dimensionless).
Judgement judge(const Instance& instance, const Result& result, double tolerance);

/// True when y >= 0, M'y <= 0 and q'y < 0, each in __float128, with y >= 0 exact and M'y within
/// `tolerance` times |M|'|y|: then w = M z + q has no w, z >= 0.
bool proves_infeasible(const Problem& problem, const VectorXd& y, double tolerance);

}  // namespace lcp
