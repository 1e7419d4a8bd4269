#include "harness/studies/shrink/shrink.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "harness/studies/replay/high_path.h"
#include "harness/studies/shrink/parts.h"
#include "problems/registry.h"
#include "tests/harness/studies/replay/rounded_zero.h"

namespace lcp {
namespace {

const std::atomic<bool> never = false;

Invariant invariant(const std::string& solver) {
  return {.solver = make_solver(solver), .reference = make_solver("best-first")};
}

/// The rows of rounded_zero between others of which each is solved by itself.
Instance buried() {
  const Problem core = rounded_zero().problem;
  MatrixXd M = 4 * MatrixXd::Identity(8, 8);
  VectorXd q = VectorXd::Constant(8, 0.25);
  const std::vector<Index> rows = {1, 4, 6};
  M(rows, rows) = core.M;
  q(rows) = core.q;
  return make_instance("buried", plain_problem(M, q), {});
}

void expect_complaint(const Instance& parent, const Invariant& about, const std::string& words) {
  try {
    shrink(parent, about, {}, never);
    ADD_FAILURE() << "no complaint of " << words;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Shrink, DigsOutTheRowsThatFail) {
  const Shrunk shrunk = shrink(buried(), invariant("lemke"), {}, never);
  EXPECT_TRUE(is_failure(shrunk.before));
  EXPECT_EQ(shrunk.after.verdict, shrunk.before.verdict);
  EXPECT_LE(shrunk.instance.problem.size(), 3);
  EXPECT_TRUE(shrunk.reference.solved());
  EXPECT_TRUE(shrunk.minimal);
  EXPECT_EQ(shrunk.reductions.front().what, "rows");
  EXPECT_EQ(shrunk.reductions.front().from, 8);
  EXPECT_EQ(shrunk.reductions.front().to, shrunk.instance.problem.size());
}

TEST(Shrink, LeavesNoRowThatCouldGo) {
  const Instance left = shrink(buried(), invariant("lemke"), {}, never).instance;
  Trials trials(invariant("lemke"), ShrinkOptions().limits, 1000, never, [](Index) {});
  Fared first;
  first.solver = trials.run(make_solver("lemke"), left.problem);
  trials.begin_with(left.problem, first);
  for (Index out = 0; out < left.problem.size(); ++out) {
    std::vector<Index> rows;
    for (Index i = 0; i < left.problem.size(); ++i)
      if (i != out) rows.push_back(i);
    EXPECT_FALSE(rows.empty() || trials.keeps(restricted(left.problem, rows))) << out;
  }
}

TEST(Shrink, TheSameInputGivesTheSameNameAndContent) {
  const Instance one = shrink(buried(), invariant("lemke"), {}, never).instance;
  const Instance two = shrink(buried(), invariant("lemke"), {}, never).instance;
  EXPECT_EQ(one.name, two.name);
  EXPECT_EQ(one.sha256, two.sha256);
  EXPECT_EQ(one.provenance, two.provenance);
  EXPECT_EQ(one.name.rfind("shrunk/lemke-", 0), 0u);
  EXPECT_EQ(one.name.substr(one.name.size() - 8), one.sha256.substr(0, 8));
  EXPECT_EQ(one.provenance.at("parent"), "buried");
  EXPECT_EQ(one.provenance.at("parent_sha256"), buried().sha256);
}

TEST(Shrink, TakesContactsFirst) {
  const Instance frame = generate("squat-like:contacts=8", {.count = 1, .seed = 4}).front();
  Invariant about = invariant("lexicographic");
  about.keep = Invariant::Keep::failure;
  const Shrunk shrunk = shrink(frame, about, {}, never);
  EXPECT_TRUE(is_failure(shrunk.after));
  EXPECT_TRUE(shrunk.reference.solved());
  EXPECT_LT(2 * shrunk.instance.problem.size(), frame.problem.size());
  EXPECT_EQ(shrunk.reductions[1].what, "contacts");
  EXPECT_EQ(shrunk.reductions[1].from, 8);
  EXPECT_LT(shrunk.reductions[1].to, 8);
}

TEST(Shrink, CanKeepToWhatRoundingSpoils) {
  Invariant about = invariant("lemke");
  about.by_rounding = path_rule(about.solver);
  const Shrunk shrunk = shrink(buried(), about, {}, never);
  EXPECT_TRUE(is_failure(shrunk.after));
  const HighPath path =
      follow_high_path(shrunk.instance.problem, *about.by_rounding, {}, HighLimits());
  EXPECT_EQ(path.claim, Claim::solved);
}

TEST(Shrink, RefusesAFailureThatIsNotRoundings) {
  // z0 = 1 in row 1, then z_1 with column (1): nothing blocks.
  const Instance ray =
      make_instance("ray", plain_problem(MatrixXd{{-1, 0}, {0, 1}}, VectorXd{{-1, -1}}), {});
  Invariant about = invariant("lemke");
  about.solvable = false;
  about.by_rounding = path_rule(about.solver);
  expect_complaint(ray, about, "does not solve it in 113 bits either");
}

TEST(Shrink, ACrashOfTheSolverIsAVerdictLikeAnother) {
  const Shrunk shrunk = shrink(buried(), invariant("crasher"), {}, never);
  EXPECT_EQ(shrunk.after.verdict, Verdict::crash);
  EXPECT_EQ(shrunk.instance.problem.size(), 1);
}

TEST(Shrink, AHangEndsAtTheTimeLimit) {
  ShrinkOptions options;
  options.limits.time = std::chrono::milliseconds(5);
  Invariant hangs = invariant("sleeper");
  hangs.solvable = false;  // A reference might take longer than that on a busy machine.
  EXPECT_EQ(shrink(buried(), hangs, options, never).after.verdict, Verdict::timeout);
}

TEST(Shrink, StopsWithinItsBudgetWithAnInstanceThatStillFails) {
  ShrinkOptions options;
  options.max_solves = 6;
  const Shrunk shrunk = shrink(buried(), invariant("lemke"), options, never);
  EXPECT_FALSE(shrunk.minimal);
  EXPECT_LE(shrunk.solves, 7);
  EXPECT_EQ(shrunk.after.verdict, shrunk.before.verdict);
}

TEST(Shrink, AnInterruptionKeepsTheSmallestSoFar) {
  std::atomic<bool> interrupted = false;
  ShrinkOptions options;
  options.progress = [&](Index solves) { interrupted = solves >= 12; };
  const Shrunk shrunk = shrink(buried(), invariant("lemke"), options, interrupted);
  EXPECT_FALSE(shrunk.minimal);
  EXPECT_EQ(shrunk.after.verdict, shrunk.before.verdict);
}

TEST(Shrink, RefusesWhatDoesNotFail) {
  expect_complaint(buried(), invariant("best-first"), "nothing fails");
  expect_complaint(buried(), invariant("projected-gauss-seidel"), "unsupported");
}

TEST(Shrink, RefusesWhatTheReferenceDoesNotSolve) {
  const Instance infeasible = make_instance(
      "infeasible", plain_problem(-MatrixXd::Ones(1, 1), VectorXd::Constant(1, -1)), {});
  expect_complaint(infeasible, invariant("lemke"), "--no-solvable");
  Invariant anything = invariant("lemke");
  anything.solvable = false;
  EXPECT_EQ(shrink(infeasible, anything, {}, never).after.verdict, Verdict::ray);
}

}  // namespace
}  // namespace lcp
