// bimatrix: games of two players with a planted, degenerate equilibrium.
//
// What      A and B (rows x columns) are the integer costs, 1 ... payoffs, of the row and the column
//           player. Of either player `support` strategies are used with equal weight. Where these
//           meet, every row of A and every column of B sums to S = support (payoffs + 1) / 2, rounded
//           down: each used strategy costs S / support. Every other strategy costs more, but for
//           `degenerate` of them, which cost the same and are unused all the same: pairs with
//           z_i = w_i = 0. tie=payoff gives these costs of their own with the same sum; tie=duplicate
//           makes them copies of a used strategy of the same player, in A and B, and the equilibria
//           a continuum.
// Forms     sums          game_lcp with one pair of inequalities for each sum; n = rows + columns + 4.
//           repeated      game_lcp with a pair for each strategy; n = 3 (rows + columns).
//           lemke-howson  M = [0 A; B' 0], q = -1; n = rows + columns.
//           The pairs of inequalities are tight and at most one multiplier is not 0: `sums` has 2 more
//           degenerate pairs than `degenerate`, `repeated` 2 (rows + columns) - 2. In both q is 0
//           but for the sums: ratio tests tie from the first pivot, whatever `degenerate` is.
// Solution  The planted equilibrium: exact to the bit in the first two forms when `support` is a
//           power of two. A game may have others.
// Seed      Of the generator from which all instances of a draw come, one after the other.
// Class     `sums` and `repeated`: M copositive, q such that Lemke with a sound rule for ties finds an
//           equilibrium (problems/games.h). `lemke-howson`: copositive too, but Lemke ends on a ray at
//           its first pivot from every positive covering vector, with or without ties; the
//           algorithm of Lemke and Howson, which enters a strategy in place of z0, does not.
// Source    C. E. Lemke, J. T. Howson, Equilibrium points of bimatrix games, SIAM Journal on Applied
//           Mathematics 12, 1964; R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity
//           Problem, 2009, 1.2.

#include <algorithm>

#include "problems/drawing/planted.h"
#include "problems/games.h"
#include "problems/registry.h"
#include "solvers/errors.h"

namespace lcp {
namespace {

enum class Tie { payoff, duplicate };
enum class Form { sums, repeated, lemke_howson };

constexpr const char* kSource = "random bimatrix game with a planted equilibrium";

struct BimatrixKnobs {
  Index rows = 12;
  Index columns = 12;
  Index support = 4;
  Index degenerate = 4;
  Tie tie = Tie::payoff;
  Index payoffs = 100;
  Form form = Form::sums;
};

OptionTable knob_table(BimatrixKnobs& knobs) {
  return {
      count("rows", knobs.rows, 1, 200, "strategies of the row player"),
      count("columns", knobs.columns, 1, 200, "strategies of the column player"),
      count("support", knobs.support, 1, 200, "strategies that either uses at the equilibrium"),
      count("degenerate", knobs.degenerate, 0, 400,
            "unused strategies, of both players together, that cost as much as the used"),
      choice("tie", knobs.tie,
             "these have equal cost at the equilibrium only, or are copies of used ones"),
      count("payoffs", knobs.payoffs, 2, 1000, "largest cost; the least is 1"),
      choice("form", knobs.form,
             "the sums of strategies as inequalities, these repeated for every strategy, or left "
             "out (Lemke ends on a ray)"),
  };
}

void check(const BimatrixKnobs& knobs) {
  if (knobs.support > std::min(knobs.rows, knobs.columns))
    throw InvalidArgument("bimatrix: support={}: expected at most rows={} and columns={}",
                          knobs.support, knobs.rows, knobs.columns);
  const Index unused = knobs.rows + knobs.columns - 2 * knobs.support;
  if (knobs.degenerate > unused)
    throw InvalidArgument("bimatrix: degenerate={}: expected at most the {} unused strategies",
                          knobs.degenerate, unused);
}

/// What one player does at the equilibrium.
struct Plan {
  Index strategies;
  std::vector<Index> used;
  std::vector<Index> tied;  ///< Unused, and as good as the used.

  bool is_best(Index i) const {
    return std::count(used.begin(), used.end(), i) + std::count(tied.begin(), tied.end(), i) > 0;
  }
};

struct Plans {
  Plan rows, columns;
};

Plans draw_plans(const BimatrixKnobs& knobs, Random& random) {
  Plans plans{{knobs.rows, {}, {}}, {knobs.columns, {}, {}}};
  std::vector<std::pair<Plan*, Index>> unused;
  for (Plan* plan : {&plans.rows, &plans.columns}) {
    const std::vector<Index> order = random.permutation(plan->strategies);
    plan->used.assign(order.begin(), order.begin() + knobs.support);
    for (Index k = knobs.support; k < plan->strategies; ++k) unused.push_back({plan, order[k]});
  }
  const std::vector<Index> order = random.permutation(static_cast<Index>(unused.size()));
  for (Index k = 0; k < knobs.degenerate; ++k) {
    const auto& [plan, strategy] = unused[order[k]];
    plan->tied.push_back(strategy);
  }
  return plans;
}

/// Moves single costs at `places` by 1, within 1 ... largest, until they sum to `sum`.
void balance(Eigen::Ref<Eigen::RowVectorXd> costs, const std::vector<Index>& places, Index sum,
             Index largest, Random& random) {
  Index missing = sum;
  for (const Index j : places) missing -= static_cast<Index>(costs(j));
  while (missing != 0) {
    const Index step = missing > 0 ? 1 : -1;
    double& cost = costs(places[random.integer(0, static_cast<Index>(places.size()) - 1)]);
    const double moved = cost + static_cast<double>(step);
    if (moved < 1 || moved > static_cast<double>(largest)) continue;
    cost = moved;
    missing -= step;
  }
}

/// Costs of a player's own strategies (rows) against the other's (columns), best where planned.
MatrixXd planted_costs(const Plan& own, const Plan& other, Index payoffs, Random& random) {
  const Index support = static_cast<Index>(other.used.size());
  const Index best = support * (payoffs + 1) / 2;
  MatrixXd costs(own.strategies, other.strategies);
  for (Index i = 0; i < own.strategies; ++i) {
    Eigen::RowVectorXd row(other.strategies);
    for (Index j = 0; j < other.strategies; ++j)
      row(j) = static_cast<double>(random.integer(1, payoffs));
    const Index sum = own.is_best(i) ? best : random.integer(best + 1, support * payoffs);
    balance(row, other.used, sum, payoffs, random);
    costs.row(i) = row;
  }
  return costs;
}

struct Game {
  MatrixXd A, B;  ///< Costs, rows x columns.
};

Game draw_game(const BimatrixKnobs& knobs, const Plans& plans, Random& random) {
  Game game;
  game.A = planted_costs(plans.rows, plans.columns, knobs.payoffs, random);
  game.B = planted_costs(plans.columns, plans.rows, knobs.payoffs, random).transpose();
  if (knobs.tie == Tie::payoff) return game;
  const auto one_used = [&](const Plan& plan) {
    return plan.used[random.integer(0, knobs.support - 1)];
  };
  for (const Index i : plans.rows.tied) {
    const Index used = one_used(plans.rows);
    game.A.row(i) = game.A.row(used);
    game.B.row(i) = game.B.row(used);
  }
  for (const Index j : plans.columns.tied) {
    const Index used = one_used(plans.columns);
    game.A.col(j) = game.A.col(used);
    game.B.col(j) = game.B.col(used);
  }
  return game;
}

Problem problem_of(const Game& game, Form form) {
  switch (form) {
    case Form::sums:
      return game_lcp(game.A, game.B, 1, 1);
    case Form::repeated:
      return game_lcp(game.A, game.B, game.A.rows(), game.A.cols());
    case Form::lemke_howson:
      return lemke_howson_lcp(game.A, game.B);
  }
  return {};
}

/// The planted equilibrium in the unknowns of the form.
VectorXd solution_of(const BimatrixKnobs& knobs, const Plans& plans, Index n) {
  const double support = static_cast<double>(knobs.support);
  const double best = static_cast<double>(knobs.support * (knobs.payoffs + 1) / 2);
  const double weight = knobs.form == Form::lemke_howson ? 1 / best : 1 / support;
  VectorXd z = VectorXd::Zero(n);
  for (const Index i : plans.rows.used) z(i) = weight;
  for (const Index j : plans.columns.used) z(knobs.rows + j) = weight;
  if (knobs.form == Form::lemke_howson) return z;
  // The costs are the multipliers s- and t-, the first copy of each.
  const Index row_copies = knobs.form == Form::repeated ? knobs.rows : 1;
  const Index column_copies = knobs.form == Form::repeated ? knobs.columns : 1;
  const Index s_minus = knobs.rows + knobs.columns + row_copies;
  z(s_minus) = z(s_minus + row_copies + column_copies) = best / support;
  return z;
}

std::vector<Instance> generate_bimatrix(const BimatrixKnobs& knobs, const Draw& draw) {
  check(knobs);
  Random random(draw.seed);
  std::vector<Instance> instances;
  for (Index k = 0; k < draw.count; ++k) {
    const Plans plans = draw_plans(knobs, random);
    Problem problem = problem_of(draw_game(knobs, plans, random), knobs.form);
    VectorXd solution = solution_of(knobs, plans, problem.size());
    instances.push_back(drawn_instance(draw, k, std::move(problem), std::move(solution), kSource));
  }
  return instances;
}

const FamilyRegistration bimatrix{
    {"bimatrix",
     "bimatrix games with a planted equilibrium and unused strategies as good as the used",
     "Lemke and Howson 1964", 20},
    BimatrixKnobs{},
    knob_table,
    generate_bimatrix};

}  // namespace
}  // namespace lcp
