#include <fmt/format.h>
#include <gtest/gtest.h>

#include "problems/registry.h"
#include "solvers/registry.h"
#include "tests/problems/families/independent.h"

namespace lcp {
namespace {

std::vector<Instance> drawn(int variant, const char* knobs, Index count) {
  return generate(fmt::format("fathi:variant={},{}", variant, knobs), {.count = count, .seed = 2});
}

TEST(Fathi, EntriesAreThoseOfTheClosedForm) {
  // (LL')_ij = 4 min(i, j) + 2, and 4 i + 1 on the diagonal, rows from 0.
  for (const int variant : {1, 2, 3}) {
    const Instance instance = drawn(variant, "n=6", 1).front();
    for (Index i = 0; i < 6; ++i)
      for (Index j = 0; j < 6; ++j) {
        const double product = double(4 * std::min(i, j) + (i == j ? 1 : 2));
        const double shift = variant == 2 ? 4 : variant == 3 && j > 0 ? -4 : 0;
        EXPECT_EQ(instance.problem.M(i, j), product + shift) << variant;
      }
    EXPECT_EQ(instance.problem.q, VectorXd::Constant(6, -1));
  }
}

TEST(Fathi, LexicographicOrderTakesTwoToTheNPivotsAndTheFirstIndexTwo) {
  for (const int variant : {1, 2, 3}) {
    for (const Instance& instance : drawn(variant, "n=2", 7)) {
      const auto pivots = [&](const char* solver) {
        return make_solver(solver).solver->solve(instance.problem).work.pivots;
      };
      EXPECT_EQ(pivots("lexicographic:delta=1e-10,pivot=1e-12"),
                Index{1} << instance.problem.size())
          << instance.name;
      EXPECT_EQ(pivots("lemke"), 2) << instance.name;
      EXPECT_EQ(instance.problem.pivot_limit, Index{2} << instance.problem.size());
    }
  }
}

TEST(Fathi, SolutionIsTheFirstUnitVectorOverTheFirstEntry) {
  for (const int variant : {1, 2, 3}) {
    for (const char* knobs : {"n=2", "n=2,permute=on"}) {
      for (const Instance& instance : drawn(variant, knobs, 7)) {
        const independent::Pairs pairs =
            independent::pairs(instance.problem, *instance.known_solution, 1e-15);
        EXPECT_EQ(pairs.active, 1) << instance.name;
        EXPECT_EQ(pairs.violated, 0) << instance.name;
      }
    }
  }
}

TEST(Fathi, EveryVariantIsAPMatrix) {
  for (const int variant : {1, 2, 3})
    for (const Instance& instance : drawn(variant, "n=1,permute=on", 8))
      EXPECT_TRUE(independent::is_p_matrix(instance.problem.M)) << instance.name;
}

TEST(Fathi, FirstTwoVariantsAreSymmetricAndDefinite) {
  for (const int variant : {1, 2}) {
    const MatrixXd M = drawn(variant, "n=12", 1).front().problem.M;
    EXPECT_EQ(M, M.transpose().eval());
    EXPECT_GT(independent::eigenvalues_of_symmetric_part(M)(0), 0);
  }
}

}  // namespace
}  // namespace lcp
