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
