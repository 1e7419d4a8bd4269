#include "problems/contact/islands.h"

#include <gtest/gtest.h>

#include <numeric>

#include "solvers/registry.h"
#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

std::vector<Index> all_rows(Index n) {
  std::vector<Index> rows(n);
  std::iota(rows.begin(), rows.end(), Index{0});
  return rows;
}

/// Removes what contacts i and j do to one another.
void separate(ContactProblem& problem, Index i, Index j) {
  problem.W.block<3, 3>(3 * i, 3 * j).setZero();
  problem.W.block<3, 3>(3 * j, 3 * i).setZero();
}

/// Contacts 0 and 2 move together, contact 1 apart from both; contact 2 has no friction.
ContactProblem two_islands() {
  cases::Uniform uniform(11);
  ContactProblem problem = cases::random_contacts({0.4, 0.5, 0}, 10, uniform);
  separate(problem, 0, 1);
  separate(problem, 1, 2);
  return problem;
}

TEST(Islands, AreTheConnectedComponentsWithTheirRows) {
  const std::vector<Island> islands = split_islands(friction_lcp(two_islands(), {.directions = 2}));
  ASSERT_EQ(islands.size(), 2u);
  EXPECT_EQ(islands[0].rows, (std::vector<Index>{0, 2, 3, 4, 7}));
  EXPECT_EQ(islands[1].rows, (std::vector<Index>{1, 5, 6, 8}));
}

TEST(Islands, AreTheLcpOfTheirContactsInTheScalesOfTheWhole) {
  const ContactProblem whole = two_islands();
  ContactProblem pair;
  pair.contacts = {whole.contacts[0], whole.contacts[2]};
  const std::vector<Index> axes{0, 1, 2, 6, 7, 8};
  pair.W = whole.W(axes, axes);
  pair.vbar = whole.vbar(axes);

  const Problem lcp = friction_lcp(whole), expected = friction_lcp(pair);
  const Island first = split_islands(lcp).front();
  EXPECT_EQ(first.problem.M, expected.M);
  EXPECT_EQ(first.problem.q, expected.q);
  EXPECT_EQ(first.problem.s_z, lcp.s_z(first.rows));
  EXPECT_EQ(first.problem.s_w, lcp.s_w(first.rows));
  const FrictionBlocks &got = *first.problem.friction, &want = *expected.friction;
  EXPECT_EQ(got.W, want.W);
  EXPECT_EQ(got.vbar, want.vbar);
  EXPECT_EQ(got.mu, want.mu);
  EXPECT_EQ(got.directions, want.directions);
  EXPECT_EQ(got.normal_row, want.normal_row);
  EXPECT_EQ(got.friction_row, want.friction_row);
  EXPECT_EQ(got.cone_row, want.cone_row);
}

TEST(Islands, SolvedApartSolveTheWhole) {
  const Problem whole = friction_lcp(two_islands());
  const NamedSolver solver = make_solver("best-first");
  VectorXd z = VectorXd::Zero(whole.size());
  for (const Island& island : split_islands(whole)) {
    const Result result = solver.solver->solve(island.problem);
    ASSERT_EQ(to_string(result.claim), "solved");
    z(island.rows) = result.z;
  }
  EXPECT_LT(cases::natural_residual(whole, z), 1e-9);
}

TEST(Islands, KeepCoveringVectorAndPivotLimit) {
  Problem whole = friction_lcp(two_islands());
  whole.pivot_limit = 77;
  whole.c = VectorXd::LinSpaced(whole.size(), 1, 2);
  for (const Island& island : split_islands(whole)) {
    EXPECT_EQ(island.problem.c, whole.c(island.rows));
    EXPECT_EQ(island.problem.pivot_limit, 77);
  }
}

TEST(Islands, ContactsLinkedThroughAThirdAreOne) {
  cases::Uniform uniform(12);
  ContactProblem chain = cases::random_contacts({0.4, 0.5, 0.6}, 10, uniform);
  separate(chain, 0, 2);
  const Problem problem = friction_lcp(chain);
  const std::vector<Island> islands = split_islands(problem);
  ASSERT_EQ(islands.size(), 1u);
  EXPECT_EQ(islands[0].rows, all_rows(problem.size()));
  EXPECT_EQ(islands[0].problem.M, problem.M);
}

TEST(Islands, AProblemWithoutContactsIsOne) {
  Problem plain;
  plain.M = MatrixXd::Identity(3, 3);
  plain.q = VectorXd::Constant(3, -1);
  set_plain_scales(plain);
  const std::vector<Island> islands = split_islands(plain);
  ASSERT_EQ(islands.size(), 1u);
  EXPECT_EQ(islands[0].rows, all_rows(3));
}

TEST(Islands, RefuseBlocksThatLeaveARowOut) {
  Problem problem = friction_lcp(two_islands());
  problem.friction->cone_row[0] = problem.friction->cone_row[1];
  EXPECT_THROW(split_islands(problem), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
