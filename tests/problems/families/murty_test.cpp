#include <gtest/gtest.h>

#include <cmath>

#include "problems/registry.h"
#include "solvers/registry.h"
#include "tests/problems/families/independent.h"

namespace lcp {
namespace {

Result solve(const Instance& instance, const std::string& spelling) {
  return make_solver(spelling).solver->solve(instance.problem);
}

TEST(Murty, IsTheMatrixAndVectorOfTheBook) {
  const Instance instance = generate("murty:n=3", {.count = 1}).front();
  EXPECT_EQ(instance.problem.M, (MatrixXd{{1, 0, 0}, {2, 1, 0}, {2, 2, 1}}));
  EXPECT_EQ(instance.problem.q, (VectorXd{{-8, -12, -14}}));
  EXPECT_EQ(*instance.known_solution, (VectorXd{{8, 0, 0}}));
}

TEST(Murty, TakesTwoToTheNPivotsWhateverTheTieRuleAndTheOrder) {
  for (const char* family : {"murty:n=1", "murty:n=1,permute=on"}) {
    for (const Instance& instance : generate(family, {.count = 8, .seed = 3})) {
      for (const char* solver : {"lemke", "lexicographic:delta=1e-10,pivot=1e-12"}) {
        const Result result = solve(instance, solver);
        EXPECT_EQ(result.work.pivots, Index{1} << instance.problem.size()) << instance.name;
        EXPECT_EQ(result.z, *instance.known_solution) << instance.name;
      }
    }
  }
}

TEST(Murty, AllowsTwiceThePivotsItTakes) {
  for (const Instance& instance : generate("murty", {.count = 0}))
    EXPECT_EQ(instance.problem.pivot_limit, Index{2} << instance.problem.size());
}

TEST(Murty, IsExactAtEverySize) {
  for (const Instance& instance : generate("murty:n=1", {.count = 24})) {
    const Index n = instance.problem.size();
    // A geometric sum: 2^(n-i) + ... + 2^n with i from 0.
    for (Index i = 0; i < n; ++i)
      EXPECT_EQ(-instance.problem.q(i), double((Index{2} << n) - (Index{1} << (n - i))));
    const independent::Pairs pairs =
        independent::pairs(instance.problem, *instance.known_solution, 0);
    EXPECT_EQ(pairs.active, 1);
    EXPECT_EQ(pairs.inactive, n - 1);
  }
}

TEST(Murty, RefusesMorePivotsThanAnyoneWaitsFor) {
  EXPECT_THROW(generate("murty:n=25", {.count = 1}), std::invalid_argument);
  EXPECT_THROW(generate("murty:n=24", {.count = 2}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
