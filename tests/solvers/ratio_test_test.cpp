#include "solvers/linalg/ratio_test.h"

#include <gtest/gtest.h>

#include "solvers/linalg/tableau.h"
#include "tests/solvers/cases.h"

namespace lcp {
namespace {

TEST(FirstIndexRatioTest, TakesTheLowestRowOfAnExactTie) {
  const Eigen::Vector4d q(4, 2, 1, 3), m(1, -2, -1, -3);
  const Blocking blocking = first_index_ratio_test(q, m, 0);
  EXPECT_EQ(blocking.row, 1);
  EXPECT_EQ(blocking.ratio, 1);
  EXPECT_EQ(blocking.tied, 3);
}

TEST(FirstIndexRatioTest, ATrueZeroLeftByRoundingIsAPivotUnlessThePivotToleranceForbidsIt) {
  const Eigen::Vector2d q(0, 1), m(-1e-17, -1);
  EXPECT_EQ(first_index_ratio_test(q, m, 0).row, 0);
  EXPECT_EQ(first_index_ratio_test(q, m, 1e-12).row, 1);
}

TEST(FirstIndexRatioTest, EndsOnARayWhenNothingBlocks) {
  const Eigen::Vector2d q(1, 1), m(0, 2);
  EXPECT_EQ(first_index_ratio_test(q, m, 0).row, -1);
}

/// A dictionary whose q' and lexicographic columns are given: column j of the basis inverse is
/// column j of `inverse`.
class GivenDictionary {
 public:
  GivenDictionary(VectorXd q, MatrixXd inverse, bool z0_basic = false)
      : labels_(q.size(), {}), q_(std::move(q)), inverse_(std::move(inverse)) {
    for (Index i = 0; i < q_.size(); ++i) labels_.exchange({i, labels_.z(i)});
    if (z0_basic) labels_.exchange({q_.size() - 1, labels_.z0()});
  }
  const Labels& labels() const { return labels_; }
  const VectorXd& q() const { return q_; }
  void entries(Variable v, const std::vector<Index>& rows, VectorXd& out) {
    ++columns_read;
    out = -inverse_.col(v)(rows);
  }
  std::vector<Variable> first() const {
    std::vector<Variable> w;
    for (Index i = 0; i < q_.size(); ++i) w.push_back(labels_.w(i));
    return w;
  }
  Blocking test(const VectorXd& m, const RatioTolerances& tolerances) {
    return lexicographic_ratio_test(*this, m, first(), tolerances);
  }
  Index columns_read = 0;

 private:
  Labels labels_;
  VectorXd q_;
  MatrixXd inverse_;
};

TEST(LexicographicRatioTest, BreaksTiesByTheFirstColumnThatTellsRowsApart) {
  MatrixXd inverse(3, 3);
  inverse << 1, 3, 0,  //
      1, 2, 0,         //
      2, 0, 0;
  GivenDictionary dictionary(Eigen::Vector3d(1, 1, 1), inverse);
  const Blocking blocking = dictionary.test(Eigen::Vector3d(-1, -1, -1), {});
  EXPECT_EQ(blocking.row, 1);
  EXPECT_EQ(blocking.tied, 3);
  EXPECT_EQ(dictionary.columns_read, 2);
}

TEST(LexicographicRatioTest, ComparesEntriesOverThePivots) {
  MatrixXd inverse(2, 2);
  inverse << 3, 0, 2, 0;
  GivenDictionary dictionary(Eigen::Vector2d(2, 1), inverse);
  EXPECT_EQ(dictionary.test(Eigen::Vector2d(-2, -1), {}).row, 0);  // 3/2 < 2/1
}

TEST(LexicographicRatioTest, RowsWithinDeltaAreTiedInRatiosAndInEntries) {
  MatrixXd inverse(2, 2);
  inverse << 1 + 1e-9, 5, 1, 6;
  GivenDictionary dictionary(Eigen::Vector2d(1 + 1e-9, 1), inverse);
  const Eigen::Vector2d m(-1, -1);
  EXPECT_EQ(dictionary.test(m, {.delta = 1e-8}).row, 0);
  EXPECT_EQ(dictionary.test(m, {.delta = 1e-10}).row, 1);
}

TEST(LexicographicRatioTest, TheLastColumnTakesTheLeastValueThenTheLowestRow) {
  MatrixXd inverse(3, 3);
  inverse << 1, 1, 1 + 1e-9,  //
      1, 1, 1,                //
      1, 1, 1;
  GivenDictionary dictionary(Eigen::Vector3d(1, 1, 1), inverse);
  EXPECT_EQ(dictionary.test(Eigen::Vector3d(-1, -1, -1), {.delta = 1e-8}).row, 1);
}

TEST(LexicographicRatioTest, TakesZ0WithinItsOwnPreferenceOnly) {
  GivenDictionary dictionary(Eigen::Vector2d(1, 1 + 1e-6), MatrixXd::Identity(2, 2), true);
  const Eigen::Vector2d m(-1, -1);
  EXPECT_EQ(dictionary.test(m, {.delta = 0, .z0 = 1e-5}).row, 1);
  EXPECT_EQ(dictionary.test(m, {.delta = 1e-5, .z0 = 0}).row, 1);  // tied, and 0 < 1 in column 1
  EXPECT_EQ(dictionary.test(m, {.delta = 0, .z0 = 0}).row, 0);
}

TEST(LexicographicRatioTest, BasicVariablesHaveUnitColumns) {
  const Problem problem = cases::kostreva();
  const ScaledProblem scaled(problem, false);
  Tableau tableau(scaled, {}, {});
  const std::vector<Variable> first = tableau.labels().basic();
  VectorXd m;
  tableau.column(tableau.labels().z0(), m);
  tableau.pivot({2, tableau.labels().z0()}, m);
  // w_1, w_2 tie at 0 over 1; w_1's own unit column makes its row the larger one.
  const Blocking blocking =
      lexicographic_ratio_test(tableau, Eigen::Vector3d(-1, -1, 0), first, {});
  EXPECT_EQ(blocking.row, 1);
}

}  // namespace
}  // namespace lcp
