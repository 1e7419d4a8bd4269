#include "harness/judge/judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/judge/quad.h"

namespace lcp {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Raises `largest` to x; a NaN stays, so that what is compared with it later fails.
void raise(Quad& largest, Quad x) {
  if (!(x <= largest)) largest = x;
}

/// w = M z + q and |M||z| + |q|, the yardstick of its rounding.
struct Image {
  Quads w;
  Quads size;
};

Image image(const Problem& problem, const VectorXd& z) {
  const Index n = problem.size();
  Image result{Quads(problem.q.begin(), problem.q.end()), Quads(n)};
  for (Index i = 0; i < n; ++i) result.size[i] = std::abs(problem.q(i));
  for (Index j = 0; j < n; ++j) {
    if (z(j) == 0) continue;
    for (Index i = 0; i < n; ++i) {
      const Quad term = static_cast<Quad>(problem.M(i, j)) * z(j);
      result.w[i] += term;
      result.size[i] += magnitude(term);
    }
  }
  return result;
}

/// max_i |min(z_i / s_z,i, w_i / s_w,i)|.
double natural_residual(const VectorXd& z, const Quads& w, const VectorXd& s_z,
                        const VectorXd& s_w) {
  Quad largest = 0;
  for (Index i = 0; i < z.size(); ++i)
    raise(largest, magnitude(std::min(static_cast<Quad>(z(i)) / s_z(i), w[i] / s_w(i))));
  return static_cast<double>(largest);
}

/// max_i |w_i - (M z + q)_i - z0 c_i| of the solver's own w (8); NaN where it returns none.
double paper_error(const Result& result, const Quads& recomputed) {
  if (result.w.size() != result.z.size()) return std::numeric_limits<double>::quiet_NaN();
  Quad largest = 0;
  for (Index i = 0; i < result.w.size(); ++i) {
    const Quad artificial =
        result.covering.size() > 0 ? static_cast<Quad>(result.z0) * result.covering(i) : Quad(0);
    raise(largest, magnitude(result.w(i) - recomputed[i] - artificial));
  }
  return static_cast<double>(largest);
}

/// Which rows are in alpha: as returned, else those whose z is larger than w in the given scales.
std::vector<bool> membership(const Problem& problem, const Result& result, const Quads& w) {
  const Index n = problem.size();
  std::vector<bool> in_alpha(n, false);
  if (result.basis) {
    for (const Index row : *result.basis) in_alpha[row] = true;
  } else {
    for (Index i = 0; i < n; ++i)
      in_alpha[i] = static_cast<Quad>(result.z(i)) / problem.s_z(i) > w[i] / problem.s_w(i);
  }
  return in_alpha;
}

double backward_error(const Problem& problem, const VectorXd& z, const std::vector<bool>& in_alpha,
                      const Image& of_z) {
  const Index n = problem.size();
  VectorXd kept = z;
  for (Index i = 0; i < n; ++i) {
    if (!in_alpha[i]) kept(i) = 0;
    if (!(kept(i) >= 0)) return infinity;
  }
  const Image of_kept = kept == z ? of_z : image(problem, kept);
  Quad largest = 0;
  for (Index i = 0; i < n; ++i) {
    const Quad w = of_kept.w[i];
    const Quad violation = in_alpha[i] || w < 0 ? magnitude(w) : Quad(0);
    if (violation > 0) raise(largest, violation / of_kept.size[i]);
  }
  return static_cast<double>(largest);
}

bool well_formed(const Problem& problem, const Result& result) {
  const Index n = problem.size();
  const auto finite = [n](const VectorXd& x) { return x.size() == n && x.allFinite(); };
  const auto absent_or_finite = [&](const VectorXd& x) { return x.size() == 0 || finite(x); };
  const bool rows_exist =
      !result.basis || std::all_of(result.basis->begin(), result.basis->end(),
                                   [n](Index row) { return row >= 0 && row < n; });
  return finite(result.z) && absent_or_finite(result.w) && absent_or_finite(result.covering) &&
         std::isfinite(result.z0) && rows_exist;
}

bool passes(const Problem& problem, const VectorXd& z, double tolerance) {
  if (z.size() != problem.size() || !z.allFinite()) return false;
  return natural_residual(z, image(problem, z).w, problem.s_z, problem.s_w) <= tolerance;
}

Verdict judge_infeasible(const Instance& instance, const Result& result, bool solution_known,
                         double tolerance) {
  const std::optional<VectorXd>& known = instance.known_solution;
  if (solution_known || (known && passes(instance.problem, *known, tolerance)))
    return Verdict::false_infeasible;
  return proves_infeasible(instance.problem, result.certificate, tolerance) ? Verdict::infeasible
                                                                            : Verdict::wrong;
}

}  // namespace

double zero_residual(const Problem& problem) {
  const VectorXd zero = VectorXd::Zero(problem.size());
  return natural_residual(zero, image(problem, zero).w, problem.s_z, problem.s_w);
}

Accuracy measure(const Problem& problem, const Result& result) {
  check(problem, "problem to judge");
  const Index n = problem.size();
  const double at_zero = zero_residual(problem);
  if (!well_formed(problem, result))
    return {infinity, infinity, at_zero, infinity, -infinity, -infinity, infinity, infinity};

  const VectorXd& z = result.z;
  const Image of_z = image(problem, z);
  const VectorXd one = VectorXd::Ones(n);
  Quad max_zw = 0;
  for (Index i = 0; i < n; ++i) raise(max_zw, magnitude(z(i) * of_z.w[i]));
  return {.residual = natural_residual(z, of_z.w, problem.s_z, problem.s_w),
          .residual_unscaled = natural_residual(z, of_z.w, one, one),
          .zero_residual = at_zero,
          .paper_error = paper_error(result, of_z.w),
          .min_z = n > 0 ? z.minCoeff() : 0,
          .min_w = n > 0 ? static_cast<double>(*std::min_element(of_z.w.begin(), of_z.w.end())) : 0,
          .max_zw = static_cast<double>(max_zw),
          .backward_error = backward_error(problem, z, membership(problem, result, of_z.w), of_z)};
}

Judgement judge(const Instance& instance, const Result& result, const Acceptance& acceptance) {
  const Accuracy accuracy = measure(instance.problem, result);
  Verdict verdict = from_string<Verdict>(to_string(result.claim));  // Most claims stand as they are.
  if (result.claim == Claim::infeasible)
    verdict = judge_infeasible(
        instance, result,
        accuracy.residual <= acceptance.tolerance || accuracy.zero_residual <= acceptance.tolerance,
        acceptance.tolerance);
  return {judged(result.claim, verdict, accuracy, acceptance, acceptance.tolerance), accuracy};
}

bool proves_infeasible(const Problem& problem, const VectorXd& y, double tolerance) {
  const Index n = problem.size();
  if (y.size() != n || !y.allFinite() || !(y.array() >= 0).all()) return false;
  for (Index j = 0; j < n; ++j) {
    Quad sum = 0, size = 0;
    for (Index i = 0; i < n; ++i) {
      if (y(i) == 0) continue;
      const Quad term = static_cast<Quad>(problem.M(i, j)) * y(i);
      sum += term;
      size += magnitude(term);
    }
    if (!(sum <= tolerance * size)) return false;
  }
  Quad sum = 0, size = 0;
  for (Index i = 0; i < n; ++i) {
    const Quad term = static_cast<Quad>(problem.q(i)) * y(i);
    sum += term;
    size += magnitude(term);
  }
  return sum < -tolerance * size;
}

}  // namespace lcp
