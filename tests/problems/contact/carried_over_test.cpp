#include "problems/contact/carried_over.h"

#include <gtest/gtest.h>

#include "problems/contact/friction_lcp.h"
#include "solvers/registry.h"
#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

constexpr FrictionModel kFourDirections{.directions = 4};

/// Contacts 0, 1, 2 on the floor that push down, the second without friction; well conditioned.
ContactProblem three_contacts() {
  cases::Uniform uniform(7);
  ContactProblem problem = cases::random_contacts({0.5, 0, 0.3}, 10, uniform);
  problem.vbar(0) = problem.vbar(3) = problem.vbar(6) = -1;
  return problem;
}

/// The same contacts in another order.
ContactProblem reordered(const ContactProblem& problem, const std::vector<Index>& order) {
  ContactProblem other = problem;
  other.contacts.clear();
  std::vector<Index> axes;
  for (const Index i : order) {
    other.contacts.push_back(problem.contacts[i]);
    for (Index k = 0; k < 3; ++k) axes.push_back(3 * i + k);
  }
  other.W = problem.W(axes, axes);
  other.vbar = problem.vbar(axes);
  return other;
}

Result solve(const Problem& problem, const Call& call = {}) {
  return make_solver("best-first").solver->solve(problem, call);
}

Start carried(const ContactProblem& from, const ContactProblem& to) {
  const Problem before = friction_lcp(from, kFourDirections), now = friction_lcp(to, kFourDirections);
  const SolutionByContact apart = by_contact(solve(before), *before.friction, from.contacts);
  return carried_over(apart, *now.friction, to.contacts, now.size());
}

TEST(CarriedOver, ToTheSameFrameIsItsSolutionAndNeedsNoPivot) {
  const ContactProblem frame = three_contacts();
  const Problem problem = friction_lcp(frame, kFourDirections);
  const Result solution = solve(problem);
  ASSERT_EQ(solution.claim, Claim::solved);
  ASSERT_GT(solution.work.pivots, 0);
  const Start start = carried(frame, frame);
  EXPECT_EQ(start.alpha, solution.basis);
  EXPECT_EQ(start.z, solution.z);
  const Result again = solve(problem, {.start = start, .observer = {}});
  EXPECT_EQ(again.claim, Claim::solved);
  EXPECT_EQ(again.work.pivots, 0);
}

TEST(CarriedOver, FollowsContactsThatChangePlaces) {
  const ContactProblem frame = three_contacts();
  for (const std::vector<Index>& order :
       {std::vector<Index>{2, 0, 1}, std::vector<Index>{1, 0, 2}, std::vector<Index>{2, 1, 0}}) {
    const ContactProblem other = reordered(frame, order);
    const Problem problem = friction_lcp(other, kFourDirections);
    const Start start = carried(frame, other);
    EXPECT_TRUE(std::is_sorted(start.alpha.begin(), start.alpha.end()));
    EXPECT_LT(cases::natural_residual(problem, start.z), 1e-12);
    const Result again = solve(problem, {.start = start, .observer = {}});
    EXPECT_EQ(again.claim, Claim::solved);
    EXPECT_EQ(again.work.pivots, 0);
  }
}

TEST(CarriedOver, ANewContactBeginsWithoutForceAndAGoneOneLeavesNothing) {
  const ContactProblem all = three_contacts();
  const ContactProblem two = reordered(all, {0, 1}), others = reordered(all, {2, 1});
  const Problem problem = friction_lcp(others, kFourDirections);
  const FrictionBlocks& blocks = *problem.friction;
  const Start start = carried(two, others);
  const Problem before = friction_lcp(two, kFourDirections);
  const Result solution = solve(before);
  ASSERT_EQ(start.z.size(), problem.size());
  EXPECT_EQ(start.z(blocks.normal_row[1]), solution.z(before.friction->normal_row[1]));
  EXPECT_GT(start.z(blocks.normal_row[1]), 0);
  EXPECT_EQ(start.alpha, std::vector<Index>{blocks.normal_row[1]}) << "contact 2 is new";
  EXPECT_EQ(start.z.cwiseAbs().sum(), start.z(blocks.normal_row[1]));
}

TEST(CarriedOver, OfSeveralContactsWithOneIdTheFirstGoesWithTheFirst) {
  ContactProblem frame = three_contacts();
  frame.contacts[1].mu = 0.3;
  for (Contact& contact : frame.contacts) contact.id = {1, 0, 5};
  const Problem problem = friction_lcp(frame, kFourDirections);
  EXPECT_EQ(carried(frame, frame).z, solve(problem).z);
}

TEST(CarriedOver, KeepsTheNormalAloneWhereFrictionComesOrGoes) {
  const ContactProblem rough = three_contacts();
  ContactProblem smooth = rough;
  for (Contact& contact : smooth.contacts) contact.mu = 0;
  const Start start = carried(smooth, rough);
  EXPECT_EQ(start.z.head(3), solve(friction_lcp(smooth, kFourDirections)).z);
  EXPECT_EQ(start.z.tail(start.z.size() - 3).cwiseAbs().sum(), 0);
  EXPECT_EQ(carried(rough, smooth).z, VectorXd(solve(friction_lcp(rough, kFourDirections)).z.head(3)));
}

TEST(CarriedOver, OfAMethodWithoutABasisIsAPointAlone) {
  const ContactProblem frame = three_contacts();
  const Problem problem = friction_lcp(frame, kFourDirections);
  Result solution = solve(problem);
  solution.basis.reset();
  const Start start = carried_over(by_contact(solution, *problem.friction, frame.contacts),
                                   *problem.friction, frame.contacts, problem.size());
  EXPECT_TRUE(start.alpha.empty());
  EXPECT_EQ(start.z, solution.z);
}

TEST(CarriedOver, RefusesIdsOfOtherContacts) {
  const ContactProblem frame = three_contacts();
  const Problem problem = friction_lcp(frame, kFourDirections);
  const Result solution = solve(problem);
  EXPECT_THROW(by_contact(solution, *problem.friction, reordered(frame, {0, 1}).contacts),
               std::invalid_argument);
  Result shorter = solution;
  shorter.z.conservativeResize(4);
  EXPECT_THROW(by_contact(shorter, *problem.friction, frame.contacts), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
