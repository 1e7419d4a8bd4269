#include <fmt/format.h>
#include <gtest/gtest.h>

#include "problems/registry.h"
#include "solvers/registry.h"
#include "tests/problems/families/independent.h"
#include "tests/problems/io/files.h"

namespace lcp {
namespace {

using namespace independent;

constexpr double kRounding = 1e-12;  // Costs are up to 100.

constexpr Index kRows = 9, kColumns = 7;

/// Of the game of kRows x kColumns whose equilibria an instance holds.
struct Game {
  MatrixXd A, B;  ///< Costs.
  VectorXd x, y;  ///< The planted equilibrium.
};

Game game_of(const Instance& instance) {
  const VectorXd x = instance.known_solution->head(kRows);
  const VectorXd y = instance.known_solution->segment(kRows, kColumns);
  return {instance.problem.M.block(0, kRows, kRows, kColumns),
          instance.problem.M.block(kRows, 0, kColumns, kRows).transpose(), x / x.sum(),
          y / y.sum()};
}

std::vector<Instance> drawn(const std::string& knobs, Index count = 3, std::uint64_t seed = 1) {
  return generate(fmt::format("bimatrix:rows={},columns={},{}", kRows, kColumns, knobs),
                  {.count = count, .seed = seed});
}

/// Strategies that cost no more than the best.
Index number_of_best(const VectorXd& costs) {
  return (costs.array() <= costs.minCoeff() + kRounding).count();
}

TEST(Bimatrix, CostsAreIntegersWithinTheirRange) {
  for (const Instance& instance : drawn("payoffs=20")) {
    const Game game = game_of(instance);
    for (const MatrixXd& costs : {game.A, game.B}) {
      EXPECT_TRUE(all_integers(costs)) << instance.name;
      EXPECT_GE(costs.minCoeff(), 1) << instance.name;
      EXPECT_LE(costs.maxCoeff(), 20) << instance.name;
    }
  }
}

TEST(Bimatrix, NobodyGainsByLeavingThePlantedEquilibrium) {
  for (const char* form : {"sums", "repeated", "lemke-howson"}) {
    for (const char* knobs : {"support=1", "support=3", "support=4,tie=duplicate", "support=7"}) {
      for (const Instance& instance : drawn(fmt::format("degenerate=2,form={},{}", form, knobs))) {
        const Game game = game_of(instance);
        const VectorXd row_costs = game.A * game.y, column_costs = game.B.transpose() * game.x;
        EXPECT_NEAR(game.x.dot(row_costs), row_costs.minCoeff(), kRounding) << instance.name;
        EXPECT_NEAR(game.y.dot(column_costs), column_costs.minCoeff(), kRounding) << instance.name;
      }
    }
  }
}

TEST(Bimatrix, AsManyStrategiesAreUsedAndTiedAsAskedFor) {
  for (const char* tie : {"payoff", "duplicate"}) {
    for (const Index support : {1, 3, 5}) {
      for (const Index degenerate : {0, 1, 4, 6}) {
        for (const Instance& instance :
             drawn(fmt::format("support={},degenerate={},tie={}", support, degenerate, tie))) {
          const Game game = game_of(instance);
          EXPECT_EQ((game.x.array() > 0).count(), support);
          EXPECT_EQ((game.y.array() > 0).count(), support);
          EXPECT_EQ(number_of_best(game.A * game.y) + number_of_best(game.B.transpose() * game.x),
                    2 * support + degenerate)
              << instance.name;
        }
      }
    }
  }
}

TEST(Bimatrix, FormsHoldTheDegeneratePairsTheySay) {
  const auto counted = [](const char* form, double zero) {
    const Instance instance = drawn(fmt::format("support=4,degenerate=3,form={}", form), 1).front();
    return pairs(instance.problem, *instance.known_solution, zero);
  };
  // Support 4 is a power of two: exact.
  EXPECT_EQ(counted("sums", 0).degenerate, 3 + 2);
  EXPECT_EQ(counted("repeated", 0).degenerate, 3 + 2 * (kRows + kColumns) - 2);
  EXPECT_EQ(counted("lemke-howson", 1e-14).degenerate, 3);
  for (const char* form : {"sums", "repeated", "lemke-howson"}) {
    EXPECT_EQ(counted(form, 1e-14).violated, 0) << form;
    EXPECT_EQ(counted(form, 1e-14).inactive, kRows + kColumns - 8 - 3) << form;
  }
}

TEST(Bimatrix, DuplicatesAreCopiesForBothPlayers) {
  for (const Instance& instance : drawn("support=3,degenerate=4,tie=duplicate")) {
    const Game game = game_of(instance);
    Index copies = 0;
    for (Index i = 0; i < kRows; ++i)
      for (Index used = 0; used < kRows; ++used)
        copies += game.x(i) == 0 && game.x(used) > 0 && game.A.row(i) == game.A.row(used) &&
                  game.B.row(i) == game.B.row(used);
    for (Index j = 0; j < kColumns; ++j)
      for (Index used = 0; used < kColumns; ++used)
        copies += game.y(j) == 0 && game.y(used) > 0 && game.A.col(j) == game.A.col(used) &&
                  game.B.col(j) == game.B.col(used);
    EXPECT_EQ(copies, 4) << instance.name;
  }
}

TEST(Bimatrix, LexicographicOrderFindsAnEquilibriumWhereSumsAreStated) {
  const NamedSolver solver = make_solver("lexicographic:delta=1e-10,pivot=1e-12");
  for (const char* knobs : {"form=sums", "form=repeated", "form=sums,tie=duplicate"}) {
    for (const Instance& instance : drawn(knobs, 5)) {
      const Result result = solver.solver->solve(instance.problem);
      EXPECT_EQ(to_string(result.claim), "solved") << instance.name;
      EXPECT_EQ(pairs(instance.problem, result.z, 1e-9).violated, 0) << instance.name;
      EXPECT_NEAR(result.z.head(kRows).sum(), 1, 1e-12) << instance.name;
    }
  }
}

TEST(Bimatrix, LemkeEndsOnARayAtOnceInTheFormOfLemkeAndHowson) {
  for (const char* knobs : {"degenerate=0", "degenerate=4"}) {
    for (Instance& instance : drawn(fmt::format("form=lemke-howson,{}", knobs))) {
      instance.problem.c = VectorXd::LinSpaced(instance.problem.size(), 1, 2);
      for (const char* name : {"lemke", "lexicographic:delta=1e-10,pivot=1e-12"}) {
        const Result result = make_solver(name).solver->solve(instance.problem);
        EXPECT_EQ(to_string(result.claim), "ray") << instance.name;
        EXPECT_EQ(result.work.pivots, 1) << instance.name;
      }
    }
  }
}

TEST(Bimatrix, IsTheSameTwiceAndDiffersBetweenSeeds) {
  const std::vector<Instance> once = drawn("support=3", 2, 2);
  EXPECT_EQ(once[0].sha256, drawn("support=3", 1, 2)[0].sha256);
  EXPECT_NE(once[0].sha256, drawn("support=3", 1, 3)[0].sha256);
  EXPECT_NE(once[0].sha256, once[1].sha256);
}

TEST(Bimatrix, RefusesKnobsThatContradictOneAnother) {
  const auto message = [](const std::string& knobs) {
    return files::message_of<std::invalid_argument>([&] { drawn(knobs); });
  };
  EXPECT_EQ(message("support=8"), "bimatrix: support=8: expected at most rows=9 and columns=7");
  EXPECT_EQ(message("support=4,degenerate=9"),
            "bimatrix: degenerate=9: expected at most the 8 unused strategies");
}

}  // namespace
}  // namespace lcp
