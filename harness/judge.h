#pragma once

#include <string>
#include <vector>

#include "problems/instance.h"
#include "solvers/result.h"

namespace lcp {

/// What the judge, or the runner where there is nothing to judge, decides of one run.
enum class Verdict {
  solved,      ///< Claimed solved, natural residual within the tolerance.
  wrong,       ///< Claimed solved or infeasible, and fails the check.
  inaccurate,  ///< Only in re-judged tables: passed at the run's tolerance, not at a smaller.
  ray,         ///< As claimed; so are the following where nothing is said.
  exhausted,
  infeasible,        ///< The certificate was checked, and no solution is known.
  false_infeasible,  ///< Claimed infeasible, but a checked solution is known.
  cycle,
  limit,
  singular,
  timeout,  ///< The runner's: one solve took longer than it may.
  memory,   ///< The runner's: the worker held more memory than it may.
  crash,    ///< The runner's: the worker died or an exception left the solver.
  unsupported,
  not_run,  ///< The runner's: the pair was left out.
};

const std::vector<Verdict>& all_verdicts();
std::string to_string(Verdict verdict);  ///< With '-' for '_': false-infeasible, not-run.
/// Throws std::invalid_argument with the list of verdicts.
Verdict verdict_from_string(const std::string& name);

/// How good an answer is. Everything is computed from M, q and the answer in __float128 (113 bits)
/// and rounded at the end. Where z, w or the covering vector is no vector of n finite numbers, or
/// the basis names a row that does not exist, every figure of the answer is infinite (the minima
/// minus infinity).
struct Accuracy {
  double residual;           ///< max_i |min(z_i / s_z,i, w_i / s_w,i)|, w = M z + q recomputed.
  double residual_unscaled;  ///< max_i |min(z_i, w_i)|.
  double zero_residual;      ///< Of z = 0: a figure of the problem alone.
  double paper_error;        ///< |w - M z - q - z0 c|_inf of the solver's own w, z0; NaN without.
  double min_z;              ///< 0 where n = 0, as min_w.
  double min_w;
  double max_zw;  ///< max_i |z_i w_i|.
  /// omega, the componentwise backward error of the basis alpha: with z set to 0 outside alpha and
  /// w = M z + q of that z, the largest of |w_i| (i in alpha) and max(0, -w_i) (other i), each over
  /// (|M||z| + |q|)_i, where 0/0 = 0; infinite where some z_i < 0 in alpha. An answer without a
  /// basis is measured at alpha = {i : z_i / s_z,i > w_i / s_w,i}: compared in the problem's scales,
  /// since z_i and w_i have different units.
  double backward_error;
};

/// The natural residual of z = 0: max_i max(0, -q_i / s_w,i). Small where the problem is trivial.
double zero_residual(const Problem& problem);

/// Costs O(n) for every z_j that is not zero. Throws std::invalid_argument when the problem itself
/// is malformed (see check).
Accuracy measure(const Problem& problem, const Result& result);

struct Judgement {
  Verdict verdict;
  bool unclaimed;  ///< Claims a failure (not `unsupported`) while its z passes.
  bool trivial;    ///< z = 0 passes: kept apart, not counted as success.
  Accuracy accuracy;
};

/// Judges one answer. z passes when its residual is <= tolerance (dimensionless). A claim of
/// `infeasible` is false-infeasible when any z is known that passes (the instance's known solution,
/// z = 0, or the z of the answer itself), infeasible when its certificate proves it (see
/// proves_infeasible, same tolerance), and wrong otherwise. Throws as measure does.
Judgement judge(const Instance& instance, const Result& result, double tolerance);

/// True when y >= 0 exactly, M'y <= tolerance |M|'y in every component, and
/// q'y < -tolerance |q|'y, all in __float128; false for a y that is no vector of n finite numbers.
/// At tolerance 0 this is Farkas' proof that no w, z >= 0 satisfy w = M z + q: y'w would be
/// (M'y)'z + q'y < 0. Above 0 it forgives rounding in y, and still excludes every z with
/// tolerance (|M|'y)'z < |q'y|.
bool proves_infeasible(const Problem& problem, const VectorXd& y, double tolerance);

}  // namespace lcp
