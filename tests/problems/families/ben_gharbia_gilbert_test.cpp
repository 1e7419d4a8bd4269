#include <gtest/gtest.h>

#include <algorithm>

#include "problems/registry.h"
#include "tests/problems/families/independent.h"

namespace lcp {
namespace {

using Set = std::vector<Index>;

/// The indices with w_i < z_i, whose w_i Newton-min makes 0 next.
Set next_set(const Problem& problem, const VectorXd& z) {
  const VectorXd w = problem.M * z + problem.q;
  Set set;
  for (Index i = 0; i < problem.size(); ++i)
    if (w(i) < z(i)) set.push_back(i);
  return set;
}

/// Sets of Newton-min from z until one comes back or none is left.
std::vector<Set> newton_min(const Problem& problem, VectorXd z) {
  std::vector<Set> sets;
  for (Set set = next_set(problem, z); std::count(sets.begin(), sets.end(), set) == 0;
       set = next_set(problem, z)) {
    sets.push_back(set);
    z.setZero();
    z(set) = -MatrixXd(problem.M(set, set)).fullPivLu().solve(VectorXd(problem.q(set)));
  }
  return sets;
}

TEST(BenGharbiaGilbert, AreTheCirculantsOfThePaper) {
  const std::vector<Instance> drawn = generate("ben-gharbia-gilbert:n=3", {.count = 2});
  EXPECT_EQ(drawn[0].problem.M, (MatrixXd{{1, 0, 2}, {2, 1, 0}, {0, 2, 1}}));
  const double a = 4.0 / 3;
  EXPECT_EQ(drawn[1].problem.M,
            (MatrixXd{{1, 0, 0.5, a}, {a, 1, 0, 0.5}, {0.5, a, 1, 0}, {0, 0.5, a, 1}}));
  for (const Instance& instance : drawn) {
    EXPECT_EQ(instance.problem.q, VectorXd::Ones(instance.problem.size()));
    EXPECT_EQ(*instance.known_solution, VectorXd::Zero(instance.problem.size()));
  }
}

TEST(BenGharbiaGilbert, ArePMatrices) {
  for (const Instance& instance : generate("ben-gharbia-gilbert:n=3", {.count = 8}))
    EXPECT_TRUE(independent::is_p_matrix(instance.problem.M)) << instance.name;
}

TEST(BenGharbiaGilbert, NewtonMinCyclesThroughNSetsFromMinusTheFirstUnitVector) {
  for (const Instance& instance : generate("ben-gharbia-gilbert:n=3", {.count = 20})) {
    const Index n = instance.problem.size();
    const std::vector<Set> sets = newton_min(instance.problem, -VectorXd::Unit(n, 0));
    EXPECT_EQ(static_cast<Index>(sets.size()), n) << instance.name;
    for (const Set& set : sets) EXPECT_FALSE(set.empty()) << instance.name;
  }
}

TEST(BenGharbiaGilbert, RefusesSizesOnWhichNewtonMinConverges) {
  EXPECT_THROW(generate("ben-gharbia-gilbert:n=2", {.count = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
