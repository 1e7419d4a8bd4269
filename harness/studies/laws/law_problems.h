#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solvers/problem.h"

namespace lcp {

/// A problem whose solution is known.
struct SolvedProblem {
  Problem problem;
  VectorXd z;
};

/// An LCP with a P-matrix, so that its solution is the only one: M = A A'/n + I, plus a skew part
/// unless `symmetric`; z and w are drawn strictly complementary and q = w - M z. Same arguments, same
/// bits.
SolvedProblem strictly_complementary(Index n, std::uint64_t seed, bool symmetric);

/// The problem and its solution in the order `order`: new row i is old row order[i].
SolvedProblem permuted(const SolvedProblem& solved, const std::vector<Index>& order);

struct NamedProblem {
  std::string name;
  Problem problem;
};

/// Small problems of each kind a method meets: with one solution, many, none, and one that Lemke's
/// path misses; and a contact problem with blocks and a W of rank 3 in 6.
std::vector<NamedProblem> sample_problems();

/// M and q with the plain scales.
Problem plain_problem(MatrixXd M, VectorXd q);

}  // namespace lcp
