// That laws notice who breaks them; that no row does is checked in laws_of_every_row_test.cpp.

#include "harness/studies/laws/laws.h"

#include <gtest/gtest.h>

#include "harness/judge/judge.h"
#include "harness/studies/laws/law_problems.h"

namespace lcp {
namespace {

using Status = LawOutcome::Status;

LawOutcome outcome(const std::string& law_name, const std::string& solver) {
  for (const Law& law : laws())
    if (law.name == law_name) return check(law, make_solver(solver));
  return {Status::not_applicable, "no such law"};
}

TEST(Laws, ALiarIsNotHonest) {
  const LawOutcome result = outcome("honest", "liar");
  EXPECT_EQ(result.status, Status::broken);
  EXPECT_NE(result.detail.find("fails the check"), std::string::npos) << result.detail;
}

TEST(Laws, ALiarBreaksThePermutationLaw) {
  EXPECT_EQ(outcome("permutation", "liar").status, Status::broken);
}

TEST(Laws, ANanIsNoDefinedAnswer) {
  const LawOutcome result = outcome("defined-failure", "nan-maker");
  EXPECT_EQ(result.status, Status::broken);
  EXPECT_NE(result.detail.find("without a finite z"), std::string::npos) << result.detail;
}

TEST(Laws, ANanIsNotHonest) { EXPECT_EQ(outcome("honest", "nan-maker").status, Status::broken); }

TEST(Laws, ALastBitThatMovesBreaksRepeatable) {
  EXPECT_EQ(outcome("repeatable", "flipper").status, Status::broken);
}

TEST(Laws, AnExceptionBreaksALaw) {
  const LawOutcome result = outcome("repeatable", "thrower");
  EXPECT_EQ(result.status, Status::broken);
  EXPECT_EQ(result.detail, "throws: thrown on purpose");
}

TEST(Laws, ARowWithoutTolerancesNeedsNoLadder) {
  EXPECT_EQ(outcome("accuracy-ladder", "liar").status, Status::not_applicable);
}

TEST(LawProblems, SolutionsAreStrictlyComplementary) {
  for (const bool symmetric : {false, true}) {
    const SolvedProblem solved = strictly_complementary(12, 3, symmetric);
    const VectorXd w = solved.problem.M * solved.z + solved.problem.q;
    EXPECT_GT(solved.z.maxCoeff(), 0);
    for (Index i = 0; i < 12; ++i) {
      EXPECT_NEAR(std::min(solved.z(i), w(i)), 0, 1e-13);
      EXPECT_GT(solved.z(i) + w(i), 0.9);
    }
    EXPECT_EQ(solved.problem.M == solved.problem.M.transpose(), symmetric);
  }
}

TEST(LawProblems, PermutationMovesRowsColumnsAndSolutionTogether) {
  const SolvedProblem solved = strictly_complementary(3, 1, false);
  const SolvedProblem moved = permuted(solved, {2, 0, 1});
  EXPECT_EQ(moved.problem.M(0, 1), solved.problem.M(2, 0));
  EXPECT_EQ(moved.problem.q(1), solved.problem.q(0));
  EXPECT_EQ(moved.z(2), solved.z(1));
}

TEST(LawProblems, SamplesAreWellFormedAndNeedPivots) {
  for (const NamedProblem& sample : sample_problems()) {
    EXPECT_NO_THROW(check(sample.problem, sample.name));
    EXPECT_LT(sample.problem.q.minCoeff(), 0) << sample.name;
  }
}

}  // namespace
}  // namespace lcp
