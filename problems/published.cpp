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

/// The limit of families whose number of pivots doubles with every row.
Index exponential_limit(Index n) { return Index{1} << (n + 1); }

/// Unit lower triangular with 2 below the diagonal.
MatrixXd unit_lower_with_twos(Index n) {
  MatrixXd L = MatrixXd::Constant(n, n, 2).triangularView<Eigen::StrictlyLower>();
  L.diagonal().setOnes();
  return L;
}

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

/// q_i = -(2^(n-i+1) + ... + 2^n); exactly 2^n pivots and no tie.
Entry murty_exponential(Index n) {
  VectorXd q(n);
  double sum = 0;
  for (Index i = 0; i < n; ++i) q(i) = -(sum += std::ldexp(1, static_cast<int>(n - i)));
  const VectorXd z = VectorXd::Unit(n, 0) * std::ldexp(1, static_cast<int>(n));
  const Index pivots = Index{1} << n;
  return {
      .name = "murty-exponential-" + std::to_string(n),
      .source = "Murty, chapter 6; Siconos (exp_murty2, in reversed order); QuantEcon",
      .M = unit_lower_with_twos(n),
      .q = q,
      .solution = z,
      .expected = {{lemke, Claim::solved, pivots, z}, {lexicographic, Claim::solved, pivots, z}},
      .pivot_limit = exponential_limit(n)};
}

/// M = LL' (variant 1), LL' + 4 (2), LL' - 4 outside the first column (3); q = -1. Nearly every
/// ratio test is tied, and the lexicographic rule needs 2^n pivots where the first index needs 2.
Entry fathi(int variant, Index n) {
  const MatrixXd L = unit_lower_with_twos(n);
  MatrixXd M = L * L.transpose();
  if (variant == 2) M.array() += 4;
  if (variant == 3) M.rightCols(n - 1).array() -= 4;
  const VectorXd z = VectorXd::Unit(n, 0) / M(0, 0);
  return {
      .name = "fathi-" + std::to_string(variant) + "-" + std::to_string(n),
      .source =
          "Y. Fathi, Computational complexity of LCPs associated with positive definite "
          "symmetric matrices, Mathematical Programming 17, 1979; hnm4lcp",
      .M = M,
      .q = VectorXd::Constant(n, -1),
      .solution = z,
      .expected = {{lemke, Claim::solved, 2, z}, {lexicographic, Claim::solved, Index{1} << n, z}},
      .pivot_limit = exponential_limit(n)};
}

// --- Problems that are hard for other methods than pivoting ---

/// An M-matrix whose handicap grows exponentially, which slows interior points down; x = 1, 0, 1 ...
Entry csizmadia(Index n) {
  const MatrixXd M =
      2 * MatrixXd::Identity(n, n) - MatrixXd(MatrixXd::Ones(n, n).triangularView<Eigen::Lower>());
  VectorXd x(n);
  for (Index i = 0; i < n; ++i) x(i) = i % 2 == 0 ? 1 : 0;
  return {.name = "csizmadia-" + std::to_string(n),
          .source =
              "E. de Klerk, M. E.-Nagy, On the complexity of computing the handicap of a "
              "sufficient matrix, Mathematical Programming 129, 2011; hnm4lcp",
          .M = M,
          .q = VectorXd::Ones(n) - x - M * x,
          .solution = x,
          .expected = {{lexicographic, Claim::solved, {}, x}}};
}

/// A P-matrix on which the Newton-min method cycles from -e_1; z = 0 solves it.
Entry ben_gharbia_gilbert(Index n) {
  MatrixXd M = MatrixXd::Identity(n, n);
  for (Index j = 0; j < n; ++j) {
    M((j + 1) % n, j) = n % 2 == 1 ? 2 : 4.0 / 3;
    if (n % 2 == 0) M((j + 2) % n, j) = 0.5;
  }
  const VectorXd zero = VectorXd::Zero(n);
  return {.name = "ben-gharbia-gilbert-" + std::to_string(n),
          .source =
              "I. Ben Gharbia, J. Ch. Gilbert, Nonconvergence of the plain Newton-min "
              "algorithm for linear complementarity problems with a P-matrix, Mathematical "
              "Programming 134, 2012; hnm4lcp",
          .M = M,
          .q = VectorXd::Ones(n),
          .solution = zero,
          .expected = {{lemke, Claim::solved, 0, zero}, {lexicographic, Claim::solved, 0, zero}}};
}

// --- Games ---

/// The equilibria of a bimatrix game as an LCP in (x, y, s+, s-, t+, t-): costs max A - A and
/// max B - B, strategies x and y, and 1'x = 1, 1'y = 1 as pairs of inequalities, repeated for every
/// strategy. A is rows x columns, the payoffs of the row player; B likewise those of the other.
Problem game(const MatrixXd& A, const MatrixXd& B) {
  const Index m = A.rows(), k = A.cols();
  const Index y = m, s_plus = m + k, s_minus = s_plus + m, t_plus = s_minus + m,
              t_minus = t_plus + k, n = t_minus + k;
  Problem lcp;
  lcp.M = MatrixXd::Zero(n, n);
  lcp.M.block(0, y, m, k) = A.maxCoeff() - A.array();
  lcp.M.block(y, 0, k, m) = (B.maxCoeff() - B.array()).transpose();
  lcp.q = VectorXd::Zero(n);
  const auto require_sum_one = [&](Index strategy, Index plus, Index minus, Index size) {
    lcp.M.block(strategy, plus, size, size).setOnes();
    lcp.M.block(strategy, minus, size, size).setConstant(-1);
    lcp.M.block(plus, strategy, size, size).setConstant(-1);
    lcp.M.block(minus, strategy, size, size).setOnes();
    lcp.q.segment(plus, size).setOnes();
    lcp.q.segment(minus, size).setConstant(-1);
  };
  require_sum_one(0, s_plus, s_minus, m);
  require_sum_one(y, t_plus, t_minus, k);
  return lcp;
}

/// M is copositive-plus and the problem feasible, so that Lemke with a sound rule for ties solves
/// it; the first index does not. Both players choosing their third strategy is an equilibrium.
Entry nashpy_degenerate_game() {
  const Problem lcp =
      game(MatrixXd{{1, 3, 3}, {3, 1, 3}, {1, 3, 3}}, MatrixXd{{3, 3, 1}, {1, 1, 3}, {3, 1, 3}});
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
  append({csizmadia(8), ben_gharbia_gilbert(5), ben_gharbia_gilbert(6)});
  append(handbook_exponential());
  append({murty_exponential(4), murty_exponential(8), murty_exponential(12)});
  for (const int variant : {1, 2, 3}) append({fathi(variant, 4), fathi(variant, 8)});
  return all;
}

PublishedInstance published(const Entry& entry) {
  Problem problem;
  problem.M = entry.M;
  problem.q = entry.q;
  problem.c = entry.covering;
  problem.pivot_limit = entry.pivot_limit;
  set_plain_scales(problem);
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
