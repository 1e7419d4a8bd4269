// Tableau and Basis stand for the same dictionary; both are checked against eqs. (6)-(7) written
// out with an explicit inverse.

#include <gtest/gtest.h>

#include "solvers/linalg/basis.h"
#include "solvers/linalg/start.h"
#include "solvers/linalg/tableau.h"
#include "tests/solvers/cases.h"

namespace lcp {
namespace {

constexpr double rounding = 1e-11;

/// Column of `v` and q' in the dictionary of `labels`, from [I, -M, -c] (w, z, z0)' = q solved with
/// a full-pivoting factorisation of the whole basis matrix.
struct Oracle {
  MatrixXd all;  ///< [I, -M, -c]: the column of every variable.
  VectorXd q;

  Oracle(const ScaledProblem& problem, const VectorXd& covering)
      : all(problem.size(), 2 * problem.size() + 1), q(problem.q()) {
    all << MatrixXd::Identity(problem.size(), problem.size()), -problem.M(), -covering;
  }
  MatrixXd basis(const Labels& labels) const { return all(Eigen::all, labels.basic()); }
  VectorXd column(const Labels& labels, Variable v) const {
    return -basis(labels).fullPivLu().solve(all.col(v));
  }
  VectorXd rhs(const Labels& labels) const { return basis(labels).fullPivLu().solve(q); }
};

template <class Dictionary>
void expect_dictionary(Dictionary& dictionary, const Oracle& oracle) {
  const Labels& labels = dictionary.labels();
  EXPECT_LT((dictionary.q() - oracle.rhs(labels)).norm(), rounding);
  for (Variable v = 0; v <= labels.z0(); ++v) {
    if (labels.is_basic(v)) continue;
    VectorXd column, entries;
    dictionary.column(v, column);
    EXPECT_LT((column - oracle.column(labels, v)).norm(), rounding) << "variable " << v;
    dictionary.entries(v, {0, 3, 5}, entries);
    EXPECT_LT((entries - column({0, 3, 5})).norm(), rounding) << "variable " << v;
  }
  EXPECT_TRUE(dictionary.error_within(rounding));
}

/// Row of the largest entry: a pivot that is certainly sound.
Index largest(const VectorXd& column) {
  Index row;
  column.cwiseAbs().maxCoeff(&row);
  return row;
}

const std::vector<Pivot> some_pivots(const Labels& labels) {
  return {{2, labels.z0()}, {4, labels.z(4)}, {1, labels.z(2)}, {4, labels.w(4)},
          {0, labels.z(5)}, {2, labels.z(3)}, {5, labels.w(1)}};
}

template <class Dictionary>
class ADictionary : public testing::Test {};
using Dictionaries = testing::Types<Tableau, Basis>;
TYPED_TEST_SUITE(ADictionary, Dictionaries);

TYPED_TEST(ADictionary, AgreesWithTheInverseOfTheBasisAfterEveryPivot) {
  for (const Index refactor_every : {1, 3, 100}) {
    const Problem problem = cases::positive_definite(6, 7);
    const ScaledProblem scaled(problem, true);
    TypeParam dictionary(scaled, {}, {.refactor_every = refactor_every});
    const Oracle oracle(scaled, dictionary.covering());
    expect_dictionary(dictionary, oracle);
    VectorXd column;
    for (const Pivot& pivot : some_pivots(dictionary.labels())) {
      dictionary.column(pivot.entering, column);
      ASSERT_GT(std::abs(column(pivot.row)), 1e-3) << "the test's pivots must be sound";
      const Variable expected = dictionary.labels().basic(pivot.row);
      EXPECT_EQ(dictionary.pivot(pivot, column), expected);
      expect_dictionary(dictionary, oracle);
    }
  }
}

TYPED_TEST(ADictionary, FollowsAVariableThatLeavesSeveralTimes) {
  const Problem problem = cases::positive_definite(6, 7);
  const ScaledProblem scaled(problem, true);
  TypeParam dictionary(scaled, {}, {.refactor_every = 100});
  const Oracle oracle(scaled, dictionary.covering());
  const Labels& labels = dictionary.labels();
  VectorXd column;
  for (const Index round : {0, 1, 2})
    for (const Variable entering : {labels.z(2), labels.z(round), labels.w(2)}) {
      if (labels.is_basic(entering)) continue;
      dictionary.column(entering, column);
      const Index row = labels.row_of(labels.complement(entering));
      ASSERT_GT(std::abs(column(row)), 1e-3) << "the test's pivots must be sound";
      dictionary.pivot({row, entering}, column);
      expect_dictionary(dictionary, oracle);
    }
}

TYPED_TEST(ADictionary, ReturnsToAnyBasisByItsPath) {
  const Problem problem = cases::positive_definite(6, 7);
  const ScaledProblem scaled(problem, false);
  TypeParam walked(scaled, {}, {}), rebuilt(scaled, {}, {});
  VectorXd column;
  for (const Pivot& pivot : some_pivots(walked.labels())) {
    walked.column(pivot.entering, column);
    walked.pivot(pivot, column);
  }
  rebuilt.column(rebuilt.labels().z(0), column);
  rebuilt.pivot({largest(column), rebuilt.labels().z(0)}, column);
  rebuilt.rebuild(some_pivots(walked.labels()));
  EXPECT_EQ(rebuilt.labels().basic(), walked.labels().basic());
  EXPECT_EQ(rebuilt.q(), walked.q());
}

TYPED_TEST(ADictionary, BeginsAtAGivenBasisWithCoveringVectorOneThere) {
  const Problem problem = cases::positive_definite(6, 3);
  const ScaledProblem scaled(problem, true);
  TypeParam dictionary(scaled, {1, 4, 5}, {});
  ASSERT_TRUE(dictionary.usable());
  const Oracle oracle(scaled, dictionary.covering());
  expect_dictionary(dictionary, oracle);
  VectorXd column;
  dictionary.column(dictionary.labels().z0(), column);
  EXPECT_LT((column - VectorXd::Ones(6)).norm(), rounding);
}

TYPED_TEST(ADictionary, IsNotUsableWhenTheGivenBasisIsSingularToThePivotTolerance) {
  Problem problem = cases::positive_definite(4, 3);
  problem.M.topLeftCorner(2, 2) << 1, 1, 1, 1 + 1e-8;
  set_plain_scales(problem);
  const ScaledProblem scaled(problem, false);
  EXPECT_TRUE(TypeParam(scaled, {0, 1}, {.pivot = 1e-10}).usable());
  EXPECT_FALSE(TypeParam(scaled, {0, 1}, {.pivot = 1e-6}).usable());
}

TEST(Basis, FactorisesAfreshAsOftenAsItIsTold) {
  const Problem problem = cases::positive_definite(6, 7);
  const ScaledProblem scaled(problem, true);
  Basis every(scaled, {}, {.refactor_every = 1}), third(scaled, {}, {.refactor_every = 3});
  VectorXd column;
  for (const Pivot& pivot : some_pivots(every.labels())) {
    every.column(pivot.entering, column);
    every.pivot(pivot, column);
    third.column(pivot.entering, column);
    third.pivot(pivot, column);
  }
  EXPECT_EQ(every.factorisations(), 7);
  EXPECT_EQ(third.factorisations(), 2);
}

/// After some_pivots, without a factorisation in between.
Basis carried_along(const ScaledProblem& scaled) {
  Basis basis(scaled, {}, {.refactor_every = 100});
  VectorXd column;
  for (const Pivot& pivot : some_pivots(basis.labels())) {
    basis.column(pivot.entering, column);
    basis.pivot(pivot, column);
  }
  return basis;
}

TEST(Basis, FactorisesAfreshWhereItsErrorMayBeNearWhatIsAllowed) {
  const Problem problem = cases::positive_definite(6, 7);
  const ScaledProblem scaled(problem, true);
  Basis basis = carried_along(scaled);
  EXPECT_TRUE(basis.error_within(1e-6));
  EXPECT_EQ(basis.factorisations(), 0) << "rounding of seven pivots is far below 1e-9";
  EXPECT_TRUE(basis.error_within(1e-14));
  EXPECT_EQ(basis.factorisations(), 1);
  EXPECT_TRUE(basis.error_within(1e-14));
  EXPECT_EQ(basis.factorisations(), 1) << "nothing was added up since";
  EXPECT_FALSE(basis.error_within(0));
}

TEST(Basis, RefinesTheBasicVariables) {
  const Problem problem = cases::positive_definite(6, 7);
  const ScaledProblem scaled(problem, true);
  Basis basis = carried_along(scaled);
  const Oracle oracle(scaled, basis.covering());
  const VectorXd exact = oracle.rhs(basis.labels());
  EXPECT_TRUE(basis.refine());
  EXPECT_EQ(basis.factorisations(), 1);
  for (Index row = 0; row < 6; ++row) EXPECT_NEAR(basis.q()(row), exact(row), 1e-14) << row;
}

TEST(ScaledProblem, IsTheProblemInUnitsOfItsScales) {
  Problem problem = cases::positive_definite(3, 5);
  problem.s_z << 2, 4, 8;
  problem.s_w << 0.5, 1, 16;
  const ScaledProblem scaled(problem, true);
  EXPECT_EQ(scaled.M()(2, 0), problem.M(2, 0) * 2 / 16);
  EXPECT_EQ(scaled.q()(0), problem.q(0) / 0.5);
  EXPECT_EQ(scaled.c(), VectorXd(VectorXd::Ones(3)));
  VectorXd z = VectorXd::Ones(3), w = z, covering = scaled.c();
  scaled.unscale(z, w, covering);
  EXPECT_EQ(z, problem.s_z);
  EXPECT_EQ(w, problem.s_w);
  EXPECT_EQ(covering, problem.s_w);
}

}  // namespace
}  // namespace lcp
