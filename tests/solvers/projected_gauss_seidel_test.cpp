#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "solvers/registry.h"
#include "tests/solvers/cases.h"

namespace lcp {
namespace {

Result solve(const Problem& problem, const std::string& settings = "", const Call& call = {}) {
  return make_solver("projected-gauss-seidel" + settings).solver->solve(problem, call);
}

/// One contact with W = I / 2 and directions +t1, +t2, -t1, -t2: the LCP (25) written out.
Problem one_contact(double mu, const Eigen::Vector3d& vbar) {
  Problem problem;
  problem.M.resize(6, 6);
  problem.M << 0.5, 0, 0, 0, 0, 0,  //
      0, 0.5, 0, -0.5, 0, 1,        //
      0, 0, 0.5, 0, -0.5, 1,        //
      0, -0.5, 0, 0.5, 0, 1,        //
      0, 0, -0.5, 0, 0.5, 1,        //
      mu, -1, -1, -1, -1, 0;
  problem.q = VectorXd{{vbar(0), vbar(1), vbar(2), -vbar(1), -vbar(2), 0}};
  problem.s_z = problem.s_w = VectorXd::Ones(6);
  FrictionBlocks& blocks = problem.friction.emplace();
  blocks.W = 0.5 * MatrixXd::Identity(3, 3);
  blocks.vbar = vbar;
  blocks.mu = VectorXd::Constant(1, mu);
  blocks.directions = MatrixXd{{1, 0, -1, 0}, {0, 1, 0, -1}};
  blocks.directions_per_contact = 4;
  blocks.normal_row = {0};
  blocks.friction_row = {1};
  blocks.cone_row = {5};
  return problem;
}

TEST(ProjectedGaussSeidel, SolvesAPositiveDefiniteProblemToItsTolerance) {
  const Problem problem = cases::positive_definite(20, 1);
  const Result result = solve(problem, ":tolerance=1e-10");
  ASSERT_EQ(result.claim, Claim::solved);
  const VectorXd w = problem.M * result.z + problem.q;
  EXPECT_LE(result.z.cwiseQuotient(problem.s_z)
                .cwiseMin(w.cwiseQuotient(problem.s_w))
                .lpNorm<Eigen::Infinity>(),
            1e-10);
  EXPECT_GT(result.work.sweeps, 0);
  EXPECT_EQ(result.work.pivots, 0);
  EXPECT_FALSE(result.basis);
}

TEST(ProjectedGaussSeidel, NeedsNoSweepWhereZeroIsTheSolution) {
  const Result result = solve(cases::plain(MatrixXd::Identity(2, 2), Eigen::Vector2d(0, 3)));
  EXPECT_EQ(result.claim, Claim::solved);
  EXPECT_EQ(result.work.sweeps, 0);
  EXPECT_EQ(result.z, Eigen::Vector2d::Zero());
}

TEST(ProjectedGaussSeidel, AContactThatSticksIsStopped) {
  // f = -vbar / 0.5 = (2, -0.6, 0).
  const Result result = solve(one_contact(0.5, {-1, 0.3, 0}));
  ASSERT_EQ(result.claim, Claim::solved);
  EXPECT_LT((result.z - VectorXd{{2, 0, 0, 0.6, 0, 0}}).norm(), 1e-8);
}

TEST(ProjectedGaussSeidel, AContactThatSlidesIsHeldBackByTheWholeCone) {
  // Along t1 friction 0.2 * 2 slows 3 m/s by 0.2 m/s.
  const Result result = solve(one_contact(0.2, {-1, 3, 0}));
  ASSERT_EQ(result.claim, Claim::solved);
  EXPECT_LT((result.z - VectorXd{{2, 0, 0, 0.4, 0, 2.8}}).norm(), 1e-8);
}

TEST(ProjectedGaussSeidel, SlidingBetweenTwoDirectionsIsSharedByBoth) {
  // The velocity (0.3, 0.25) - f_t / 2 is normal to the polygon's edge b_3 + b_4 = 0.4, where
  // b_3 - b_4 = 0.1: b = (.., 0.25, 0.15), slip 0.175 m/s along both directions.
  const Result result = solve(one_contact(0.2, {-1, 0.3, 0.25}));
  ASSERT_EQ(result.claim, Claim::solved);
  EXPECT_LT((result.z - VectorXd{{2, 0, 0, 0.25, 0.15, 0.175}}).norm(), 1e-7);
}

TEST(ProjectedGaussSeidel, ReadsAnUnsymmetricWByRows) {
  // The normal force drags along t1, friction does nothing to the normal velocity:
  // f_n = 2, f_t = -(0.3 + 0.1 * 2) / 0.5 = -1.
  Problem problem = one_contact(0.9, {-1, 0.3, 0});
  problem.friction->W(1, 0) = 0.1;
  problem.M(1, 0) = 0.1;
  problem.M(3, 0) = -0.1;
  const Result result = solve(problem);
  ASSERT_EQ(result.claim, Claim::solved);
  EXPECT_LT((result.z - VectorXd{{2, 0, 0, 1, 0, 0}}).norm(), 1e-8);
}

TEST(ProjectedGaussSeidel, AContactThatOpensHasNoForce) {
  const Result result = solve(one_contact(0.5, {0.1, 0.3, 0}));
  ASSERT_EQ(result.claim, Claim::solved);
  EXPECT_LT((result.z - VectorXd{{0, 0, 0, 0, 0, 0.3}}).norm(), 1e-12);
}

TEST(ProjectedGaussSeidel, ClaimsSolvedByTheLcpAndNotByItsBlocks) {
  Problem problem = one_contact(0.5, {-1, 0.3, 0});
  problem.q(0) = -3;  // not the vbar of the blocks
  const Result result = solve(problem, ":max_sweeps=30");
  EXPECT_EQ(result.claim, Claim::limit);
  EXPECT_EQ(result.work.sweeps, 30);
}

TEST(ProjectedGaussSeidel, ReturnsItsLastIterateAtTheLimit) {
  const Result result = solve(cases::positive_definite(20, 1), ":max_sweeps=3,tolerance=0");
  EXPECT_EQ(result.claim, Claim::limit);
  EXPECT_EQ(result.work.sweeps, 3);
  EXPECT_TRUE(result.z.allFinite());
  EXPECT_GT(result.z.maxCoeff(), 0);
}

TEST(ProjectedGaussSeidel, IsSingularWhenTheIteratesOverflow) {
  MatrixXd M(2, 2);
  M << 1, -1e200, -1e200, 1;
  const Result result = solve(cases::plain(M, Eigen::Vector2d(-1, -1)));
  EXPECT_EQ(result.claim, Claim::singular);
  EXPECT_TRUE(result.z.allFinite());
  EXPECT_EQ(result.z.size(), 2);
}

TEST(ProjectedGaussSeidel, DoesNotSupportADiagonalThatIsNotPositive) {
  MatrixXd M = MatrixXd::Identity(2, 2);
  M(1, 1) = 0;
  const Result plain = solve(cases::plain(M, Eigen::Vector2d(-1, -1)));
  EXPECT_EQ(plain.claim, Claim::unsupported);
  EXPECT_EQ(plain.message, "needs a positive diagonal, M(1, 1) is 0");
  EXPECT_EQ(plain.z, Eigen::Vector2d::Zero());

  Problem stuck = one_contact(0.5, {-1, 0.3, 0});
  stuck.friction->W(0, 0) = 0;
  EXPECT_EQ(solve(stuck).claim, Claim::unsupported);
  stuck = one_contact(0.5, {-1, 0.3, 0});
  stuck.friction->W.bottomRightCorner<2, 2>().setZero();
  EXPECT_EQ(solve(stuck).claim, Claim::unsupported);
}

TEST(ProjectedGaussSeidel, FromItsOwnSolutionNeedsNoSweep) {
  for (const Problem& problem : {cases::positive_definite(20, 1), one_contact(0.5, {-1, 0.3, 0}),
                                 one_contact(0.1, {-1, 2, 1})}) {
    const Result cold = solve(problem, ":tolerance=1e-12,check_every=1");
    ASSERT_EQ(cold.claim, Claim::solved);
    ASSERT_GT(cold.work.sweeps, 0);
    const Call call{.start = Start{.alpha = {0}, .z = cold.z}, .observer = {}};
    const Result warm = solve(problem, ":tolerance=1e-11", call);
    EXPECT_EQ(warm.claim, Claim::solved);
    EXPECT_EQ(warm.work.sweeps, 0);
    EXPECT_LT((warm.z - cold.z).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(ProjectedGaussSeidel, FromZeroIsTheColdSolve) {
  const Problem problem = one_contact(0.5, {-1, 0.3, 0});
  const Call call{.start = Start{.alpha = {}, .z = VectorXd::Zero(6)}, .observer = {}};
  const Result cold = solve(problem), warm = solve(problem, "", call);
  EXPECT_EQ(warm.z, cold.z);
  EXPECT_EQ(warm.work.sweeps, cold.work.sweeps);
}

TEST(ProjectedGaussSeidel, RefusesAPointOfAnotherSizeOrNotFinite) {
  const Problem problem = cases::positive_definite(3, 1);
  for (const VectorXd& z :
       {VectorXd(VectorXd::Zero(2)),
        VectorXd(VectorXd::Constant(3, std::numeric_limits<double>::infinity()))})
    EXPECT_THROW(solve(problem, "", {.start = Start{.alpha = {}, .z = z}, .observer = {}}),
                 std::invalid_argument);
}

TEST(ProjectedGaussSeidel, TakesNoStartingBasisWithoutAPoint) {
  Call call;
  call.start = Start{{0}};
  const Result result = solve(cases::positive_definite(3, 1), "", call);
  EXPECT_EQ(result.claim, Claim::unsupported);
  EXPECT_EQ(result.message, "takes no starting basis");
  EXPECT_EQ(result.z, Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace lcp
