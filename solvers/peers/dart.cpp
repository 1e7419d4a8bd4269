// DART's own Lemke and its projected Gauss-Seidel, out of its run-time library alone.
//
// Source    DART 6.12, dart/lcpsolver/Lemke.hpp and dart/constraint/PgsBoxedLcpSolver.hpp; Lemke
//           after the LEMKE program of P. Fackler and M. Miranda.
// Reached   Without DART's headers, which need 400 MB of packages: the two functions are looked up
//           by their binary names in libdart.so.6.12, and what they take is laid out here as that
//           release has it (Debian's soname pins it). Vectors and matrices are Eigen's dynamic ones,
//           which are a pointer from malloc() and sizes; no Eigen code of ours meets the library's,
//           which under a sanitizer or with AVX allocates in another way. The library is loaded when
//           a solver is made.
// Lemke     Our sign. Factorises the basis afresh at each pivot (QR, n^3). In its body, absolute:
//           pivots above 1e-8, ties within 1e-5, 1000 pivots, an answer with w, z, w z off by up to
//           1e-4 passes. The scale of the problem decides what they mean: scale=on makes them
//           dimensionless.
// PGS       A x = b + w, so b = -q, bounds 0 and infinity, every friction index -1; rows padded to a
//           multiple of 4; A and b destroyed. Ends when no x moves by more than `tolerance` of
//           itself (absolutely in the first sweep), which says nothing of the residual. Rows with
//           M_ii below 1e-9 (mEpsilonForDivision, left as it is) would be skipped with x = 0.

#include <dlfcn.h>
#include <fmt/format.h>

#include <climits>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

#include "solvers/peers/outside_call.h"

namespace lcp {
namespace {

/// Eigen::VectorXd and Eigen::MatrixXd, column by column, as they lie in memory.
struct OutsideVector {
  double* data = nullptr;
  Index rows = 0;
};
struct OutsideMatrix {
  double* data = nullptr;
  Index rows = 0, columns = 0;
};

/// dart::constraint::PgsBoxedLcpSolver as it lies in memory, with its work space.
struct OutsideGaussSeidel {
  void* virtual_functions = nullptr;  // solve() calls none.
  int max_iterations;
  double absolute_step;
  double relative_step;
  double smallest_diagonal;
  bool random_order;
  std::vector<int> order;
  std::vector<double> diagonal;
  OutsideVector normalised_A;
  OutsideMatrix normalised_B;
  OutsideVector z, old_x;
};

using Lemke = int (*)(const OutsideMatrix& M, const OutsideVector& q, OutsideVector* z);
using GaussSeidel = bool (*)(OutsideGaussSeidel*, int n, double* A, double* x, double* b, int nub,
                             double* low, double* high, int* friction, bool early);

template <class Function>
Function find(const char* symbol) {
  static void* const library = dlopen("libdart.so.6.12", RTLD_NOW | RTLD_LOCAL);
  return library ? reinterpret_cast<Function>(dlsym(library, symbol)) : nullptr;
}

Lemke lemke_function() {
  static const auto function = find<Lemke>(
      "_ZN4dart9lcpsolver5LemkeERKN5Eigen6MatrixIdLin1ELin1ELi0ELin1ELin1EEERKNS2_"
      "IdLin1ELi1ELi0ELin1ELi1EEEPS6_");
  return function;
}

GaussSeidel gauss_seidel_function() {
  static const auto function =
      find<GaussSeidel>("_ZN4dart10constraint17PgsBoxedLcpSolver5solveEiPdS2_S2_iS2_S2_Pib");
  return function;
}

constexpr const char* not_loaded = "libdart.so.6.12 cannot be loaded (Debian package libdart6.12)";

struct Free {
  void operator()(double* data) const { std::free(data); }
};

OptionTable lemke_table(PeerOptions& options) {
  lemke_function();
  return {scale_option(options)};
}

Result lemke(const Problem& problem, const PeerOptions& options, const Call& call) {
  const Index n = problem.size();
  if (call.start) return refuse(problem, any_start(call));
  if (!lemke_function()) return refuse(problem, not_loaded);
  if (n == 0) return solved_empty();
  const ScaledProblem scaled(problem, options.scale);
  MatrixXd M = scaled.M();
  VectorXd q = scaled.q();
  OutsideVector answer;
  int error = 0;
  {
    const OutsideCall under_way("dart-lemke");
    error = lemke_function()({M.data(), n, n}, {q.data(), n}, &answer);
  }
  const std::unique_ptr<double, Free> owner(answer.data);
  VectorXd z = VectorXd::Zero(n);
  if (answer.rows == n) z = Eigen::Map<const VectorXd>(answer.data, n);
  const auto finish = [&](Claim claim, const char* message) {
    return outside_result(scaled, claim, message, z, VectorXd(), {});
  };
  switch (error) {
    case 0:
      return finish(Claim::solved, "");
    case 1:
      return finish(Claim::limit, "error 1: 1000 pivots");
    case 2:
      return finish(Claim::ray, "error 2: no pivot above 1e-8");
    case 3:
      return finish(Claim::singular, "error 3: the answer failed the library's check");
    default:
      return finish(Claim::singular, "error 4: the iteration diverged");
  }
}

struct GaussSeidelOptions : PeerOptions {
  Index max_sweeps = 10000;
  double tolerance = 1e-9;
  double symmetry = 1e-8;
};

OptionTable gauss_seidel_table(GaussSeidelOptions& options) {
  gauss_seidel_function();
  return {
      count("max_sweeps", options.max_sweeps, 1, INT_MAX, "sweeps before giving up (limit)"),
      real("tolerance", options.tolerance, 0, 1, "|dx / x| of every row at which the sweeps end")
          .accuracy({"1e-03", "1e-05", "1e-07", "1e-09", "1e-11"}),
      real("symmetry", options.symmetry, 0, 1,
           "largest |M - M'|, in max |M|, that counts as symmetric"),
      scale_option(options),
  };
}

Result gauss_seidel(const Problem& problem, const GaussSeidelOptions& options, const Call& call) {
  const Index n = problem.size();
  if (call.start) return refuse(problem, any_start(call));
  if (!gauss_seidel_function()) return refuse(problem, not_loaded);
  if (n == 0) return solved_empty();
  const ScaledProblem scaled(problem, options.scale);
  Obstacle obstacle = unsymmetric(scaled.M(), options.symmetry);
  if (obstacle.empty()) obstacle = no_positive_diagonal(scaled.M());
  if (!obstacle.empty()) return refuse(problem, obstacle);
  BoxedForm boxed(scaled, n > 1 ? (n + 3) / 4 * 4 : n);
  OutsideGaussSeidel solver{.max_iterations = static_cast<int>(options.max_sweeps),
                            .absolute_step = options.tolerance,
                            .relative_step = options.tolerance,
                            .smallest_diagonal = 1e-9,
                            .random_order = false,
                            .order = {},
                            .diagonal = {},
                            .normalised_A = {},
                            .normalised_B = {},
                            .z = {},
                            .old_x = {}};
  bool success = false;
  {
    const OutsideCall under_way("dart-pgs");
    success = gauss_seidel_function()(&solver, static_cast<int>(n), boxed.A.data(), boxed.x.data(),
                                      boxed.b.data(), 0, boxed.low.data(), boxed.high.data(),
                                      boxed.friction.data(), false);
  }
  for (double* data :
       {solver.normalised_A.data, solver.normalised_B.data, solver.z.data, solver.old_x.data})
    std::free(data);
  return outside_result(scaled, success ? Claim::solved : Claim::limit, "", std::move(boxed.x),
                        VectorXd(), {});
}

const Registration dart_lemke{
    {.name = "dart-lemke",
     .summary = "Lemke with a pivot tolerance, the basis factorised by QR at each pivot",
     .source = "DART, dart::lcpsolver::Lemke; Fackler and Miranda",
     .supports = "any M; n^3 a pivot, 1000 pivots",
     .outside_library = "DART " LCPBENCH_DART_VERSION,
     .outside_constants =
         "none can be set; in its body pivot 1e-8, ties 1e-5, 1000 pivots, its check "
         "1e-4, all absolute"},
    PeerOptions{},
    lemke_table,
    lemke};

const Registration dart_pgs{
    {.name = "dart-pgs",
     .summary = "projected Gauss-Seidel, ended by the size of its steps",
     .source = "DART, PgsBoxedLcpSolver",
     .kind = RowInfo::Kind::iterative,
     .supports = "a symmetric M with a positive diagonal",
     .outside_library = "DART " LCPBENCH_DART_VERSION,
     .outside_constants =
         "mDeltaXThreshold and mRelativeDeltaXTolerance = tolerance, mMaxIteration = "
         "max_sweeps, mEpsilonForDivision 1e-9 as it is"},
    GaussSeidelOptions{},
    gauss_seidel_table,
    gauss_seidel};

}  // namespace
}  // namespace lcp
