#include <gtest/gtest.h>

#include "solvers/registry.h"
#include "tests/solvers/cases.h"

namespace lcp {
namespace {

using cases::residual;
using cases::solve;

TEST(Lemke, SolvesAHandExampleInFivePivots) {
  for (const std::string row : {"lemke", "lexicographic", "lemke-revised", "best-first"}) {
    const Result result = solve(row, cases::example_4_4_7());
    EXPECT_EQ(result.claim, Claim::solved) << row;
    EXPECT_EQ(result.work.pivots, 5) << row;
    EXPECT_LT((result.z - Eigen::Vector3d(0, 1, 3)).norm(), 1e-12) << row;
    EXPECT_EQ(result.basis, (std::vector<Index>{1, 2})) << row;
  }
}

TEST(Lemke, TakesTwoToTheNPivotsOnMurtysFamily) {
  for (const Index n : {4, 8}) {
    const Problem problem = cases::murty(n);
    const Result result = solve("lemke", problem);
    EXPECT_EQ(result.claim, Claim::solved);
    EXPECT_EQ(result.work.pivots, Index{1} << n);
    EXPECT_EQ(result.z(0), std::ldexp(1.0, static_cast<int>(n)));
  }
}

TEST(Lemke, CyclesWhereTheLowestIndexBreaksTiesAndLexicographicOrderDoesNot) {
  EXPECT_EQ(solve("lemke", cases::kostreva()).claim, Claim::cycle);
  const Result result = solve("lexicographic", cases::kostreva());
  EXPECT_EQ(result.claim, Claim::solved);
  EXPECT_EQ(result.work.pivots, 4);
  EXPECT_LT((result.z - VectorXd::Constant(3, 1.0 / 3)).norm(), 1e-15);
}

TEST(Lemke, EndsOnARayWhenInfeasible) {
  const Problem problem = cases::plain(MatrixXd::Constant(1, 1, -1), VectorXd::Constant(1, -1));
  for (const std::string row :
       {"lemke", "lexicographic", "lemke-revised", "lexicographic-revised"}) {
    const Result result = solve(row, problem);
    EXPECT_EQ(result.claim, Claim::ray) << row;
    EXPECT_EQ(result.work.pivots, 1) << row;
  }
  EXPECT_EQ(solve("best-first", problem).claim, Claim::exhausted);
}

TEST(Lemke, GivesUpAtThePivotLimit) {
  const Result result = solve("lemke:max_pivots=7", cases::murty(4));
  EXPECT_EQ(result.claim, Claim::limit);
  EXPECT_EQ(result.work.pivots, 7);
  EXPECT_EQ(result.z.size(), 4);
}

TEST(Lemke, ReportsZ0AndTheCoveringVectorSoThatThePapersErrorCanBeComputed) {
  Problem problem = cases::positive_definite(15, 2);
  problem.c = VectorXd::LinSpaced(15, 1, 4);
  for (const std::string row : {"lemke:max_pivots=2", "lemke-revised:max_pivots=2"}) {
    const Result result = solve(row, problem);
    EXPECT_GT(result.z0, 0) << row;
    const VectorXd error =
        result.w - problem.M * result.z - problem.q - result.z0 * result.covering;
    EXPECT_LT(error.lpNorm<Eigen::Infinity>(), 1e-12) << row;
  }
}

TEST(Lemke, TableauAndFactorisedBasisTakeTheSamePath) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Problem problem = cases::positive_definite(25, seed);
    for (const std::string rule : {"lemke", "lexicographic"}) {
      std::vector<std::pair<int, int>> tableau, revised;
      const auto record = [](auto& path) {
        return
            [&path](const PivotEvent& event) { path.emplace_back(event.entering, event.leaving); };
      };
      const Result a = solve(rule + ":scale=on,pivot=1e-12", problem, {{}, record(tableau)});
      const Result b = solve(rule + "-revised:refactor_every=4", problem, {{}, record(revised)});
      EXPECT_EQ(tableau, revised) << rule << " seed " << seed;
      EXPECT_LT(residual(problem, a), 1e-12);
      EXPECT_LT(residual(problem, b), 1e-12);
    }
  }
}

TEST(Lemke, ScalingChangesNeitherSolutionNorUnits) {
  Problem problem = cases::positive_definite(12, 4);
  problem.q *= 1e6;
  problem.M *= 1e-3;
  set_plain_scales(problem);
  const Result plain = solve("lemke", problem), scaled = solve("lemke:scale=on", problem);
  EXPECT_LT((plain.z - scaled.z).norm(), 1e-9 * plain.z.norm());
  EXPECT_LT((plain.w - scaled.w).norm(), 1e-9 * plain.w.norm());
}

TEST(Lemke, ANumberThatOverflowsIsSingularWithADefinedZ) {
  // z = 1 / 1e-320 is beyond the largest double.
  const Problem problem = cases::plain(MatrixXd::Constant(1, 1, 1e-320), VectorXd::Constant(1, -1));
  const Result result = solve("lemke", problem);
  EXPECT_EQ(result.claim, Claim::singular);
  EXPECT_EQ(result.z, VectorXd(VectorXd::Zero(1)));
}

}  // namespace
}  // namespace lcp
