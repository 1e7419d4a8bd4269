#include "solvers/linalg/polish.h"

#include <gtest/gtest.h>

#include "tests/solvers/cases.h"

namespace lcp {
namespace {

/// `result` after polishing on its basis, unscaled.
Result polished(const Problem& problem, Result result) {
  const ScaledProblem scaled(problem, false);
  Basis basis(scaled, *result.basis, {});
  polish(problem, scaled, basis, result);
  return result;
}

Result rough(VectorXd z, std::vector<Index> alpha) {
  Result result;
  result.z = std::move(z);
  result.basis = std::move(alpha);
  return result;
}

TEST(Polish, SolvesOnTheBasisAndSetsWhatIsNegativeToZero) {
  // z = (1, -1e-18) on the basis {0, 1}: row 1 should have left it.
  const Problem problem = cases::plain(MatrixXd::Identity(2, 2), Eigen::Vector2d(-1, 1e-18));
  const Result result = polished(problem, rough(Eigen::Vector2d(1.01, 0.01), {0, 1}));
  EXPECT_EQ(result.z, Eigen::Vector2d(1, 0));
  EXPECT_EQ(result.w, Eigen::Vector2d(0, 1e-18));
  EXPECT_EQ(result.basis, (std::vector<Index>{0, 1})) << "which stays as it is";
}

TEST(Polish, KeepsAnAnswerThatIsCloserThanThatOfItsBasis) {
  // The basis {0, 1} gives z = (1, -0.5), cut to (1, 0), where w = (0, 0.5): right. {1} gives
  // z = (0, -0.5), cut to 0: no solution.
  const Problem problem = cases::plain(MatrixXd::Identity(2, 2), Eigen::Vector2d(-1, 0.5));
  EXPECT_EQ(polished(problem, rough(Eigen::Vector2d(0.9, 0), {0, 1})).z, Eigen::Vector2d(1, 0));
  EXPECT_EQ(polished(problem, rough(Eigen::Vector2d(0.9, 0), {1})).z, Eigen::Vector2d(0.9, 0));
}

}  // namespace
}  // namespace lcp
