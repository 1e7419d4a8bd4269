// Siconos Numerics: eight of its LCP solvers, dense, through linearComplementarity_driver.
//
// Source    V. Acary et al., Siconos, INRIA; LCP_Solvers.h, lcp_cst.h. Same sign as ours, w = Mz +
//           q; M column by column; solvers may write into M and q, so they get copies.
// Stops     at ||min(z, w)||_2 / ||q||_2 <= dparam[SICONOS_DPARAM_TOL], our `tolerance`. The driver
//           checks every answer of a solver that reports success against the same bound (filterOn,
//           its default). Each of these tests asks whether the error is *greater*, so NaN passes.
//           1e-7 as default: tighter ones cost the Newton rows answers that are good to 1e-6, looser
//           ones let through some that are not.
// Limits    iparam[SICONOS_IPARAM_MAX_ITER]: Problem::max_pivots() for the rows that pivot.
// Not asked n = 1: the driver itself answers z = -q / M whatever the signs.
// In body   lexicographic Lemke: any entry > 0 is a pivot, ties only on bitwise equal ratios,
//           columns compared with eps max |M|. Murty's rule: pivots below eps (2.2e-16) end it, rows
//           count as negative below -eps. Newton, Fischer-Burmeister: line search down to alpha =
//           1e-16. Newton, min: starts from z = w = 1, rho_i = 1 / M_ii.
// BLAS      One thread, so that it neither takes other cores nor sums in another order. Which
//           kernels OpenBLAS uses depends on the processor, and so may a last bit of the Newton
//           rows.

#include <LinearComplementarityProblem.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <lcp_cst.h>
#include <lcp_pivot.h>

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <memory>

#include "solvers/peers/outside_call.h"

namespace lcp {
namespace {

struct SiconosOptions : PeerOptions {
  double tolerance = 1e-7;
  Index max_iterations = 0;  ///< 0: the row pivots, and Problem::max_pivots() holds.
  double rho = 1;            ///< RPGS only.
};

OptionTable pivoting_table(SiconosOptions& options) {
  return {
      real("tolerance", options.tolerance, 0, 1,
           "||min(z, w)||_2 / ||q||_2 up to which an answer passes the library's own check")
          .accuracy({"1e-03", "1e-05", "1e-07", "1e-09", "1e-11"}),
      scale_option(options),
  };
}

OptionTable iterative_table(SiconosOptions& options) {
  OptionTable table = {
      real("tolerance", options.tolerance, 0, 1,
           "||min(z, w)||_2 / ||q||_2 at which the iteration ends")
          .accuracy({"1e-03", "1e-05", "1e-06", "1e-07", "1e-08", "1e-09", "1e-11"}),
      count("max_iterations", options.max_iterations, 1, 1000000000,
            "iterations before giving up (limit)"),
      scale_option(options),
  };
  return table;
}

OptionTable regularised_table(SiconosOptions& options) {
  OptionTable table = iterative_table(options);
  table.push_back(real("rho", options.rho, 0, 1e12,
                       "added to the diagonal as a proximal term, in means of M_ii"));
  return table;
}

/// OpenBLAS with one thread, where it is the BLAS.
void use_one_thread() {
  static const auto set_threads =
      reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  if (set_threads) set_threads(1);
}

int clamped(Index value) { return static_cast<int>(std::min<Index>(value, INT_MAX)); }

struct Ending {
  Claim claim;
  std::string message;
};

/// What the driver's return value means, by solver.
using Meaning = Ending (*)(int info, Index done, Index allowed);

Ending solved_or(int info, const Ending& failure) {
  return info == 0 ? Ending{Claim::solved, ""} : failure;
}

/// Lemke and Cao-Ferris: 1 for the limit, a ray, and an answer that the driver's check refused.
Ending lemke_ending(int info, Index done, Index allowed) {
  if (info != 0 && done >= allowed) return {Claim::limit, ""};
  return solved_or(info,
                   {Claim::ray, fmt::format("info {} after {} pivots: a ray, or an answer that "
                                            "failed the library's check",
                                            info, done)});
}

/// Murty's rule and path search: codes of lcp_pivot.h.
Ending pivot_ending(int info, Index done, Index allowed) {
  switch (info) {
    case LCP_PIVOT_SUCCESS:
      return {Claim::solved, ""};
    case LCP_PIVOT_NUL:
      return {Claim::singular, "info 2: a pivot below 2.2e-16"};
    case LCP_PATHSEARCH_LEAVING_T:
      return {Claim::ray, "info 3: the path turned back"};
    case LCP_PIVOT_RAY_TERMINATION:
      return {Claim::ray, "info 4: nothing blocks the driving variable"};
    case LCP_PATHSEARCH_NON_ENTERING_T:
      return {Claim::singular, "info 5: the path could not begin"};
    default:
      if (done >= allowed) return {Claim::limit, ""};
      return {Claim::singular, fmt::format("info {}: the answer failed the library's check", info)};
  }
}

/// Newton rows and RPGS: 1 for the limit, 2 for a linear system or diagonal that cannot be used.
Ending iterative_ending(int info, Index done, Index allowed) {
  if (info == 1 || (info != 0 && done >= allowed))
    return {Claim::limit, fmt::format("info {} after {} iterations", info, done)};
  return solved_or(info, {Claim::singular, fmt::format("info {}: no usable step", info)});
}

/// One of the library's solvers, and what this file must know of it.
struct Method {
  const char* row;
  int id;
  Meaning meaning;
  Obstacle (*obstacle)(const MatrixXd& M) = nullptr;
  bool takes_point = false;  ///< Starts from the z it is given.
};

struct Release {
  void operator()(SolverOptions* options) const {
    solver_options_delete(options);
    std::free(options);
  }
  void operator()(NumericsMatrix* matrix) const {
    matrix->matrix0 = nullptr;  // It is an Eigen matrix's.
    NM_clear(matrix);
    std::free(matrix);
  }
};

Result solve(const Method& method, const Problem& problem, const SiconosOptions& options,
             const Call& call) {
  const Index n = problem.size();
  if (call.start && !method.takes_point) return refuse(problem, any_start(call));
  if (call.start && call.start->z.size() != n)
    return refuse(problem, "takes a starting point, not a basis alone");
  if (n == 0) return solved_empty();
  const ScaledProblem scaled(problem, options.scale);
  if (method.obstacle) {
    const Obstacle obstacle = method.obstacle(scaled.M());
    if (!obstacle.empty()) return refuse(problem, obstacle);
  }

  MatrixXd M = scaled.M();
  VectorXd q = scaled.q();
  VectorXd z = VectorXd::Zero(n), w = VectorXd::Zero(n);
  if (call.start) z = options.scale ? call.start->z.cwiseQuotient(problem.s_z) : call.start->z;
  const Index allowed = options.max_iterations > 0 ? options.max_iterations : problem.max_pivots();
  use_one_thread();
  int info = 0;
  Work work;
  Index done = 0;
  {
    const OutsideCall under_way(method.row);
    const std::unique_ptr<NumericsMatrix, Release> matrix(
        NM_create_from_data(NM_DENSE, static_cast<int>(n), static_cast<int>(n), M.data()));
    const std::unique_ptr<SolverOptions, Release> settings(solver_options_create(method.id));
    settings->iparam[SICONOS_IPARAM_MAX_ITER] = clamped(allowed);
    settings->dparam[SICONOS_DPARAM_TOL] = options.tolerance;
    if (method.id == SICONOS_LCP_RPGS)
      settings->dparam[SICONOS_LCP_DPARAM_RHO] = options.rho * M.diagonal().mean();
    LinearComplementarityProblem lcp{static_cast<int>(n), matrix.get(), q.data()};
    info = linearComplementarity_driver(&lcp, z.data(), w.data(), settings.get());
    done = settings->iparam[SICONOS_IPARAM_ITER_DONE];
  }
  (options.max_iterations > 0 ? work.sweeps : work.pivots) = done;
  const Ending ending = method.meaning(info, done, allowed);
  return outside_result(scaled, ending.claim, ending.message, std::move(z), std::move(w), work);
}

RowInfo about(const char* name, const char* summary, const char* source, RowInfo::Kind kind,
              const char* supports, const char* constants) {
  return {.name = name,
          .summary = summary,
          .source = source,
          .kind = kind,
          .supports = supports,
          .outside_library = "Siconos " LCPBENCH_SICONOS_VERSION,
          .outside_constants = constants};
}

auto runs(const Method& method) {
  return [method](const Problem& problem, const SiconosOptions& options, const Call& call) {
    return solve(method, problem, options, call);
  };
}

constexpr auto pivoting = RowInfo::Kind::pivoting;
constexpr auto iterative = RowInfo::Kind::iterative;

SiconosOptions iterations(Index limit) {
  SiconosOptions options;
  options.max_iterations = limit;
  return options;
}

/// In the problem's own units this row solves more than scaled; the others solve as many or fewer
/// (results/peers, results/peers-sweep).
SiconosOptions unscaled() {
  SiconosOptions options;
  options.scale = false;
  return options;
}

const Registration lexicographic_lemke{
    about("siconos-lexicographic-lemke", "Lemke with lexicographic ties, on a tableau",
          "Siconos, lcp_lexicolemke; Cottle, Pang, Stone 1992", pivoting, "any M",
          "dparam[TOL] = tolerance; no pivot tolerance, ties only on bitwise equal ratios"),
    unscaled(), pivoting_table,
    runs({"siconos-lexicographic-lemke", SICONOS_LCP_LEMKE, lemke_ending})};

const Registration cao_ferris{
    about("siconos-cao-ferris", "the LCP as an affine variational inequality, by pivoting",
          "Siconos, lcp_avi_caoferris; Cao and Ferris 1996", pivoting, "any M",
          "dparam[TOL] = tolerance; no pivot tolerance, ties only on bitwise equal ratios"),
    SiconosOptions{}, pivoting_table,
    runs({"siconos-cao-ferris", SICONOS_LCP_AVI_CAOFERRIS, lemke_ending})};

const Registration murty{
    about("siconos-murty", "Murty's least-index principal pivoting",
          "Siconos, lcp_pivot; Murty 1988", pivoting, "any M; ends for P-matrices",
          "dparam[TOL] = tolerance; pivots and negative rows by machine epsilon in its body"),
    SiconosOptions{}, pivoting_table, runs({"siconos-murty", SICONOS_LCP_MURTY, pivot_ending})};

const Registration path_search{
    about("siconos-pathsearch", "the pivotal path search of PATH, from a point",
          "Siconos, lcp_pathsearch, which calls itself a test; Ralph 1994", pivoting,
          "any M; takes a starting point",
          "dparam[TOL] = tolerance; no pivot tolerance, ties only on bitwise equal ratios"),
    SiconosOptions{}, pivoting_table,
    runs({"siconos-pathsearch", SICONOS_LCP_PATHSEARCH, pivot_ending, nullptr, true})};

const Registration newton_fischer_burmeister{
    about("siconos-newton-fb", "Newton on the Fischer-Burmeister function, with a line search",
          "Siconos, lcp_newton_FB; De Luca, Facchinei, Kanzow 1996", iterative,
          "any M; takes a starting point",
          "dparam[TOL] = tolerance, iparam[MAX_ITER] = max_iterations; line search to 1e-16"),
    iterations(1000), iterative_table,
    runs({"siconos-newton-fb", SICONOS_LCP_NEWTON_FB_FBLSA, iterative_ending, nullptr, true})};

const Registration newton_min_fischer_burmeister{
    about("siconos-newton-minfb",
          "Newton on min(z, w) with descent measured by the Fischer-Burmeister function",
          "Siconos, lcp_newton_minFB; Facchinei and Pang 2003", iterative,
          "any M; takes a starting point",
          "dparam[TOL] = tolerance, iparam[MAX_ITER] = max_iterations; line search to 1e-16"),
    iterations(1000), iterative_table,
    runs({"siconos-newton-minfb", SICONOS_LCP_NEWTON_MIN_FBLSA, iterative_ending, nullptr, true})};

const Registration newton_min{
    about("siconos-newton-min", "Newton on min(z, w), without a line search",
          "Siconos, lcp_newton_min", iterative, "a positive diagonal, which it divides by",
          "dparam[TOL] = tolerance, iparam[MAX_ITER] = max_iterations"),
    iterations(1000), iterative_table,
    runs({"siconos-newton-min", SICONOS_LCP_NEWTONMIN, iterative_ending, no_positive_diagonal})};

const Registration regularised_gauss_seidel{
    about(
        "siconos-rpgs", "projected Gauss-Seidel with a proximal term for zeros on the diagonal",
        "Siconos, lcp_rpgs", iterative, "a diagonal >= 0; takes a starting point",
        "dparam[TOL] = tolerance, iparam[MAX_ITER] = max_iterations, dparam[RHO] = rho mean(M_ii); "
        "every sweep ends with the residual, n^2"),
    iterations(10000), regularised_table,
    runs({"siconos-rpgs", SICONOS_LCP_RPGS, iterative_ending, negative_diagonal, true})};

}  // namespace
}  // namespace lcp
