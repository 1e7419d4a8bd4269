#include "problems/contact/contact_solution.h"

#include <gtest/gtest.h>

#include "solvers/registry.h"
#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

using Begin = ContactModel::Start;

Result solve_best_first(const Problem& problem, const Call& call) {
  static const NamedSolver solver = make_solver("best-first");
  return solver.solver->solve(problem, call);
}

bool claims_solved(const Problem&, const Result& result) { return result.claim == Claim::solved; }

/// What a solver was asked.
struct Question {
  Problem problem;
  Call call;
};

/// best-first, written down; `fails` says on which problems it gives up instead.
ContactSolver scripted(std::vector<Question>& asked,
                       const std::function<bool(const Problem&)>& fails = {}) {
  return {.solve =
              [&asked, fails](const Problem& problem, const Call& call) {
                asked.push_back({problem, call});
                Result result = solve_best_first(problem, call);
                if (fails && fails(problem)) result.claim = Claim::exhausted;
                return result;
              },
          .accept = claims_solved};
}

/// Bodies pushed apart at contact 2, together at 0, 1 and 3; 4 directions.
ContactProblem four_contacts() {
  cases::Uniform uniform(101);
  ContactProblem problem = cases::random_contacts({0.5, 0.3, 0.5, 0}, 10, uniform);
  problem.vbar(0) = problem.vbar(3) = problem.vbar(9) = -1;
  problem.vbar(6) = 3;
  problem.v_before = problem.vbar;
  return problem;
}

const FrictionModel kFour{.directions = 4};

std::vector<Index> active_normals(const ContactSolution& solution) {
  std::vector<Index> active;
  for (const Index row : *solution.without_friction.basis) active.push_back(row);
  return active;
}

TEST(SolveContacts, AppliesTheFrictionalAnswerWhereItIsAccepted) {
  std::vector<Question> asked;
  const ContactProblem problem = four_contacts();
  const ContactSolution solution = solve_contacts(problem, {.friction = kFour}, scripted(asked));
  EXPECT_EQ(solution.applied, Applied::frictional);
  EXPECT_TRUE(solution.solved_with);
  EXPECT_TRUE(solution.solved_without);
  EXPECT_EQ(solution.frictionless.size(), 4);
  EXPECT_EQ(solution.frictional.size(), friction_lcp(problem, kFour).size());
  EXPECT_EQ(solution.forces,
            contact_forces(*solution.frictional.friction, solution.with_friction.z));
  EXPECT_GT(solution.forces.norm(), 0.1);
  EXPECT_GT(std::abs(solution.forces(1)) + std::abs(solution.forces(2)), 0) << "with friction";
}

TEST(SolveContacts, AppliesTheFrictionlessAnswerWhereTheFrictionalLcpFails) {
  std::vector<Question> asked;
  const ContactSolution solution =
      solve_contacts(four_contacts(), {.friction = kFour}, scripted(asked, has_friction));
  EXPECT_EQ(solution.applied, Applied::frictionless);
  EXPECT_FALSE(solution.solved_with);
  EXPECT_TRUE(solution.solved_without);
  EXPECT_EQ(solution.with_friction.claim, Claim::exhausted);
  for (Index i = 0; i < 4; ++i) {
    EXPECT_EQ(solution.forces(3 * i), solution.without_friction.z(i));
    EXPECT_EQ(solution.forces(3 * i + 1), 0);
    EXPECT_EQ(solution.forces(3 * i + 2), 0);
  }
  EXPECT_GT(solution.forces.norm(), 0.1);
}

TEST(SolveContacts, AppliesNothingWhereBothFail) {
  std::vector<Question> asked;
  const ContactSolution solution = solve_contacts(
      four_contacts(), {.friction = kFour}, scripted(asked, [](const Problem&) { return true; }));
  EXPECT_EQ(asked.size(), 2u);
  EXPECT_EQ(solution.applied, Applied::none);
  EXPECT_EQ(solution.forces, VectorXd::Zero(12).eval());
  EXPECT_FALSE(solution.active);
}

TEST(SolveContacts, AppliesTheFrictionalAnswerThoughTheFrictionlessLcpFails) {
  std::vector<Question> asked;
  const ContactSolution solution = solve_contacts(
      four_contacts(), {.friction = kFour},
      scripted(asked, [](const Problem& problem) { return !has_friction(problem); }));
  EXPECT_EQ(solution.applied, Applied::frictional);
  EXPECT_FALSE(solution.solved_without);
  EXPECT_FALSE(asked.at(1).call.start) << "nothing to start from";
  EXPECT_EQ(solution.with_friction.work.restarts, 1);
}

TEST(SolveContacts, DoesNotApplyWhatIsClaimedButNotAccepted) {
  std::vector<Question> asked;
  ContactSolver solver = scripted(asked);
  solver.accept = [](const Problem& problem, const Result&) { return !has_friction(problem); };
  EXPECT_EQ(solve_contacts(four_contacts(), {.friction = kFour}, solver).applied,
            Applied::frictionless);
}

TEST(SolveContacts, WithoutFrictionThereIsOneLcpAndItIsSolvedOnce) {
  ContactProblem problem = four_contacts();
  for (Contact& contact : problem.contacts) contact.mu = 0;
  for (const Begin start : {Begin::two_step, Begin::previous, Begin::cold}) {
    std::vector<Question> asked;
    const ContactSolution solution =
        solve_contacts(problem, {.friction = kFour, .start = start}, scripted(asked));
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked.front().problem.size(), problem.size()) << "no tangential rows";
    EXPECT_FALSE(asked.front().call.start.has_value());
    EXPECT_EQ(solution.applied, Applied::frictional);
    EXPECT_EQ(solution.with_friction.work.restarts, 0);
    EXPECT_EQ(solution.forces,
              contact_forces(*solution.frictional.friction, solution.without_friction.z));
  }
}

TEST(SolveContacts, WithoutFrictionOneFailureIsBoth) {
  ContactProblem problem = four_contacts();
  for (Contact& contact : problem.contacts) contact.mu = 0;
  std::vector<Question> asked;
  const ContactSolution solution = solve_contacts(
      problem, {.friction = kFour}, scripted(asked, [](const Problem&) { return true; }));
  EXPECT_EQ(solution.applied, Applied::none);
  EXPECT_EQ(solution.forces.norm(), 0);
}

TEST(SolveContacts, TwoStepStartsFromTheNormalsThatAreActiveWithoutFriction) {
  std::vector<Question> asked;
  const ContactSolution solution = solve_contacts(
      four_contacts(), {.friction = kFour, .start = Begin::two_step}, scripted(asked));
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_FALSE(asked[0].call.start);
  EXPECT_EQ(asked[0].problem.size(), 4);
  const std::vector<Index> active = active_normals(solution);
  ASSERT_FALSE(active.empty());
  EXPECT_LT(active.size(), 4u) << "the separating contact is not";
  EXPECT_EQ(asked[1].call.start.value().alpha, active);
  EXPECT_EQ(solution.active.value(), static_cast<Index>(active.size()));
  EXPECT_EQ(solution.with_friction.work.restarts, 0);
}

TEST(SolveContacts, TwoStepLeavesOutDependentNormalsAndAllActiveDoesNot) {
  // Contact 1 is contact 0 once more; a made-up first step has both in its basis.
  ContactProblem problem = four_contacts();
  problem.contacts[1] = problem.contacts[0];
  for (Index k = 0; k < 3; ++k) {
    problem.W.row(3 + k) = problem.W.row(k).eval();
    problem.W.col(3 + k) = problem.W.col(k).eval();
    problem.vbar(3 + k) = problem.vbar(k);
  }
  problem.v_before = problem.vbar;
  for (const auto& [start, rows] :
       {std::pair(Begin::two_step, std::size_t{1}), {Begin::all_active, std::size_t{2}}}) {
    std::vector<Question> asked;
    ContactSolver solver = scripted(asked);
    solver.solve = [inner = solver.solve](const Problem& each, const Call& call) {
      Result result = inner(each, call);
      if (!has_friction(each)) result.basis = {0, 1};
      return result;
    };
    solve_contacts(problem, {.friction = kFour, .start = start}, solver);
    EXPECT_EQ(asked.at(1).call.start.value().alpha.size(), rows);
  }
}

TEST(SolveContacts, ColdStartsFromTheEmptyBasis) {
  std::vector<Question> asked;
  const ContactSolution solution =
      solve_contacts(four_contacts(), {.friction = kFour, .start = Begin::cold}, scripted(asked));
  EXPECT_FALSE(asked.at(1).call.start);
  EXPECT_TRUE(solution.active) << "known all the same";
  EXPECT_EQ(solution.with_friction.work.restarts, 0);
}

TEST(SolveContacts, WithoutABasisTheFrictionalLcpIsStartedCold) {
  std::vector<Question> asked;
  ContactSolver solver = scripted(asked);
  solver.solve = [inner = solver.solve](const Problem& problem, const Call& call) {
    Result result = inner(problem, call);
    result.basis.reset();
    return result;
  };
  const ContactSolution solution = solve_contacts(four_contacts(), {.friction = kFour}, solver);
  EXPECT_FALSE(asked.at(1).call.start);
  EXPECT_FALSE(solution.active);
  EXPECT_EQ(solution.with_friction.work.restarts, 1);
}

TEST(SolveContacts, PreviousStartsFromTheSolutionOfTheFrameBefore) {
  for (const bool active_only : {false, true}) {
    const ContactModel model = {
        .friction = kFour, .start = Begin::previous, .active_only = active_only};
    std::vector<Question> asked;
    const ContactProblem problem = four_contacts();
    const ContactSolution first = solve_contacts(problem, model, scripted(asked));
    EXPECT_FALSE(asked.at(1).call.start) << "there was none before";
    EXPECT_EQ(first.with_friction.work.restarts, 1);
    EXPECT_GT(first.with_friction.work.pivots, 0);
    const FrameSolutions solutions = accepted_solutions(first, problem.contacts);
    ASSERT_TRUE(solutions.frictional && solutions.frictionless);
    const ContactSolution second =
        solve_contacts(problem, model, scripted(asked), solutions.frictional);
    EXPECT_FALSE(asked.at(2).call.start) << "the frictionless LCP is solved cold";
    EXPECT_EQ(second.with_friction.work.restarts, 0);
    EXPECT_EQ(second.with_friction.work.pivots, 0) << "nothing has changed";
    EXPECT_LT((second.forces - first.forces).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(SolveContacts, LeavesNothingToTheNextFrameThatWasNotAccepted) {
  std::vector<Question> asked;
  const ContactProblem problem = four_contacts();
  const ContactSolution solution =
      solve_contacts(problem, {.friction = kFour}, scripted(asked, has_friction));
  const FrameSolutions solutions = accepted_solutions(solution, problem.contacts);
  EXPECT_FALSE(solutions.frictional);
  EXPECT_TRUE(solutions.frictionless);
}

class ActiveOnly : public testing::TestWithParam<Begin> {
 protected:
  ContactSolution solve(const ContactProblem& problem, std::vector<Question>& asked) const {
    return solve_contacts(problem, {.friction = kFour, .start = GetParam(), .active_only = true},
                          scripted(asked));
  }
};

TEST_P(ActiveOnly, AsksForTheActiveContactsAndAnswersInTheRowsOfTheFullLcp) {
  std::vector<Question> asked;
  const ContactProblem problem = four_contacts();
  const ContactSolution solution = solve(problem, asked);
  const std::vector<Index> active = active_normals(solution);
  ASSERT_EQ(active, (std::vector<Index>{0, 1, 3})) << "contact 3 has no friction";
  EXPECT_EQ(asked.at(1).problem.size(), 3 + 2 * 5);
  EXPECT_EQ(asked[1].call.start.has_value(), GetParam() != Begin::cold);
  if (asked[1].call.start) {
    EXPECT_EQ(asked[1].call.start->alpha, (std::vector<Index>{0, 1, 2}));
  }

  EXPECT_EQ(solution.applied, Applied::frictional);
  ASSERT_EQ(solution.with_friction.z.size(), friction_lcp(problem, kFour).size());
  EXPECT_EQ(solution.forces(6), 0) << "what was left out carries no force";
  // The separating contact still separates here, so that the answer is one of the full LCP.
  EXPECT_LE(cases::natural_residual(solution.frictional, solution.with_friction.z), 1e-9);
  const VectorXd w = solution.frictional.M * solution.with_friction.z + solution.frictional.q;
  EXPECT_LE((w - solution.with_friction.w).cwiseAbs().maxCoeff(), 1e-9);

  // Its basis gives the same answer: z on it solves M z + q = 0 there.
  const std::vector<Index>& basis = *solution.with_friction.basis;
  EXPECT_TRUE(std::is_sorted(basis.begin(), basis.end()));
  const MatrixXd block = solution.frictional.M(basis, basis);
  const VectorXd q = solution.frictional.q(basis);
  const VectorXd z = block.fullPivLu().solve(-q);
  EXPECT_LE((z - VectorXd(solution.with_friction.z(basis))).cwiseAbs().maxCoeff(), 1e-9);
}

/// Two contacts of which the second separates without friction, and sinks under the friction of the
/// first.
ContactProblem friction_pulls_down() {
  ContactProblem problem;
  problem.contacts = cases::floor_contacts({0.8, 0.8});
  problem.W = 0.5 * MatrixXd::Identity(6, 6);
  problem.W(3, 1) = problem.W(1, 3) = 0.4;
  problem.vbar = VectorXd{{-1, 2, 0, 0.1, 0, 0}};
  problem.v_before = problem.vbar;
  return problem;
}

TEST_P(ActiveOnly, TheErrorOfWSaysHowFastAContactSinksThatWasLeftOut) {
  std::vector<Question> asked;
  const ContactSolution solution = solve(friction_pulls_down(), asked);
  ASSERT_EQ(active_normals(solution), std::vector<Index>{0});
  EXPECT_EQ(solution.applied, Applied::frictional) << "nobody looks at what was left out";
  const VectorXd true_w = solution.frictional.M * solution.with_friction.z + solution.frictional.q;
  const double sinking = -true_w(solution.frictional.friction->normal_row[1]);
  // Contact 0: a = 2 N, friction 1.6 N along -t1 moves contact 1 by -0.64 m/s.
  EXPECT_NEAR(sinking, 0.54, 1e-9);
  EXPECT_NEAR((solution.with_friction.w - true_w).cwiseAbs().maxCoeff(), sinking, 1e-12);
  EXPECT_GE(solution.with_friction.w.minCoeff(), 0);
}

TEST_P(ActiveOnly, LeavesEveryContactOutWhereNoneIsActive) {
  ContactProblem problem = four_contacts();
  for (Index i = 0; i < 4; ++i) problem.vbar(3 * i) = 1;
  std::vector<Question> asked;
  const ContactSolution solution = solve(problem, asked);
  EXPECT_EQ(solution.active.value(), 0);
  EXPECT_EQ(solution.applied, Applied::frictional);
  EXPECT_EQ(solution.forces, VectorXd::Zero(12).eval());
  EXPECT_LE(cases::natural_residual(solution.frictional, solution.with_friction.z), 1e-12)
      << "lambda is the slip speed of contacts without force";
}

TEST_P(ActiveOnly, DoesWithoutVelocitiesBeforeTheStepAndWithLessSymmetry) {
  ContactProblem problem = four_contacts();
  problem.v_before.resize(0);
  problem.asymmetry_allowed = 1e-3;
  problem.W(0, 1) += 1e-5;
  std::vector<Question> asked;
  EXPECT_EQ(solve(problem, asked).applied, Applied::frictional);
}

INSTANTIATE_TEST_SUITE_P(SolveContacts, ActiveOnly, testing::Values(Begin::cold, Begin::two_step),
                         [](const auto& each) {
                           return each.param == Begin::cold ? "Cold" : "TwoStep";
                         });

}  // namespace
}  // namespace lcp
