#include <gtest/gtest.h>

#include "solvers/registry.h"
#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

TEST(GaussSeidelOnContacts, SolvesNineteenOfTwentyWellConditionedRandomProblems) {
  constexpr int kProblems = 500;
  const NamedSolver solver = make_solver("projected-gauss-seidel");
  cases::Uniform uniform(2008);
  int solved = 0;
  for (int trial = 0; trial < kProblems; ++trial) {
    std::vector<double> mu(1 + trial % 4);
    for (double& value : mu) value = uniform.between(0.1, 1);
    const ContactProblem contacts = cases::random_contacts(mu, 100, uniform);
    const Problem problem = friction_lcp(contacts);
    const Result result = solver.solver->solve(problem);
    solved += result.claim == Claim::solved && cases::natural_residual(problem, result.z) <= 1e-6;
  }
  RecordProperty("solved", solved);
  EXPECT_GE(solved, kProblems * 95 / 100);
}

TEST(GaussSeidelOnContacts, FindsThePlanarSolution) {
  // In the plane m = 2: f_n = 2, friction 0.4 against a slip of 3 - 0.4 / 2.
  const Problem problem = friction_lcp(cases::particle(0.2, {-1, 3, 0}), {.directions = 2});
  const Result result = make_solver("projected-gauss-seidel").solver->solve(problem);
  ASSERT_EQ(to_string(result.claim), "solved");
  EXPECT_LT((result.z - VectorXd{{2, 0, 0.4, 2.8}}).norm(), 1e-12);
}

}  // namespace
}  // namespace lcp
