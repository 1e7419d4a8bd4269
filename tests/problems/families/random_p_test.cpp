#include <fmt/format.h>
#include <gtest/gtest.h>

#include "problems/registry.h"
#include "solvers/registry.h"
#include "tests/problems/families/independent.h"
#include "tests/problems/io/files.h"

namespace lcp {
namespace {

using namespace independent;

constexpr double kRounding = 1e-13;  // z, w and |M| are of order 1.

const char* const kinds[] = {"definite", "dominant", "triangular"};

Instance first(const std::string& family, std::uint64_t seed = 1) {
  return generate(family, {.count = 1, .seed = seed}).front();
}

TEST(RandomP, EveryKindHasPositivePrincipalMinorsOnly) {
  for (const char* kind : kinds)
    for (const char* knobs : {"condition=1", "condition=1e6", "condition=100,degenerate=2"})
      for (const Instance& instance :
           generate(fmt::format("random-p:kind={},n=8,{}", kind, knobs), {.count = 3}))
        EXPECT_TRUE(is_p_matrix(instance.problem.M)) << instance.name;
  EXPECT_TRUE(is_p_matrix(first("random-p:n=8,skew=0.99").problem.M));
  EXPECT_TRUE(is_p_matrix(first("random-p:n=8,skew=0.99,kind=dominant").problem.M));
}

TEST(RandomP, DefiniteHasTheConditionOfItsSymmetricPart) {
  for (const double condition : {1.0, 100.0, 1e8}) {
    for (const char* skew : {"0", "half", "0.9"}) {
      const MatrixXd M =
          first(fmt::format("random-p:n=12,condition={},skew={}", condition, skew)).problem.M;
      const VectorXd eigenvalues = eigenvalues_of_symmetric_part(M);
      EXPECT_GT(eigenvalues(0), 0);
      EXPECT_NEAR(eigenvalues(11) / eigenvalues(0) / condition, 1, 1e-6) << skew;
    }
  }
}

TEST(RandomP, DefiniteHasTheShareOfTheSkewPart) {
  for (const double share : {0.0, 0.25, 0.5, 0.9}) {
    const MatrixXd M = first(fmt::format("random-p:n=12,skew={}", share)).problem.M;
    EXPECT_NEAR(singular_values(skew_part(M))(0), share, 1e-13);
    EXPECT_NEAR(singular_values(symmetric_part(M))(0), 1 - share, 1e-13);
  }
}

TEST(RandomP, DominantIsAnHMatrixWithTheShareOfTheSkewPart) {
  for (const double share : {0.0, 0.25, 0.9}) {
    const MatrixXd M =
        first(fmt::format("random-p:kind=dominant,n=12,condition=1e4,skew={}", share)).problem.M;
    // Minkowski: the comparison matrix has a nonnegative inverse.
    MatrixXd comparison = -M.cwiseAbs();
    comparison.diagonal() = M.diagonal();
    EXPECT_GE(comparison.inverse().minCoeff(), 0);
    const MatrixXd off = M - MatrixXd(M.diagonal().asDiagonal());
    EXPECT_NEAR(skew_part(off).norm() * (1 - share), symmetric_part(off).norm() * share, 1e-13);
  }
}

TEST(RandomP, DiagonalOfDominantAndTriangularSpansTheCondition) {
  for (const char* kind : {"dominant", "triangular"}) {
    const VectorXd diagonal =
        first(fmt::format("random-p:kind={},n=12,condition=1e6", kind)).problem.M.diagonal();
    EXPECT_NEAR(diagonal.maxCoeff(), 1, 1e-14);
    EXPECT_NEAR(diagonal.minCoeff() * 1e6, 1, 1e-14);
  }
}

TEST(RandomP, TriangularIsIndefiniteAndTriangularInSomeOrder) {
  MatrixXd M = first("random-p:kind=triangular").problem.M;
  EXPECT_LT(eigenvalues_of_symmetric_part(M)(0), 0);
  // Row by row, the one left without entries off the diagonal is the next of the order.
  std::vector<Index> left(40);
  for (Index i = 0; i < 40; ++i) left[i] = i;
  while (!left.empty()) {
    const auto next = std::find_if(left.begin(), left.end(), [&](Index i) {
      return (MatrixXd(M(std::vector<Index>{i}, left)).array() != 0).count() == 1;
    });
    ASSERT_NE(next, left.end());
    left.erase(next);
  }
}

TEST(RandomP, PlantsAsManyPairsAsAskedFor) {
  for (const char* kind : kinds) {
    for (const Instance& instance :
         generate(fmt::format("random-p:kind={},n=20,active=7,degenerate=5", kind), {.count = 3})) {
      const Pairs found = pairs(instance.problem, *instance.known_solution, kRounding);
      EXPECT_EQ(found.active, 7) << instance.name;
      EXPECT_EQ(found.degenerate, 5) << instance.name;
      EXPECT_EQ(found.inactive, 8) << instance.name;
    }
  }
  const Instance half = first("random-p");
  EXPECT_EQ(pairs(half.problem, *half.known_solution, kRounding).active, 20);
}

TEST(RandomP, SolversFindThePlantedSolution) {
  const NamedSolver solver = make_solver("lexicographic-revised");
  for (const char* kind : kinds)
    for (const Instance& instance :
         generate(fmt::format("random-p:kind={},degenerate=5", kind), {.count = 4})) {
      const Result result = solver.solver->solve(instance.problem);
      EXPECT_EQ(to_string(result.claim), "solved") << instance.name;
      EXPECT_LT((result.z - *instance.known_solution).norm(), 1e-9) << instance.name;
    }
}

TEST(RandomP, IsTheSameTwiceAndDiffersBetweenSeeds) {
  for (const char* kind : kinds) {
    const std::string family = fmt::format("random-p:kind={},n=10", kind);
    const std::vector<Instance> once = generate(family, {.count = 2, .seed = 2});
    EXPECT_EQ(once[0].sha256, first(family, 2).sha256);
    EXPECT_NE(once[0].sha256, first(family, 3).sha256);
    EXPECT_NE(once[0].sha256, once[1].sha256);
  }
}

TEST(RandomP, RefusesKnobsThatContradictOneAnother) {
  const auto message = [](const char* family) {
    return files::message_of<std::invalid_argument>([&] { generate(family, {.count = 1}); });
  };
  EXPECT_EQ(message("random-p:n=10,active=6,degenerate=5"),
            "random-p: active=6 and degenerate=5: expected at most n=10 together");
  EXPECT_EQ(message("random-p:kind=triangular,skew=0.3"),
            "random-p: skew=0.3 with kind=triangular: expected skew=half, or another kind");
}

}  // namespace
}  // namespace lcp
