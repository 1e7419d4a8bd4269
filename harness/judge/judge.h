#pragma once

#include <string>
#include <vector>

#include "harness/judge/acceptance.h"
#include "harness/record.h"
#include "problems/instance.h"
#include "solvers/result.h"

namespace lcp {

/// The natural residual of z = 0: max_i max(0, -q_i / s_w,i). Small where the problem is trivial.
double zero_residual(const Problem& problem);

/// Costs O(n) for every z_j that is not zero. Throws std::invalid_argument when the problem itself
/// is malformed (see check).
Accuracy measure(const Problem& problem, const Result& result);

/// What an answer comes to, with its figures.
struct Judgement : Judged {
  Accuracy accuracy;
};

/// Judges one answer by a criterion. A claim of `infeasible` is false-infeasible when any z is known
/// that passes (the instance's known solution, z = 0, or the z of the answer itself), infeasible when
/// its certificate proves it (see proves_infeasible, same tolerance), and wrong otherwise. Throws as
/// measure does.
Judgement judge(const Instance& instance, const Result& result, const Acceptance& acceptance);

/// The same by the natural residual.
inline Judgement judge(const Instance& instance, const Result& result, double tolerance) {
  return judge(instance, result, {Acceptance::Criterion::residual, tolerance});
}

/// True when y >= 0 exactly, M'y <= tolerance |M|'y in every component, and
/// q'y < -tolerance |q|'y, all in __float128; false for a y that is no vector of n finite numbers.
/// At tolerance 0 this is Farkas' proof that no w, z >= 0 satisfy w = M z + q: y'w would be
/// (M'y)'z + q'y < 0. Above 0 it forgives rounding in y, and still excludes every z with
/// tolerance (|M|'y)'z < |q'y|.
bool proves_infeasible(const Problem& problem, const VectorXd& y, double tolerance);

}  // namespace lcp
