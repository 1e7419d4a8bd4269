// The table of published LCPs, w = M z + q. Instances of one subject stand together in a function.
//
// Left out because their numbers are not printed where they are described: the one-contact problem
// `confeti` of Siconos, and the three ill-formed contact problems (4, 6, 12 unknowns) of DART.
//
// Sources, cited by name below:
//   Murty     K. G. Murty, Linear Complementarity, Linear and Nonlinear Programming, 1988
//   CPS       R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity Problem, 2009
//   Handbook  C. A. Floudas et al., Handbook of Test Problems in Local and Global Optimization, 1999

#include "problems/published.h"

#include "problems/classic_lcps.h"
#include "problems/games.h"

namespace lcp {

namespace {

// Plain characters: families register while static objects are still being made.
constexpr const char* lemke = "lemke";
constexpr const char* lexicographic = "lexicographic:delta=1e-10,pivot=1e-12";

/// One row of the table.
struct Entry {
  std::string name;
  std::string source;
  MatrixXd M;
  VectorXd q;
  std::optional<VectorXd> solution = {};
  std::vector<ExpectedOutcome> expected = {};
  VectorXd covering = {};
  Index pivot_limit = 0;
  std::string note = {};
};

using Entries = std::vector<Entry>;

// --- Problems on which the rule for ties decides ---

Entries tied() {
  const VectorXd third = VectorXd::Constant(3, 1.0 / 3);
  return {
      {.name = "kostreva-1",
       .source = "M. M. Kostreva, Cycling in linear complementarity problems, Mathematical "
                 "Programming 16, 1979; tests of QuantEcon, Drake and Siconos",
       .M = MatrixXd{{1, 2, 0}, {0, 1, 2}, {2, 0, 1}},
       .q = VectorXd{{-1, -1, -1}},
       .solution = third,
       .expected = {{lemke, Claim::cycle}, {lexicographic, Claim::solved, 4, third}}},
      {.name = "kostreva-2",
       .source = "Kostreva 1979, as above; tests of QuantEcon",
       .M = MatrixXd{{1, -1, 3}, {2, -1, 3}, {-1, -2, 0}},
       .q = VectorXd{{-1, -1, -1}},
       .expected = {{lemke, Claim::cycle}, {lexicographic, Claim::ray, 1}},
       .note = "lexicographic Lemke cycles too unless Step 0 takes the last tied row"},
      {.name = "cps-4.1.14",
       .source = "CPS 4.1.14; Handbook 10.2.2; Siconos",
       .M = MatrixXd{{1, 1}, {1, 1}},
       .q = VectorXd{{-1, -1}},
       .solution = VectorXd{{0.5, 0.5}},
       .expected = {{lexicographic, Claim::solved}},
       .note = "every z >= 0 with z1 + z2 = 1 is a solution"},
      {.name = "cps-4.4.16",
       .source = "CPS 4.4.16; Siconos",
       .M = MatrixXd{{1, -1}, {-1, 1}},
       .q = VectorXd{{1, -1}},
       .solution = VectorXd{{0, 1}},
       .expected = {{lexicographic, Claim::solved, {}, VectorXd{{0, 1}}}},
       .note = "z0 must win the tie; the first index ends on a ray"},
  };
}

/// Handbook 10.2.9 and Siconos, solvable in closed form for 0 <= l <= 23.
Entry parametric_cps(int l) {
  const double x = (l + 16) / 13.0;
  const VectorXd z{{x, x, 2 * (23 - l) / 13.0, (1286 - 9 * l) / 13.0}};
  return {.name = "cps-4-l" + std::to_string(l),
          .source = "Handbook 10.2.9; tests of Siconos (CPS_4, CPS_4bis) and Drake",
          .M = MatrixXd{{11, 0, 10, -1}, {0, 11, 10, -1}, {10, 10, 21, -1}, {1, 1, 1, 0}},
          .q = VectorXd{{50, 50, static_cast<double>(l), -6}},
          .solution = z,
          .expected = {{lexicographic, Claim::solved, {}, z}}};
}

// --- Problems on which no tie decides the outcome ---

Entries textbook() {
  const VectorXd bimatrix{{1.0 / 90, 2.0 / 45, 1.0 / 90, 2.0 / 45}};
  return {
      {.name = "murty-2.8",
       .source = "Murty, example 2.8; QuantEcon; Siconos (murty1)",
       .M = MatrixXd{{1, -1, -1, -1}, {-1, 1, -1, -1}, {1, 1, 2, 0}, {1, 1, 0, 2}},
       .q = VectorXd{{3, 5, -9, -5}},
       .solution = VectorXd{{2, 1, 3, 1}},
       .expected = {{lexicographic, Claim::solved, 5, VectorXd{{2, 1, 3, 1}}}}},
      {.name = "murty-2.9",
       .source = "Murty, example 2.9; QuantEcon",
       .M = MatrixXd{{-1, 0, -3}, {1, -2, -5}, {-2, -1, -2}},
       .q = VectorXd{{-3, -2, -1}},
       .expected = {{lexicographic, Claim::ray}}},
      {.name = "murty-2.11-own-covering",
       .source = "Murty, example 2.11; QuantEcon",
       .M = MatrixXd{{-1.5, 2}, {-4, 4}},
       .q = VectorXd{{-5, 17}},
       .solution = VectorXd{{27, 22.75}},
       .expected = {{lexicographic, Claim::ray}},
       .covering = VectorXd{{5, 16}},
       .note = "the covering vector decides: with ones it is solved"},
      {.name = "murty-2.11-ones",
       .source = "Murty, example 2.11; QuantEcon",
       .M = MatrixXd{{-1.5, 2}, {-4, 4}},
       .q = VectorXd{{-5, 17}},
       .solution = VectorXd{{27, 22.75}},
       .expected = {{lexicographic, Claim::solved, {}, VectorXd{{27, 22.75}}}}},
      {.name = "cps-4.4.7",
       .source = "CPS 4.4.7; Handbook 10.2.3; Siconos",
       .M = MatrixXd{{0, -1, 2}, {2, 0, -2}, {-1, 1, 0}},
       .q = VectorXd{{-3, 6, -1}},
       .solution = VectorXd{{0, 1, 3}},
       .expected = {{lexicographic, Claim::solved, 5, VectorXd{{0, 1, 3}}}}},
      {.name = "cps-4.4.23",
       .source = "CPS 4.4.23, a bimatrix game; Siconos; Drake",
       .M = MatrixXd{{0, 0, 10, 20}, {0, 0, 30, 15}, {10, 20, 0, 0}, {30, 15, 0, 0}},
       .q = VectorXd{{-1, -1, -1, -1}},
       .solution = bimatrix,
       .expected = {{lemke, Claim::ray, 1}, {lexicographic, Claim::ray, 1}},
       .note = "a secondary ray although there is a solution"},
      {.name = "path-readme",
       .source = "README of PATHSolver.jl",
       .M = MatrixXd{{0, 0, -1, -1}, {0, 0, 1, -2}, {1, -1, 2, -2}, {1, 2, -2, 4}},
       .q = VectorXd{{2, 2, -2, -6}},
       .solution = VectorXd{{2.8, 0, 0.8, 1.2}},
       .expected = {{lexicographic, Claim::solved, 4, VectorXd{{2.8, 0, 0.8, 1.2}}}}},
      {.name = "forsyth-4",
       .source = "tests of LCPSolve",
       .M = MatrixXd{{2, -1, 3}, {-1, 1, 6}, {1, 5, -2}},
       .q = VectorXd{{-2, 5, -1.5}},
       .expected = {{lexicographic, Claim::ray}}},
      {.name = "pounce-degenerate",
       .source = "test lcp-degenerate of the pounce physics engine, which writes M by columns",
       .M = MatrixXd{{0, 0, -1, 2, 3},
                     {0, 0, 1, -1, 1},
                     {1, -1, 0, 0, 0},
                     {-2, 1, 0, 0, 0},
                     {-3, -1, 0, 0, 0}},
       .q = VectorXd{{-1, -1, 2, -1, 3}},
       .solution = VectorXd{{0.25, 2.25, 0.5, 0, 0.5}},
       .expected = {{lexicographic, Claim::solved, {}, VectorXd{{0.25, 2.25, 0.5, 0, 0.5}}}},
       .note = "skew-symmetric: read by rows it is the dual, ends on a ray and has no solution"},
      {.name = "drake-failure",
       .source = "Drake, test of its Lemke solver",
       .M = MatrixXd{{-1}},
       .q = VectorXd{{-1}},
       .expected = {{lexicographic, Claim::ray}},
       .note = "infeasible"},
  };
}

// --- Solutions that a small change of q makes vanish ---

Entries perturbed() {
  const MatrixXd M{{0, -1, -1}, {1, 0, 0}, {-1, 0, 0}};
  return {
      {.name = "pang-isolated",
       .source = "Siconos (Pang_isolated_sol)",
       .M = M,
       .q = VectorXd{{0, -1, 1}},
       .solution = VectorXd{{1, 0, 0}},
       .expected = {{lexicographic, Claim::solved, {}, VectorXd{{1, 0, 0}}}}},
      {.name = "pang-isolated-perturbed",
       .source = "Siconos (Pang_isolated_sol_perturbed)",
       .M = M,
       .q = VectorXd{{-1e-4, -1, 1}},
       .expected = {{lexicographic, Claim::ray}},
       .note = "infeasible"},
      {.name = "infinite-solutions-perturbed",
       .source = "Siconos (inf_sol_perturbed)",
       .M = MatrixXd{{0, -1, 1}, {1, 0, 0}, {-1, 0, 0}},
       .q = VectorXd{{-1e-4, -1, 1}},
       .solution = VectorXd{{1, 0, 1e-4}},
       .expected = {{lexicographic, Claim::solved, {}, VectorXd{{1, 0, 1e-4}}}}},
  };
}

// --- Families on which pivoting takes exponentially many steps ---

/// Every ratio test is tied: which of the two rules walks through the cube depends on the order of
/// the variables.
Entries handbook_exponential() {
  constexpr Index n = 6;
  const MatrixXd L = unit_lower_with_twos(n);
  const VectorXd q = VectorXd::Constant(n, -1);
  const VectorXd first = VectorXd::Unit(n, 0), last = VectorXd::Unit(n, n - 1);
  const std::string source = "Handbook 10.2.1; Siconos (exp_murty); Drake";
  return {
      {.name = "handbook-10.2.1",
       .source = source,
       .M = L.transpose(),
       .q = q,
       .solution = last,
       .expected = {{lemke, Claim::solved, 12, last}, {lexicographic, Claim::solved, 2, last}}},
      {.name = "handbook-10.2.1-reversed",
       .source = source,
       .M = L,
       .q = q,
       .solution = first,
       .expected = {{lemke, Claim::solved, 2, first},
                    {lexicographic, Claim::solved, Index{1} << n, first}},
       .note = "the same with the variables in reversed order"},
  };
}

/// `stem`-n, with expectations that the callers know.
Entry classic(const std::string& stem, const ClassicLcp& lcp,
              std::vector<ExpectedOutcome> expected) {
  return {.name = stem + "-" + std::to_string(lcp.q.size()),
          .source = lcp.source,
          .M = lcp.M,
          .q = lcp.q,
          .solution = lcp.solution,
          .expected = std::move(expected),
          .pivot_limit = lcp.pivot_limit};
}

Entry exponential_murty(Index n) {
  const ClassicLcp lcp = murty_exponential(n);
  const Index pivots = Index{1} << n;
  return classic("murty-exponential", lcp,
                 {{lemke, Claim::solved, pivots, lcp.solution},
                  {lexicographic, Claim::solved, pivots, lcp.solution}});
}

Entry exponential_fathi(int variant, Index n) {
  const ClassicLcp lcp = fathi(variant, n);
  return classic("fathi-" + std::to_string(variant), lcp,
                 {{lemke, Claim::solved, 2, lcp.solution},
                  {lexicographic, Claim::solved, Index{1} << n, lcp.solution}});
}

// --- Problems that are hard for other methods than pivoting ---

Entry hard_for_interior_points(Index n) {
  const ClassicLcp lcp = csizmadia(n);
  return classic("csizmadia", lcp, {{lexicographic, Claim::solved, {}, lcp.solution}});
}

Entry hard_for_newton_min(Index n) {
  const ClassicLcp lcp = ben_gharbia_gilbert(n);
  return classic(
      "ben-gharbia-gilbert", lcp,
      {{lemke, Claim::solved, 0, lcp.solution}, {lexicographic, Claim::solved, 0, lcp.solution}});
}

// --- Games ---

/// Lemke with a sound rule for ties solves it (see game_lcp); the first index does not. Both players
/// choosing their third strategy is an equilibrium.
Entry nashpy_degenerate_game() {
  const MatrixXd A{{1, 3, 3}, {3, 1, 3}, {1, 3, 3}}, B{{3, 3, 1}, {1, 1, 3}, {3, 1, 3}};
  const Problem lcp =
      game_lcp(A.maxCoeff() - A.array(), B.maxCoeff() - B.array(), A.rows(), A.cols());
  return {.name = "nashpy-degenerate-game",
          .source =
              "game of Nashpy's test_lemke_howson_lex, as an LCP by QuantEcon's "
              "test_bimatrix_game",
          .M = lcp.M,
          .q = lcp.q,
          .solution = VectorXd::Unit(lcp.size(), 2) + VectorXd::Unit(lcp.size(), 5),
          .expected = {{lexicographic, Claim::solved}}};
}

Entries whole_table() {
  Entries all;
  const auto append = [&](const Entries& entries) {
    all.insert(all.end(), entries.begin(), entries.end());
  };
  append(tied());
  append({parametric_cps(10), parametric_cps(23)});
  append(textbook());
  append(perturbed());
  append({nashpy_degenerate_game()});
  append({hard_for_interior_points(8), hard_for_newton_min(5), hard_for_newton_min(6)});
  append(handbook_exponential());
  append({exponential_murty(4), exponential_murty(8), exponential_murty(12)});
  for (const int variant : {1, 2, 3})
    append({exponential_fathi(variant, 4), exponential_fathi(variant, 8)});
  return all;
}

PublishedInstance published(const Entry& entry) {
  Problem problem;
  problem.M = entry.M;
  problem.q = entry.q;
  problem.c = entry.covering;
  problem.pivot_limit = entry.pivot_limit;
  std::map<std::string, std::string> provenance{{"source", entry.source}};
  if (!entry.note.empty()) provenance["note"] = entry.note;
  Instance instance =
      make_instance("published/" + entry.name, std::move(problem), std::move(provenance));
  instance.known_solution = entry.solution;
  return {std::move(instance), entry.expected};
}

}  // namespace

const std::vector<PublishedInstance>& published_instances() {
  static const std::vector<PublishedInstance> table = [] {
    std::vector<PublishedInstance> instances;
    for (const Entry& entry : whole_table()) instances.push_back(published(entry));
    return instances;
  }();
  return table;
}

}  // namespace lcp
