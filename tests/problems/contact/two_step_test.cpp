#include "problems/contact/two_step.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "problems/registry.h"
#include "solvers/registry.h"
#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

using SolveFunction = std::function<Result(const Problem&, const Call&)>;

SolveFunction solver(const std::string& spelling) {
  return [made = make_solver(spelling)](const Problem& problem, const Call& call) {
    return made.solver->solve(problem, call);
  };
}

/// Two contacts of one body, both pressed on: n = 2 without friction, 5 with two directions on contact 1 alone.
Problem two_contacts() {
  cases::Uniform uniform(21);
  ContactProblem contacts = cases::random_contacts({0, 0.5}, 10, uniform);
  contacts.vbar(0) = contacts.vbar(3) = -1;
  return friction_lcp(contacts, {.directions = 2});
}

Result answer(const Problem& problem, Claim claim, std::optional<std::vector<Index>> basis,
              Index pivots) {
  Result result;
  result.claim = claim;
  result.z = VectorXd::Zero(problem.size());
  result.basis = std::move(basis);
  result.work.pivots = pivots;
  return result;
}

/// What a made-up solver was asked.
struct Question {
  Index n;
  Call call;
};

/// Answers `first` to the frictionless LCP, and to the other solved in 5 pivots; writes down what it
/// was asked.
SolveFunction scripted(const Result& first, std::vector<Question>& asked) {
  return [first, &asked](const Problem& problem, const Call& call) {
    asked.push_back({problem.size(), call});
    return has_friction(problem) ? answer(problem, Claim::solved, {{}}, 5) : first;
  };
}

/// W_nn = J J' of normals whose answers to the body's freedoms are the rows of J.
MatrixXd normal_matrix(const MatrixXd& J) { return J * J.transpose(); }

TEST(IndependentContacts, AreAllOfThemWhereTheirRowsAreIndependent) {
  const MatrixXd J{{1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
  EXPECT_EQ(independent_contacts({0, 2}, normal_matrix(J), 1e-8), (std::vector<Index>{0, 2}));
  EXPECT_EQ(independent_contacts({}, normal_matrix(J), 1e-8), std::vector<Index>());
}

TEST(IndependentContacts, LeaveOutWhatRoundingAloneTellsApart) {
  // Four corners of a box on three freedoms: J_0 - J_1 + J_2 - J_3 = 0.
  const MatrixXd J{{1, 1, 1}, {1, 1, -1}, {1, -1, -1}, {1, -1, 1}};
  MatrixXd W = normal_matrix(J);
  W(3, 3) += 1e-11;  // regular now, of condition 1e12
  const std::vector<Index> kept = independent_contacts({0, 1, 2, 3}, W, 1e-8);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_GT(MatrixXd(W(kept, kept)).determinant(), 1);
  EXPECT_EQ(independent_contacts({0, 1, 2, 3}, W, 1e-15).size(), 4u);
}

TEST(IndependentContacts, LeaveOutARepeatedContactAndOneThatNothingMoves) {
  const MatrixXd J{{1, 0}, {1, 0}, {0, 0}, {0, 1}};
  EXPECT_EQ(independent_contacts({0, 1, 2, 3}, normal_matrix(J), 1e-8), (std::vector<Index>{0, 3}));
}

TEST(TwoStep, StartsFromIndependentContactsOnly) {
  Problem problem = two_contacts();
  problem.M.row(problem.friction->normal_row[1]) = problem.M.row(problem.friction->normal_row[0]);
  problem.M.col(problem.friction->normal_row[1]) = problem.M.col(problem.friction->normal_row[0]);
  const Problem smooth = frictionless_part(problem);
  std::vector<Question> asked;
  solve_two_step(scripted(answer(smooth, Claim::solved, {{0, 1}}, 3), asked), problem);
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked[1].call.start->alpha, std::vector<Index>{problem.friction->normal_row[0]});
}

TEST(TwoStep, StartsFromTheRowsOfTheContactsThatAreActiveWithoutFriction) {
  Problem problem = two_contacts();
  std::swap(problem.friction->normal_row[0], problem.friction->normal_row[1]);
  const Problem smooth = frictionless_part(problem);
  std::vector<Question> asked;
  const TwoStep steps =
      solve_two_step(scripted(answer(smooth, Claim::solved, {{0}}, 3), asked), problem);
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked[0].n, 2);
  EXPECT_FALSE(asked[0].call.start);
  EXPECT_EQ(asked[1].n, problem.size());
  EXPECT_EQ(asked[1].call.start.value().alpha, std::vector<Index>{1}) << "normal row of contact 0";
  EXPECT_EQ(asked[1].call.start->z, VectorXd::Zero(problem.size()));
  EXPECT_EQ(steps.frictionless.work.pivots, 3);
  EXPECT_EQ(steps.frictional.work.pivots, 5) << "those of the first step stand apart";
  EXPECT_EQ(steps.frictional.work.frictionless_pivots, 3);
  EXPECT_EQ(steps.frictional.work.restarts, 0);
  EXPECT_EQ(steps.frictional.message, "");
}

TEST(TwoStep, StartsFromRowsInAscendingOrder) {
  Problem problem = two_contacts();
  std::swap(problem.friction->normal_row[0], problem.friction->normal_row[1]);
  std::vector<Question> asked;
  const Result both = answer(frictionless_part(problem), Claim::solved, {{0, 1}}, 0);
  solve_two_step(scripted(both, asked), problem);
  EXPECT_EQ(asked.at(1).call.start.value().alpha, (std::vector<Index>{0, 1}));
}

TEST(TwoStep, GoesOnColdWhenTheFirstStepFailsAndCountsIt) {
  const Problem problem = two_contacts();
  std::vector<Question> asked;
  const Result ray = answer(frictionless_part(problem), Claim::ray, {{1}}, 3);
  Result result = solve_two_step(scripted(ray, asked), problem).frictional;
  EXPECT_EQ(asked.at(1).call.start.value().alpha, std::vector<Index>{});
  EXPECT_EQ(result.claim, Claim::solved);
  EXPECT_EQ(result.message, "frictionless LCP: ray; started cold");
  EXPECT_EQ(result.work.restarts, 1);
  EXPECT_EQ(result.work.frictionless_pivots, 3);

  const SolveFunction fails_twice = [](const Problem& each, const Call&) {
    Result failed = answer(each, Claim::limit, {}, 1);
    failed.message = "max_pivots=1 reached";
    failed.work.restarts = 1;
    return failed;
  };
  result = solve_two_step(fails_twice, problem).frictional;
  EXPECT_EQ(result.claim, Claim::limit);
  EXPECT_EQ(result.message, "frictionless LCP: limit; started cold; max_pivots=1 reached");
  EXPECT_EQ(result.work.restarts, 2);
}

/// Cold means cold: the empty basis, which it starts from then, is no start at all.
TEST(TwoStep, FromAnEmptyBasisIsTheColdSolve) {
  const Problem problem = generate("squat-like", {.count = 1}).front().problem;
  for (const char* spelling :
       {"lexicographic-revised", "best-first", "best-first-tableau:max_nodes=50"}) {
    const SolveFunction solve = solver(spelling);
    const SolveFunction fails_first = [&](const Problem& each, const Call& call) {
      return has_friction(each) ? solve(each, call) : answer(each, Claim::ray, {}, 0);
    };
    const Result cold = solve(problem, {});
    const Result after = solve_two_step(fails_first, problem).frictional;
    EXPECT_EQ(after.claim, cold.claim) << spelling;
    EXPECT_EQ(after.z, cold.z) << spelling;
    EXPECT_EQ(after.basis, cold.basis) << spelling;
    EXPECT_EQ(after.work.pivots, cold.work.pivots) << spelling;
  }
}

TEST(TwoStep, StartsFromThePointAloneWhereTheFirstStepHasNoBasis) {
  Problem problem = two_contacts();
  std::swap(problem.friction->normal_row[0], problem.friction->normal_row[1]);
  Result first = answer(frictionless_part(problem), Claim::solved, std::nullopt, 0);
  first.z = VectorXd{{3, 4}};
  std::vector<Question> asked;
  solve_two_step(scripted(first, asked), problem);
  EXPECT_TRUE(asked.at(1).call.start.value().alpha.empty());
  EXPECT_EQ(asked.at(1).call.start->z, (VectorXd{{4, 3, 0, 0, 0}}));

  const Result iterative =
      solve_two_step(solver("projected-gauss-seidel"), two_contacts()).frictional;
  EXPECT_EQ(iterative.claim, Claim::solved);
  EXPECT_EQ(iterative.message, "");
}

TEST(TwoStep, GoesOnFromZeroWhereAnIterativeFirstStepFails) {
  const char* spelling = "projected-gauss-seidel:max_sweeps=1,tolerance=0";
  const Problem problem = two_contacts();
  const Result limited = solve_two_step(solver(spelling), problem).frictional;
  EXPECT_EQ(limited.claim, Claim::limit);
  EXPECT_TRUE(limited.message.starts_with("frictionless LCP: limit; started cold; "));
  EXPECT_EQ(limited.work.restarts, 1);
  EXPECT_EQ(limited.z, solver(spelling)(problem, {}).z);
}

TEST(TwoStep, ARefusalOfAnyStartStaysOne) {
  const SolveFunction takes_none = [](const Problem& each, const Call& call) {
    return answer(each, call.start ? Claim::unsupported : Claim::limit, {}, 0);
  };
  const Result result = solve_two_step(takes_none, two_contacts()).frictional;
  EXPECT_EQ(result.claim, Claim::unsupported);
  EXPECT_EQ(result.work.restarts, 0);
}

TEST(TwoStep, IsUnsupportedWithoutFriction) {
  Problem plain;
  plain.M = MatrixXd::Identity(2, 2);
  plain.q = VectorXd::Constant(2, -1);
  set_plain_scales(plain);
  for (const Problem& problem : {plain, frictionless_part(two_contacts())}) {
    const TwoStep steps = solve_two_step(solver("best-first"), problem);
    EXPECT_EQ(steps.frictional.claim, Claim::unsupported);
    EXPECT_EQ(steps.frictional.message, "two-step: the instance has no friction");
    EXPECT_EQ(steps.frictional.z.size(), 2);
    EXPECT_EQ(steps.frictionless.claim, Claim::unsupported);
  }
}

TEST(TwoStep, AStartThatIsNotUsableStaysTheSolversClaim) {
  const SolveFunction refuses = [](const Problem& each, const Call& call) {
    if (!has_friction(each)) return answer(each, Claim::solved, {{0}}, 0);
    EXPECT_EQ(call.start->alpha.size(), 1u);
    Result result = answer(each, Claim::singular, {}, 0);
    result.message = "start not usable";
    return result;
  };
  const Result result = solve_two_step(refuses, two_contacts()).frictional;
  EXPECT_EQ(result.claim, Claim::singular);
  EXPECT_EQ(result.message, "start not usable");
  EXPECT_EQ(result.work.restarts, 0);
}

TEST(TwoStep, ShowsThePivotsOfTheSecondStepAlone) {
  const Problem problem = two_contacts();
  Index seen = 0;
  const Result result = solve_two_step(solver("best-first"), problem, [&seen](const PivotEvent&) {
                          ++seen;
                        }).frictional;
  EXPECT_EQ(seen, result.work.pivots);
}

TEST(TwoStep, SolvesTheFrictionalLcpOfSquatsTheSameWayTwice) {
  const SolveFunction solve = solver("best-first");
  for (const Instance& frame : generate("squat-like", {.count = 20})) {
    const TwoStep steps = solve_two_step(solve, frame.problem);
    const Result& result = steps.frictional;
    EXPECT_EQ(to_string(result.claim), "solved") << frame.name;
    ASSERT_EQ(result.z.size(), frame.problem.size());
    EXPECT_LT(cases::natural_residual(frame.problem, result.z), 1e-9) << frame.name;
    EXPECT_EQ(result.work.start_pivots, frame.active_contacts) << frame.name;
    EXPECT_EQ(result.work.frictionless_pivots, steps.frictionless.work.pivots);
    EXPECT_LT(cases::natural_residual(frictionless_part(frame.problem), steps.frictionless.z),
              1e-9);

    const Result again = solve_two_step(solve, frame.problem).frictional;
    EXPECT_EQ(again.z, result.z);
    EXPECT_EQ(again.w, result.w);
    EXPECT_EQ(again.basis, result.basis);
    EXPECT_EQ(again.work.nodes, result.work.nodes);
  }
}

}  // namespace
}  // namespace lcp
