#include "harness/judge/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace lcp {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

VectorXd vec(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Index>(values.size()));
}

Instance instance_of(MatrixXd M, VectorXd q) {
  Instance instance;
  instance.name = "by-hand/0";
  instance.problem.M = std::move(M);
  instance.problem.q = std::move(q);
  instance.problem.s_z = VectorXd::Ones(instance.problem.size());
  instance.problem.s_w = VectorXd::Ones(instance.problem.size());
  return instance;
}

/// 2a + b = 4, a + 2b = 5: solved by z = (1, 2), w = 0.
Instance two_by_two() { return instance_of(MatrixXd{{2, 1}, {1, 2}}, vec({-4, -5})); }

Result answer(Claim claim, VectorXd z) {
  Result result;
  result.claim = claim;
  result.z = std::move(z);
  return result;
}

void expect_all_infinite(const Accuracy& accuracy) {
  EXPECT_EQ(accuracy.residual, infinity);
  EXPECT_EQ(accuracy.residual_unscaled, infinity);
  EXPECT_EQ(accuracy.paper_error, infinity);
  EXPECT_EQ(accuracy.min_z, -infinity);
  EXPECT_EQ(accuracy.min_w, -infinity);
  EXPECT_EQ(accuracy.max_zw, infinity);
  EXPECT_EQ(accuracy.backward_error, infinity);
}

TEST(Measure, GivesZeroForAnExactSolution) {
  const Accuracy accuracy = measure(two_by_two().problem, answer(Claim::solved, vec({1, 2})));
  EXPECT_EQ(accuracy.residual, 0);
  EXPECT_EQ(accuracy.residual_unscaled, 0);
  EXPECT_EQ(accuracy.zero_residual, 5);
  EXPECT_EQ(accuracy.min_z, 1);
  EXPECT_EQ(accuracy.min_w, 0);
  EXPECT_EQ(accuracy.max_zw, 0);
  EXPECT_EQ(accuracy.backward_error, 0);
  EXPECT_TRUE(std::isnan(accuracy.paper_error)) << "no w was returned";
}

TEST(Measure, GivesTheFiguresComputedByHand) {
  Problem problem = two_by_two().problem;
  problem.s_z = vec({2.5, 2.5});
  problem.s_w = vec({5, 5});
  const Accuracy accuracy = measure(problem, answer(Claim::solved, vec({1.5, 2})));  // w = (1, .5)
  EXPECT_DOUBLE_EQ(accuracy.residual, 0.2);
  EXPECT_EQ(accuracy.residual_unscaled, 1);
  EXPECT_EQ(accuracy.zero_residual, 1);
  EXPECT_EQ(accuracy.min_z, 1.5);
  EXPECT_EQ(accuracy.min_w, 0.5);
  EXPECT_EQ(accuracy.max_zw, 1.5);
}

TEST(Measure, CountsNegativeComponentsByTheirSize) {
  const Accuracy accuracy = measure(two_by_two().problem, answer(Claim::solved, vec({-3, 4})));
  EXPECT_EQ(accuracy.residual, 6);  // w = (-6, 0), z = (-3, 4): |min| = 6 and 0.
  EXPECT_EQ(accuracy.min_z, -3);
  EXPECT_EQ(accuracy.min_w, -6);
  EXPECT_EQ(accuracy.max_zw, 18);
}

TEST(Measure, ComparesTheSolversOwnWWithTheArtificialVariable) {
  Result result = answer(Claim::ray, vec({1, 2}));
  result.w = vec({0.5, 0.25});
  EXPECT_EQ(measure(two_by_two().problem, result).paper_error, 0.5);
  result.z0 = 0.25;
  result.covering = vec({1, 1});
  EXPECT_EQ(measure(two_by_two().problem, result).paper_error, 0.25);
}

TEST(Measure, TakesTheArtificialVariableTimesItsOwnColumnFromTheSolversW) {
  Result result = answer(Claim::ray, vec({1, 2}));  // M z + q = 0
  result.z0 = 0.25;
  result.covering = vec({2, 4});
  result.w = vec({0.5, 1});
  EXPECT_EQ(measure(two_by_two().problem, result).paper_error, 0);
  result.w = vec({0.25, 0.25});
  EXPECT_EQ(measure(two_by_two().problem, result).paper_error, 0.75);
}

TEST(BackwardError, IsTheLargestRatioOfTheClaimedBasis) {
  Result result = answer(Claim::solved, vec({1.5, 2}));
  result.basis = {0};  // z = (1.5, 0): w = (-1, -3.5), |M||z| + |q| = (7, 6.5).
  EXPECT_DOUBLE_EQ(measure(two_by_two().problem, result).backward_error, 3.5 / 6.5);
  result.basis = {0, 1};  // w = (1, 0.5), |M||z| + |q| = (9, 10.5).
  EXPECT_DOUBLE_EQ(measure(two_by_two().problem, result).backward_error, 1.0 / 9);
}

TEST(BackwardError, FindsTheBasisInTheProblemsScalesWhenNoneIsClaimed) {
  Problem problem = two_by_two().problem;
  const Result result = answer(Claim::solved, vec({1.5, 2}));  // w = (1, 0.5): alpha = {0, 1}
  EXPECT_DOUBLE_EQ(measure(problem, result).backward_error, 1.0 / 9);
  problem.s_z = vec({10, 1});  // 1.5/10 < 1/1: alpha = {1}, z = (0, 2), w = (-2, -1), of (6, 9)
  EXPECT_DOUBLE_EQ(measure(problem, result).backward_error, 1.0 / 3);
}

TEST(BackwardError, AsksOnlyForTheSignOfWOutsideTheBasis) {
  Result result = answer(Claim::solved, vec({2, 0}));
  result.basis = {0};
  const Problem problem = instance_of(MatrixXd{{1, 0}, {0, 1}}, vec({-2, 3})).problem;
  EXPECT_EQ(measure(problem, result).backward_error, 0);
}

TEST(BackwardError, IsInfiniteWhenABasicZIsNegative) {
  Result result = answer(Claim::solved, vec({-1e-300, 2}));
  result.basis = {0, 1};
  EXPECT_EQ(measure(two_by_two().problem, result).backward_error, infinity);
  result.basis = {1};
  EXPECT_LT(measure(two_by_two().problem, result).backward_error, infinity);
}

TEST(BackwardError, TakesZeroOverZeroAsZero) {
  Result result = answer(Claim::solved, vec({1}));
  result.basis = {0};
  EXPECT_EQ(measure(instance_of(MatrixXd{{0}}, vec({0})).problem, result).backward_error, 0);
}

/// In double, and in 64 bits, both sums lose their last term.
TEST(Measure, SeesWhatDoubleCancels) {
  const double huge = std::ldexp(1, 70);
  MatrixXd M = MatrixXd::Zero(3, 3);
  M.row(0) << huge, 1, -huge;
  const VectorXd ones = vec({1, 1, 1});
  EXPECT_EQ((M(0, 0) * 1 + M(0, 1) * 1) + M(0, 2) * 1, 0) << "double: w_0 vanishes";
  const Problem problem = instance_of(M, vec({0, 0, 0})).problem;
  EXPECT_EQ(measure(problem, answer(Claim::solved, ones)).residual, 1);
}

TEST(Measure, KeepsEveryBitOfAProduct) {
  const double next = 1 + std::ldexp(1, -52);  // Its square is 1 + 2^-51 + 2^-104.
  const double q = -(1 + std::ldexp(1, -51));
  EXPECT_EQ(next * next + q, 0) << "double: w vanishes";
  const Problem problem = instance_of(MatrixXd{{next}}, vec({q})).problem;
  EXPECT_EQ(measure(problem, answer(Claim::solved, vec({next}))).residual, std::ldexp(1, -104));
}

TEST(Measure, IsInfiniteForAnswersThatAreNotFiniteVectorsOfTheRightSize) {
  const Problem problem = two_by_two().problem;
  expect_all_infinite(measure(problem, answer(Claim::solved, vec({1, nan}))));
  expect_all_infinite(measure(problem, answer(Claim::solved, vec({1, infinity}))));
  expect_all_infinite(measure(problem, answer(Claim::solved, vec({1, 2, 0}))));
  expect_all_infinite(measure(problem, answer(Claim::solved, VectorXd())));
  Result wrong = answer(Claim::solved, vec({1, 2}));
  wrong.w = vec({0});
  expect_all_infinite(measure(problem, wrong));
  wrong.w = vec({0, nan});
  expect_all_infinite(measure(problem, wrong));
  wrong = answer(Claim::solved, vec({1, 2}));
  wrong.covering = vec({1});
  expect_all_infinite(measure(problem, wrong));
  wrong = answer(Claim::solved, vec({1, 2}));
  wrong.z0 = nan;
  expect_all_infinite(measure(problem, wrong));
}

TEST(Measure, IsInfiniteForABasisWithARowThatDoesNotExist) {
  Result result = answer(Claim::solved, vec({1, 2}));
  result.basis = {0, 2};
  expect_all_infinite(measure(two_by_two().problem, result));
  result.basis = {-1};
  expect_all_infinite(measure(two_by_two().problem, result));
}

TEST(Measure, StillMeasuresZeroWhenTheAnswerIsMalformed) {
  EXPECT_EQ(measure(two_by_two().problem, answer(Claim::solved, vec({nan, nan}))).zero_residual, 5);
}

TEST(Measure, TakesTheEmptyProblemAsSolved) {
  const Accuracy accuracy =
      measure(instance_of(MatrixXd(0, 0), VectorXd()).problem, answer(Claim::solved, VectorXd()));
  EXPECT_EQ(accuracy.residual, 0);
  EXPECT_EQ(accuracy.min_z, 0);
  EXPECT_EQ(accuracy.min_w, 0);
  EXPECT_EQ(accuracy.backward_error, 0);
}

TEST(Measure, RefusesScalesThatWouldHideErrors) {
  for (const double scale : {infinity, nan, 0.0, -1.0}) {
    Problem problem = two_by_two().problem;
    problem.s_z(1) = scale;
    EXPECT_THROW(measure(problem, answer(Claim::solved, vec({1, 2}))), std::invalid_argument);
    problem = two_by_two().problem;
    problem.s_w(0) = scale;
    EXPECT_THROW(measure(problem, answer(Claim::solved, vec({1, 2}))), std::invalid_argument);
  }
}

TEST(Judge, SaysSolvedUpToTheToleranceAndWrongBeyond) {
  const Result close = answer(Claim::solved, vec({1, 2.25}));  // w = (0.25, 0.5)
  EXPECT_EQ(judge(two_by_two(), close, 0.5).verdict, Verdict::solved);
  EXPECT_EQ(judge(two_by_two(), close, 0.49).verdict, Verdict::wrong);
}

TEST(Judge, SaysWrongToTheLiarAndToTheMakerOfNan) {
  EXPECT_EQ(judge(two_by_two(), answer(Claim::solved, vec({-1, -1})), 1e-3).verdict,
            Verdict::wrong);
  EXPECT_EQ(judge(two_by_two(), answer(Claim::solved, vec({nan, nan})), 1e-3).verdict,
            Verdict::wrong);
}

TEST(Judge, IsNotPersuadedByAToleranceThatIsNotANumber) {
  EXPECT_EQ(judge(two_by_two(), answer(Claim::solved, vec({1, 2})), nan).verdict, Verdict::wrong);
}

TEST(Judge, KeepsTheNameOfEveryOtherFailure) {
  for (const Claim claim : {Claim::ray, Claim::exhausted, Claim::cycle, Claim::limit,
                            Claim::singular, Claim::unsupported}) {
    const Judgement judgement = judge(two_by_two(), answer(claim, vec({0, 0})), 1e-6);
    EXPECT_EQ(to_string(judgement.verdict), to_string(claim));
    EXPECT_FALSE(judgement.unclaimed);
    EXPECT_FALSE(judgement.trivial);
  }
}

TEST(Judge, CountsASolutionBehindAClaimOfFailureAsUnclaimed) {
  const Judgement judgement = judge(two_by_two(), answer(Claim::limit, vec({1, 2})), 1e-6);
  EXPECT_EQ(judgement.verdict, Verdict::limit);
  EXPECT_TRUE(judgement.unclaimed);
  EXPECT_FALSE(judge(two_by_two(), answer(Claim::solved, vec({1, 2})), 1e-6).unclaimed);
}

TEST(Judge, MarksInstancesThatZeroSolves) {
  const Instance trivial = instance_of(MatrixXd{{1}}, vec({1}));
  EXPECT_TRUE(judge(trivial, answer(Claim::solved, vec({0})), 1e-6).trivial);
  const Judgement unsupported = judge(trivial, answer(Claim::unsupported, vec({0})), 1e-6);
  EXPECT_TRUE(unsupported.trivial);
  EXPECT_FALSE(unsupported.unclaimed) << "a method that does not apply has not failed";
}

TEST(Judge, MarksInstancesThatZeroSolvesToTheTolerance) {
  const Instance nearly = instance_of(MatrixXd{{1}}, vec({-1e-7}));
  const Result solution = answer(Claim::solved, vec({1e-7}));
  EXPECT_TRUE(judge(nearly, solution, 1e-6).trivial);
  EXPECT_TRUE(judge(nearly, solution, 1e-7).trivial);
  EXPECT_FALSE(judge(nearly, solution, 1e-8).trivial);
}

/// w = -z - 1 has no w, z >= 0; y = 1 shows it.
TEST(Judge, ChecksTheCertificateOfInfeasibility) {
  const Instance infeasible = instance_of(MatrixXd{{-1}}, vec({-1}));
  Result result = answer(Claim::infeasible, vec({0}));
  EXPECT_EQ(judge(infeasible, result, 1e-6).verdict, Verdict::wrong) << "no certificate";
  result.certificate = vec({-1});
  EXPECT_EQ(judge(infeasible, result, 1e-6).verdict, Verdict::wrong);
  result.certificate = vec({nan});
  EXPECT_EQ(judge(infeasible, result, 1e-6).verdict, Verdict::wrong);
  result.certificate = vec({1});
  EXPECT_EQ(judge(infeasible, result, 1e-6).verdict, Verdict::infeasible);
}

TEST(Judge, SaysFalseInfeasibleWhenACheckedSolutionIsKnown) {
  Instance feasible = two_by_two();
  const Result result = answer(Claim::infeasible, vec({0, 0}));
  EXPECT_EQ(judge(feasible, result, 1e-6).verdict, Verdict::wrong);
  feasible.known_solution = vec({1, 2});
  EXPECT_EQ(judge(feasible, result, 1e-6).verdict, Verdict::false_infeasible);
  feasible.known_solution = vec({1, 3});
  EXPECT_EQ(judge(feasible, result, 1e-6).verdict, Verdict::wrong) << "it is not a solution";
  feasible.known_solution = vec({nan, 2});
  EXPECT_EQ(judge(feasible, result, 1e-6).verdict, Verdict::wrong);
}

TEST(Judge, SaysFalseInfeasibleWhenTheAnswerItselfIsASolution) {
  const Judgement judgement = judge(two_by_two(), answer(Claim::infeasible, vec({1, 2})), 1e-6);
  EXPECT_EQ(judgement.verdict, Verdict::false_infeasible);
  EXPECT_TRUE(judgement.unclaimed);
}

TEST(Judge, SaysFalseInfeasibleWhenZeroIsASolution) {
  Result result = answer(Claim::infeasible, vec({5}));  // w = 5.5: no solution itself
  EXPECT_EQ(judge(instance_of(MatrixXd{{1}}, vec({0.5})), result, 1e-6).verdict,
            Verdict::false_infeasible);
  EXPECT_EQ(judge(instance_of(MatrixXd{{1}}, vec({-1e-7})), result, 1e-6).verdict,
            Verdict::false_infeasible)
      << "to the tolerance";
  EXPECT_EQ(judge(instance_of(MatrixXd{{1}}, vec({-1e-5})), result, 1e-6).verdict, Verdict::wrong);
}

TEST(ProvesInfeasible, ForgivesRoundingUpToTheTolerance) {
  const double rounding = 1e-12;
  const Problem problem = instance_of(MatrixXd{{1, 0}, {-1 + rounding, 0}}, vec({-1, 0})).problem;
  EXPECT_TRUE(proves_infeasible(problem, vec({1, 1}), 1e-9));
  EXPECT_FALSE(proves_infeasible(problem, vec({1, 1}), 0));
}

TEST(ProvesInfeasible, WantsQYClearlyBelowZero) {
  const Problem problem = instance_of(MatrixXd{{0, 0}, {0, 0}}, vec({1, -1 - 1e-12})).problem;
  EXPECT_TRUE(proves_infeasible(problem, vec({1, 1}), 0));
  EXPECT_FALSE(proves_infeasible(problem, vec({1, 1}), 1e-9));
}

TEST(ProvesInfeasible, WantsQYBelowZeroEvenWithoutATolerance) {
  // y = 1 has M'y <= 0 and q'y = 0; z = 0 is a solution.
  EXPECT_FALSE(proves_infeasible(instance_of(MatrixXd{{-1}}, vec({0})).problem, vec({1}), 0));
  EXPECT_FALSE(proves_infeasible(instance_of(MatrixXd{{-1}}, vec({-1})).problem, vec({0}), 0));
  EXPECT_TRUE(proves_infeasible(instance_of(MatrixXd{{-1}}, vec({-1e-300})).problem, vec({1}), 0));
}

TEST(ProvesInfeasible, WantsYNonnegativeToTheLastBit) {
  const Problem problem = instance_of(MatrixXd{{-1, 0}, {0, 0}}, vec({-1, 0})).problem;
  EXPECT_TRUE(proves_infeasible(problem, vec({1, 0}), 1e-6));
  EXPECT_FALSE(proves_infeasible(problem, vec({1, -1e-300}), 1e-6));
  EXPECT_FALSE(proves_infeasible(problem, vec({1}), 1e-6));
}

TEST(Verdict, IsReadBackFromItsName) {
  for (const Verdict verdict : all_values<Verdict>())
    EXPECT_EQ(from_string<Verdict>(to_string(verdict)), verdict);
  EXPECT_EQ(to_string(Verdict::false_infeasible), "false-infeasible");
  EXPECT_EQ(to_string(Verdict::not_run), "not-run");
  EXPECT_THROW(from_string<Verdict>("fine"), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
