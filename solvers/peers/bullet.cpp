// Bullet's Lemke (btLemkeAlgorithm) and its Dantzig kernel (btSolveDantzigLCP), double precision.
//
// Source    Bullet Physics, MLCPSolvers; Lemke after J. Lloyd, from MBSim; Dantzig from ODE, D.
//           Baraff 1994.
// Lemke     w = Mz + q with our sign; the answer is [w; z]; `getInfo` 0 is its word for success, and
//           it does not look whether it stands on a ray. Lexicographic comparison row by row, O(n^3)
//           a pivot: minutes at n = 160. Nothing can be set but maxloops = Problem::max_pivots(); in
//           its body: machine epsilon, and an absolute 1e30 as the largest ratio.
// Dantzig   A x = b + w, so b = -q, bounds 0 and infinity, no friction indices; A row by row and
//           destroyed. It uses one triangle of A only: M must be symmetric. Nothing can be set.
//           False when a pivot fails; a true is not checked. Its error flag is a global of the
//           library.

#include <BulletDynamics/MLCPSolvers/btDantzigLCP.h>
#include <BulletDynamics/MLCPSolvers/btLemkeAlgorithm.h>
#include <fmt/format.h>

#include <algorithm>
#include <climits>

#include "solvers/peers/outside_call.h"

namespace lcp {
namespace {

static_assert(sizeof(btScalar) == sizeof(double), "the libraries linked are the double ones");

const std::string library =
    fmt::format("Bullet {}.{}", BT_BULLET_VERSION / 100, BT_BULLET_VERSION % 100);

OptionTable lemke_table(PeerOptions& options) { return {scale_option(options)}; }

Result lemke(const Problem& problem, const PeerOptions& options, const Call& call) {
  const Index n = problem.size();
  if (call.start) return refuse(problem, any_start(call));
  if (n == 0) return solved_empty();
  const ScaledProblem scaled(problem, options.scale);
  const int size = static_cast<int>(n);
  btMatrixXu M(size, size);
  btVectorXu q(size);
  for (int i = 0; i < size; ++i) {
    q[i] = scaled.q()(i);
    for (int j = 0; j < size; ++j) M.setElem(i, j, scaled.M()(i, j));
  }
  VectorXd z(n), w(n);
  Work work;
  const unsigned loops = static_cast<unsigned>(std::min<Index>(problem.max_pivots(), UINT_MAX));
  bool success = false;
  {
    const OutsideCall under_way("bullet-lemke");
    btLemkeAlgorithm algorithm(M, q);
    const btVectorXu answer = algorithm.solve(loops);
    success = algorithm.getInfo() == 0;
    work.pivots = algorithm.getSteps();
    for (int i = 0; i < size; ++i) {
      w(i) = answer[i];
      z(i) = answer[size + i];
    }
  }
  if (success) return outside_result(scaled, Claim::solved, "", z, w, work);
  return outside_result(scaled, work.pivots >= loops ? Claim::limit : Claim::singular,
                        fmt::format("info -1 after {} loops", work.pivots), z, w, work);
}

struct DantzigOptions : PeerOptions {
  double symmetry = 1e-8;
};

OptionTable dantzig_table(DantzigOptions& options) {
  return {
      real("symmetry", options.symmetry, 0, 1,
           "largest |M - M'|, in max |M|, that counts as symmetric"),
      scale_option(options),
  };
}

Result dantzig(const Problem& problem, const DantzigOptions& options, const Call& call) {
  const Index n = problem.size();
  if (call.start) return refuse(problem, any_start(call));
  if (n == 0) return solved_empty();
  const ScaledProblem scaled(problem, options.scale);
  const Obstacle obstacle = unsymmetric(scaled.M(), options.symmetry);
  if (!obstacle.empty()) return refuse(problem, obstacle);
  BoxedForm boxed(scaled, n);
  bool success = false;
  {
    const OutsideCall under_way("bullet-dantzig");
    btDantzigScratchMemory scratch;
    success =
        btSolveDantzigLCP(static_cast<int>(n), boxed.A.data(), boxed.x.data(), boxed.b.data(),
                          boxed.w.data(), 0, boxed.low.data(), boxed.high.data(), nullptr, scratch);
  }
  return outside_result(scaled, success ? Claim::solved : Claim::singular,
                        success ? "" : "false: a pivot failed", std::move(boxed.x),
                        std::move(boxed.w), {});
}

const Registration bullet_lemke{
    {.name = "bullet-lemke",
     .summary = "Lemke with lexicographic comparison of whole rows, on a tableau",
     .source = "Bullet, btLemkeAlgorithm; Lloyd 2005",
     .supports = "any M; O(n^3) a pivot",
     .outside_library = library,
     .outside_constants = "none can be set; machine epsilon and 1e30 in its body, no ray test"},
    PeerOptions{},
    lemke_table,
    lemke};

const Registration bullet_dantzig{
    {.name = "bullet-dantzig",
     .summary = "Dantzig's principal pivoting, row after row, on an updated LDL'",
     .source = "Bullet, btSolveDantzigLCP, from ODE; Baraff 1994",
     .supports = "a symmetric M",
     .outside_library = library,
     .outside_constants = "none can be set"},
    DantzigOptions{},
    dantzig_table,
    dantzig};

}  // namespace
}  // namespace lcp
