#include "solvers/linalg/start.h"

#include <gtest/gtest.h>

#include "solvers/linalg/natural_residual.h"
#include "solvers/registry.h"
#include "tests/solvers/cases.h"

namespace lcp {
namespace {

class ARowThatPivots : public testing::TestWithParam<std::string> {
 protected:
  Result solve(const Problem& problem, std::vector<Index> alpha, const std::string& options = "") {
    return make_solver(GetParam() + options)
        .solver->solve(problem, {Start{std::move(alpha)}, nullptr});
  }
};

TEST_P(ARowThatPivots, NeedsNoPivotFromTheRightBasis) {
  const Problem problem = cases::positive_definite(15, 8);
  const std::vector<Index> alpha = *make_solver("lemke").solver->solve(problem).basis;
  ASSERT_FALSE(alpha.empty());
  const Result result = solve(problem, alpha);
  EXPECT_EQ(result.claim, Claim::solved);
  EXPECT_EQ(result.work.pivots, 0);
  EXPECT_EQ(result.work.start_pivots, static_cast<Index>(alpha.size()));
  EXPECT_EQ(result.basis, alpha);
  VectorXd w;
  EXPECT_LT(natural_residual(problem, result.z, w), 1e-13);
}

TEST_P(ARowThatPivots, SolvesFromAnyUsableBasis) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Problem problem = cases::positive_definite(15, seed);
    const Result result = solve(problem, {0, 3, 9});
    VectorXd w;
    EXPECT_EQ(result.claim, Claim::solved) << seed;
    EXPECT_LT(natural_residual(problem, result.z, w), 1e-11) << seed;
  }
}

TEST_P(ARowThatPivots, TheCoveringVectorInOriginalRowsFitsTheStart) {
  const Problem problem = cases::positive_definite(15, 2);
  const std::string limit = GetParam().starts_with("best-first") ? ":max_nodes=1" : ":max_pivots=1";
  const Result result = solve(problem, {0, 3, 9}, limit);
  ASSERT_EQ(result.claim, Claim::limit);
  ASSERT_GT(result.z0, 0);
  const VectorXd error = result.w - problem.M * result.z - problem.q - result.z0 * result.covering;
  EXPECT_LT(error.lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST_P(ARowThatPivots, ClaimsSingularOnAnUnusableStartUnlessToldToRestart) {
  Problem problem = cases::example_4_4_7();  // M has a zero diagonal
  const Result refused = solve(problem, {0});
  EXPECT_EQ(refused.claim, Claim::singular);
  EXPECT_EQ(refused.message, "start not usable");
  EXPECT_EQ(refused.z.size(), 3);
  const Result restarted = solve(problem, {0}, ":restart=cold");
  EXPECT_EQ(restarted.claim, Claim::solved);
  EXPECT_EQ(restarted.work.restarts, 1);
}

TEST_P(ARowThatPivots, RestartsAsColdAndCountsTheFactorisationOfTheStartAsWell) {
  const Problem problem = cases::example_4_4_7();
  const Result cold = solve(problem, {}), refused = solve(problem, {0}),
               restarted = solve(problem, {0}, ":restart=cold");
  EXPECT_EQ(refused.work.factorisations, 1);
  EXPECT_EQ(restarted.work.factorisations, cold.work.factorisations + 1);
  EXPECT_EQ(restarted.work.pivots, cold.work.pivots);
  EXPECT_EQ(restarted.claim, cold.claim);
  EXPECT_EQ(restarted.basis, cold.basis);
}

TEST_P(ARowThatPivots, RefusesAStartThatIsNotASetOfRows) {
  const Problem problem = cases::example_4_4_7();
  EXPECT_THROW(solve(problem, {3}), std::invalid_argument);
  EXPECT_THROW(solve(problem, {-1}), std::invalid_argument);
  EXPECT_THROW(solve(problem, {1, 1}), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Start, ARowThatPivots,
                         testing::Values("lemke", "lexicographic", "lexicographic-pivot",
                                         "lemke-revised", "lexicographic-revised", "best-first",
                                         "best-first-lexicographic", "best-first-tableau"),
                         [](const auto& row) {
                           std::string name = row.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(CoveringOf, IsOneInThePivotedSystem) {
  const Problem problem = cases::positive_definite(5, 1);
  const ScaledProblem scaled(problem, false);
  const std::vector<Index> alpha = {1, 3}, rest = complement_of(alpha, 5);
  const VectorXd c = covering_of(scaled, alpha);
  const MatrixXd M_aa = problem.M(alpha, alpha);
  EXPECT_LT((c(alpha) + M_aa * VectorXd::Ones(2)).norm(), 1e-13);
  const VectorXd rest_column = c(rest) - problem.M(rest, alpha) * M_aa.inverse() * c(alpha);
  EXPECT_LT((rest_column - VectorXd::Ones(3)).norm(), 1e-12);
}

}  // namespace
}  // namespace lcp
