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
constexpr std::int64_t kMersenne31 = (std::int64_t{1} << 31) - 1;
constexpr std::int64_t kMersenne61 = (std::int64_t{1} << 61) - 1;

Instance first(const std::string& family, std::uint64_t seed = 1) {
  return generate(family, {.count = 1, .seed = seed}).front();
}

Index numerical_rank(const MatrixXd& M) {
  const VectorXd values = singular_values(M);
  return (values.array() > 1e-12 * values(0)).count();
}

TEST(Semidefinite, RealMatrixHasExactlyTheRankAskedFor) {
  for (const char* skew : {"0", "0.5", "0.9"}) {
    for (const Index rank : {2, 7, 15, 16}) {
      const MatrixXd M =
          first(fmt::format("semidefinite:n=16,rank={},skew={}", rank, skew)).problem.M;
      EXPECT_EQ(numerical_rank(M), rank) << skew;
      EXPECT_GT(eigenvalues_of_symmetric_part(M)(0), -1e-15) << skew;
    }
  }
  EXPECT_EQ(numerical_rank(first("semidefinite:n=16,rank=1").problem.M), 1);
  EXPECT_EQ(numerical_rank(first("semidefinite").problem.M), 20);
}

TEST(Semidefinite, RealMatrixHasTheConditionAskedFor) {
  for (const double condition : {1.0, 100.0, 1e6}) {
    for (const char* skew : {"0", "0.5"}) {
      const MatrixXd M =
          first(fmt::format("semidefinite:n=16,rank=6,condition={},skew={}", condition, skew))
              .problem.M;
      const VectorXd eigenvalues = eigenvalues_of_symmetric_part(M);
      EXPECT_NEAR(eigenvalues(15) / eigenvalues(10) / condition, 1, 1e-8) << skew;
      EXPECT_LT(std::abs(eigenvalues(9)), 1e-14) << skew;
    }
  }
  const VectorXd values = singular_values(first("semidefinite:n=16").problem.M);
  EXPECT_NEAR(values(0) / values(7), 100, 1e-9);
}

TEST(Semidefinite, IsSymmetricUnlessSkewIsAskedFor) {
  for (const char* integer : {"off", "on"}) {
    const auto M = [&](const char* skew) {
      return first(fmt::format("semidefinite:integer={},skew={}", integer, skew)).problem.M;
    };
    EXPECT_EQ(skew_part(M("0")).norm(), 0);
    EXPECT_GT(skew_part(M("0.5")).norm(), 0.1 * symmetric_part(M("0.5")).norm());
  }
}

TEST(Semidefinite, IntegerMatrixHasExactlyTheRankAskedFor) {
  for (const char* skew : {"0", "0.5"}) {
    for (const Index rank : {1, 2, 7, 15, 16}) {
      if (rank == 1 && skew != std::string("0")) continue;
      for (const Instance& instance :
           generate(fmt::format("semidefinite:integer=on,n=16,rank={},skew={}", rank, skew),
                    {.count = 3})) {
        const MatrixXd& M = instance.problem.M;
        ASSERT_TRUE(all_integers(M));
        EXPECT_EQ(rank_modulo(M, kMersenne31), rank) << instance.name;
        EXPECT_EQ(rank_modulo(M, kMersenne61), rank) << instance.name;
        EXPECT_GT(eigenvalues_of_symmetric_part(M)(0), -1e-12 * M.norm()) << instance.name;
      }
    }
  }
}

TEST(Semidefinite, IntegerSolutionIsExactToTheBit) {
  for (const char* knobs : {"n=40", "n=40,skew=0.5", "n=100,rank=100,skew=0.5,active=90"}) {
    const Instance instance = first(fmt::format("semidefinite:integer=on,{}", knobs));
    const Problem& problem = instance.problem;
    const VectorXd& z = *instance.known_solution;
    EXPECT_TRUE(all_integers(problem.q));
    EXPECT_TRUE(all_integers(z));
    EXPECT_LT((problem.M.cwiseAbs() * z + problem.q.cwiseAbs()).maxCoeff(), std::ldexp(1, 53));
    const Pairs found = pairs(problem, z, 0);
    EXPECT_EQ(found.violated, 0) << instance.name;
    EXPECT_EQ(found.degenerate, 4) << instance.name;
    // In double too, whatever the order of the sums.
    const VectorXd w = problem.M * z + problem.q;
    EXPECT_EQ(z.cwiseMin(w), VectorXd::Zero(z.size())) << instance.name;
  }
}

TEST(Semidefinite, PlantsAsManyPairsAsAskedFor) {
  for (const char* integer : {"off", "on"}) {
    for (const char* skew : {"0", "0.5"}) {
      const std::string family = fmt::format(
          "semidefinite:integer={},skew={},n=20,rank=6,active=7,degenerate=5", integer, skew);
      for (const Instance& instance : generate(family, {.count = 3})) {
        const Pairs found = pairs(instance.problem, *instance.known_solution, kRounding);
        EXPECT_EQ(found.active, 7) << instance.name;
        EXPECT_EQ(found.degenerate, 5) << instance.name;
        EXPECT_EQ(found.inactive, 8) << instance.name;
      }
    }
  }
}

TEST(Semidefinite, IsSolvedByLexicographicOrderOnAFactorisedBasis) {
  const NamedSolver solver = make_solver("lexicographic-revised");
  for (const char* knobs : {"integer=off", "integer=on", "integer=on,skew=0.5"}) {
    for (const Instance& instance : generate(fmt::format("semidefinite:{}", knobs), {.count = 3})) {
      const Result result = solver.solver->solve(instance.problem);
      EXPECT_EQ(to_string(result.claim), "solved") << instance.name;
      const double size = 1 + instance.problem.q.cwiseAbs().maxCoeff();
      EXPECT_EQ(pairs(instance.problem, result.z, 1e-12 * size).violated, 0) << instance.name;
    }
  }
}

TEST(Semidefinite, IsTheSameTwiceAndDiffersBetweenSeeds) {
  for (const char* integer : {"off", "on"}) {
    const std::string family = fmt::format("semidefinite:integer={},n=10", integer);
    const std::vector<Instance> once = generate(family, {.count = 2, .seed = 2});
    EXPECT_EQ(once[0].sha256, first(family, 2).sha256);
    EXPECT_NE(once[0].sha256, first(family, 3).sha256);
    EXPECT_NE(once[0].sha256, once[1].sha256);
  }
}

TEST(Semidefinite, RefusesKnobsThatContradictOneAnother) {
  const auto message = [](const std::string& knobs) {
    return files::message_of<std::invalid_argument>(
        [&] { generate("semidefinite:" + knobs, {.count = 1}); });
  };
  EXPECT_EQ(message("n=10,rank=11"), "semidefinite: rank=11: expected at most n=10");
  EXPECT_EQ(message("n=10,active=7"),
            "semidefinite: active=7 and degenerate=4: expected at most n=10 together");
  EXPECT_EQ(message("integer=on,condition=10"),
            "semidefinite: condition=10 with integer=on: expected condition=auto");
  EXPECT_EQ(message("integer=on,skew=0.25"),
            "semidefinite: skew=0.25 with integer=on: expected 0 or 0.5");
  EXPECT_EQ(message("rank=1,condition=10"),
            "semidefinite: condition=10 with rank=1: expected condition=auto or 1");
  EXPECT_EQ(message("rank=1,skew=0.5"),
            "semidefinite: skew=0.5 with rank=1: expected skew=0 or a rank of 2 or more");
}

}  // namespace
}  // namespace lcp
