#include <fmt/format.h>
#include <gtest/gtest.h>

#include "solvers/registry.h"
#include "tests/solvers/cases.h"

namespace lcp {
namespace {

using cases::residual;
using cases::solve;

/// k copies of every row and column of a positive definite problem: M is singular and each row of
/// the original is tied k times.
Problem repeated(Index n, Index copies, unsigned seed) {
  const Problem small = cases::positive_definite(n, seed);
  return cases::plain(small.M.replicate(copies, copies), small.q.replicate(copies, 1));
}

TEST(BestFirst, TakesBackTheChoiceThatMakesTheLowestIndexRuleCycle) {
  for (const std::string row :
       {"best-first", "best-first-lexicographic", "best-first-tableau", "best-first-uniform"}) {
    const Result result = solve(row, cases::kostreva());
    EXPECT_EQ(result.claim, Claim::solved) << row;
    EXPECT_LT(residual(cases::kostreva(), result), 1e-12) << row;
  }
}

TEST(BestFirst, FollowsLemkesPathWhereNothingIsTied) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Problem problem = cases::positive_definite(30, seed);
    const Result lemke = solve("lemke:scale=on", problem), search = solve("best-first", problem);
    EXPECT_EQ(search.work.pivots, lemke.work.pivots);
    EXPECT_EQ(search.work.nodes, search.work.path);
    EXPECT_EQ(search.basis, lemke.basis);
  }
}

TEST(BestFirst, SolvesProblemsWhoseRowsAreRepeated) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Problem problem = repeated(6, 4, seed);
    for (const std::string row : {"best-first", "best-first-lexicographic"}) {
      const Result result = solve(row, problem);
      EXPECT_EQ(result.claim, Claim::solved) << row << " seed " << seed;
      EXPECT_LT(residual(problem, result), 1e-12) << row << " seed " << seed;
    }
  }
}

TEST(BestFirst, OpensNoBasisTwiceWithTheSameDrivingVariable) {
  const Problem problem = repeated(5, 3, 2);
  std::set<std::pair<std::vector<int>, int>> seen;
  const auto watch = [&seen](const PivotEvent& event) {
    std::vector<int> basic = *event.basic;
    std::sort(basic.begin(), basic.end());
    EXPECT_TRUE(seen.emplace(basic, event.leaving).second);
  };
  solve("best-first-uniform:max_nodes=500", problem, {{}, watch});
  EXPECT_GT(seen.size(), 20U);
}

TEST(BestFirst, ThePrintedCostSearchesBreadthFirst) {
  const Problem problem = repeated(6, 4, 1);
  EXPECT_GT(solve("best-first-uniform", problem).work.nodes,
            4 * solve("best-first", problem).work.nodes);
}

TEST(BestFirst, ATableauReturnsToAbandonedBranchesByRepeatingTheirPivots) {
  const Problem problem = repeated(5, 3, 1);
  const Result result = solve("best-first-tableau:cost=printed", problem);
  EXPECT_EQ(result.claim, Claim::solved);
  EXPECT_GT(result.work.replayed, 0);
}

TEST(BestFirst, StopsAtTheNodeLimit) {
  const Result result = solve("best-first:max_nodes=3", cases::murty(4));
  EXPECT_EQ(result.claim, Claim::limit);
  EXPECT_EQ(result.work.nodes, 3);
}

TEST(BestFirst, AllAttemptsTogetherOpenNoMoreThanMaxNodes) {
  // Murty's problem of order 6 takes 63 pivots, more than any of these limits.
  for (const Index patience : {0, 1, 3, 4, 7})
    for (const Index max_nodes : {1, 3, 4, 10, 13, 30}) {
      const Result result = solve(
          fmt::format("best-first:patience={},max_nodes={}", patience, max_nodes), cases::murty(6));
      EXPECT_EQ(result.claim, Claim::limit) << patience << " " << max_nodes;
      EXPECT_EQ(result.work.nodes, max_nodes) << patience;
      EXPECT_EQ(result.message, fmt::format("max_nodes={} reached", max_nodes)) << patience;
    }
}

TEST(BestFirst, OpensNoMoreNodesThanAllAttemptsMayOnceTheyAllEndEmptyHanded) {
  // e_max = 0 ends every branch at its first node or soon after, in each attempt anew.
  const Problem problem = cases::positive_definite(20, 1);
  const Result all = solve("best-first:e_max=0", problem);
  ASSERT_GT(all.work.restarts, 0);
  for (Index max_nodes = 1; max_nodes < all.work.nodes; ++max_nodes)
    EXPECT_LE(solve(fmt::format("best-first:e_max=0,patience=1,max_nodes={}", max_nodes), problem)
                  .work.nodes,
              max_nodes);
}

TEST(BestFirst, AColdStartIsNoSolutionWhileAnyQIsNegative) {
  // q = -5e-10 is within epsilon, yet z = 0 is not the solution.
  const Problem problem = cases::plain(MatrixXd::Identity(2, 2), Eigen::Vector2d(-5e-10, 1));
  for (const std::string row : {"best-first:scale=off", "best-first-tableau"}) {
    const Result cold = solve(row, problem);
    EXPECT_EQ(cold.claim, Claim::solved) << row;
    EXPECT_GT(cold.work.pivots, 0) << row;
    EXPECT_EQ(cold.z, Eigen::Vector2d(5e-10, 0)) << row;
  }
}

TEST(BestFirst, AStartingBasisIsTheSolutionUpToEpsilon) {
  const Problem problem = cases::plain(MatrixXd::Identity(2, 2), Eigen::Vector2d(-5e-10, -1));
  const auto from_row_1 = [&problem](const std::string& row) {
    return solve(row, problem, {Start{{1}}, nullptr});
  };
  const Result within = from_row_1("best-first:scale=off,epsilon=1e-9");
  EXPECT_EQ(within.claim, Claim::solved);
  EXPECT_EQ(within.work.pivots, 0);
  EXPECT_EQ(within.basis, std::vector<Index>{1});
  EXPECT_GT(from_row_1("best-first:scale=off,epsilon=1e-10").work.pivots, 0);
}

TEST(BestFirst, LooksAtQAgainOnceTheBasisOfANodeIsFactorised) {
  // d in 1 + d is far above the rounding of 1, d 2^-20 far below it. The basis {0, 1} is nearly
  // singular: z_0 = z_1 = 2 / d, and w_2 = -2 + (1 - 2^-20) 2 = -2^-19. In the numbers of the node
  // before, rows 0 and 2 are tied to the last bit and w_2 is 0, so that z0 leaves; and the basic
  // solution satisfies w = M z + q to the last bit. The solution is {0, 1, 2}, with z_2 = 2^-19.
  const double d = 0x1p-36;
  const MatrixXd M{{1 + d, -1, 0}, {-1, 1 + d, 0}, {d * (1 - 0x1p-20), 0, 1}};
  const Problem problem = cases::plain(M, VectorXd::Constant(3, -2));
  for (const std::string row : {"best-first", "best-first:scale=off", "best-first:polish=off"}) {
    const Result result = solve(row + (row == "best-first" ? ":" : ",") + "patience=0", problem);
    ASSERT_EQ(result.claim, Claim::solved) << row;
    EXPECT_EQ(result.basis, (std::vector<Index>{0, 1, 2})) << row;
    EXPECT_LT(residual(problem, result), 1e-12) << row;
    EXPECT_GT(result.work.nodes, result.work.path) << row << ": a branch ended";
  }
}

TEST(BestFirst, Step0MayBranch) {
  // Two rows tie for the least q; branching queues both.
  MatrixXd M = MatrixXd::Identity(2, 2);
  const Problem problem = cases::plain(M, Eigen::Vector2d(-1, -1));
  const Result one = solve("best-first", problem), both = solve("best-first:step0=branch", problem);
  EXPECT_EQ(one.claim, Claim::solved);
  EXPECT_EQ(both.claim, Claim::solved);
  EXPECT_EQ(both.work.generated, one.work.generated + 1);
}

TEST(BestFirst, PolishingImprovesWhatRoundingLeft) {
  const Problem problem = cases::positive_definite(40, 11);
  const double rough =
      residual(problem, solve("best-first:polish=off,refactor_every=1000", problem));
  const double fine = residual(problem, solve("best-first:refactor_every=1000", problem));
  EXPECT_LT(fine, rough);
  EXPECT_LT(fine, 1e-15);
}

TEST(BestFirst, TheErrorOfANodeIsChecked) {
  const Problem problem = cases::positive_definite(20, 1);
  EXPECT_EQ(solve("best-first:e_max=0", problem).claim, Claim::exhausted);
}

}  // namespace
}  // namespace lcp
