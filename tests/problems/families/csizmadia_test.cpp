#include <gtest/gtest.h>

#include "problems/registry.h"
#include "solvers/registry.h"
#include "tests/problems/families/independent.h"

namespace lcp {
namespace {

TEST(Csizmadia, IsTheTriangularMMatrix) {
  const Instance instance = generate("csizmadia:n=4", {.count = 1}).front();
  EXPECT_EQ(instance.problem.M,
            (MatrixXd{{1, 0, 0, 0}, {-1, 1, 0, 0}, {-1, -1, 1, 0}, {-1, -1, -1, 1}}));
  // w = 1 - z, z = 1, 0, 1, 0; M z = 1, -1, 0, -2.
  EXPECT_EQ(instance.problem.q, (VectorXd{{-1, 2, 0, 3}}));
}

TEST(Csizmadia, HasTheAlternatingSolutionToTheBit) {
  for (const char* family : {"csizmadia", "csizmadia:permute=on", "csizmadia:n=200"}) {
    for (const Instance& instance : generate(family, {.count = 3})) {
      const Index n = instance.problem.size();
      const independent::Pairs pairs =
          independent::pairs(instance.problem, *instance.known_solution, 0);
      EXPECT_EQ(pairs.active, (n + 1) / 2) << instance.name;
      EXPECT_EQ(pairs.inactive, n / 2) << instance.name;
    }
  }
}

TEST(Csizmadia, IsSolvedByLemkeWithAboutNPivots) {
  for (const Instance& instance : generate("csizmadia:permute=on", {.count = 3})) {
    const Result result =
        make_solver("lexicographic:delta=1e-10,pivot=1e-12").solver->solve(instance.problem);
    EXPECT_LT((result.z - *instance.known_solution).norm(), 1e-9) << instance.name;
    EXPECT_LE(result.work.pivots, instance.problem.size() + 1) << instance.name;
  }
}

}  // namespace
}  // namespace lcp
