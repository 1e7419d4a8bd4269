// semidefinite: positive semidefinite M of given rank with a planted, degenerate solution.
//
// What      M = A ((1 - s) I + s J) A' with A n x rank of full column rank, J skew-symmetric, s = skew.
//           x'Mx = (1 - s) |A'x|^2 >= 0, and since the middle factor is positive definite, M has
//           exactly the rank of A. z and w with the chosen pairs are drawn first, q = w - M z.
// Reals     A A' has nonzero eigenvalues from 1 / condition to 1, both taken; |J|_2 = 1; planted
//           entries in [0.1, 1). Rank, pairs and solution hold to rounding.
// Integers  integer=on: M = A A' (skew=0) or A (I + J) A' (skew=0.5, twice the above), A uniform in
//           -3 ... 3 and drawn again while its columns are dependent, J in {-1, 0, 1}, planted
//           entries in 1 ... 9. M and q are integers below 2^53, so that they and the solution are
//           exact to the bit, whatever the order of the sums, and the rank is exactly `rank`. The
//           condition is what comes out: 13 ... 34 at n = 40, rank = 20, 1e3 ... 2e5 at rank = 40.
// Solution  One of many unless M_aa is regular: with more active pairs than rank it is no vertex.
// Seed      Of the generator from which all instances of a draw come, one after the other.
// Class     Positive semidefinite, hence copositive-plus: the problem is feasible, so that Lemke with a
//           sound rule for ties solves it in exact arithmetic.
// Source    R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity Problem, 2009, 3.1
//           and 4.4.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "problems/drawing/matrices.h"
#include "problems/drawing/planted.h"
#include "problems/registry.h"
#include "solvers/errors.h"

namespace lcp {
namespace {

constexpr Index kLargest = 1000;        // Rows.
constexpr Index kFactorEntries = 3;     // Of A, integer=on.
constexpr Index kPlantedEntries = 9;    // Of z and w, integer=on.
constexpr double kAutoCondition = 100;  // Without integer=on.
constexpr const char* kSource = "random positive semidefinite matrix with a planted solution";

// |q_i| <= w_i + sum over n columns of M of (rank + rank^2 terms of A, I + J, A') times z.
static_assert(kPlantedEntries * (1 + kLargest * (kLargest + kLargest * kLargest) * kFactorEntries *
                                         kFactorEntries) <
              Index{1} << 53);

struct SemidefiniteKnobs {
  Index n = 40;
  Index rank = 0;
  double condition = std::numeric_limits<double>::quiet_NaN();
  double skew = 0;
  Index active = 0;
  Index degenerate = 4;
  bool integer = false;
};

OptionTable knob_table(SemidefiniteKnobs& knobs) {
  return {
      count("n", knobs.n, 2, kLargest, "rows"),
      count_or("rank", knobs.rank, 1, kLargest, "half", "of M; half of n"),
      real_or("condition", knobs.condition, 1, 1e8, "auto",
              "largest over smallest nonzero eigenvalue of the symmetric part; auto is 100, or "
              "what the integers give"),
      real("skew", knobs.skew, 0, 0.99,
           "share of the skew-symmetric part; with integer=on 0 or 0.5"),
      count_or("active", knobs.active, 1, kLargest, "half", "pairs with z_i > 0; half of n"),
      count("degenerate", knobs.degenerate, 0, kLargest, "pairs with z_i = w_i = 0"),
      flag("integer", knobs.integer, "small integers: M, q, rank and solution are exact"),
  };
}

void refuse(const std::string& offence, const std::string& expected) {
  throw InvalidArgument("semidefinite: {}: expected {}", offence, expected);
}

/// Throws unless the knobs agree with one another; `knobs` has its words replaced by numbers.
void check(const SemidefiniteKnobs& knobs) {
  if (knobs.rank > knobs.n)
    refuse(fmt::format("rank={}", knobs.rank), fmt::format("at most n={}", knobs.n));
  if (knobs.integer) {
    if (!std::isnan(knobs.condition))
      refuse(fmt::format("condition={} with integer=on", knobs.condition), "condition=auto");
    if (knobs.skew != 0 && knobs.skew != 0.5)
      refuse(fmt::format("skew={} with integer=on", knobs.skew), "0 or 0.5");
  } else if (knobs.rank == 1 && knobs.condition > 1) {
    refuse(fmt::format("condition={} with rank=1", knobs.condition), "condition=auto or 1");
  }
  if (knobs.rank == 1 && knobs.skew > 0)
    refuse(fmt::format("skew={} with rank=1", knobs.skew), "skew=0 or a rank of 2 or more");
}

MatrixXd real_matrix(const SemidefiniteKnobs& knobs, Random& random) {
  const double condition = std::isnan(knobs.condition) ? kAutoCondition : knobs.condition;
  const VectorXd root = spread_spectrum(knobs.rank, condition, random).cwiseSqrt();
  const MatrixXd A = orthonormal_columns(knobs.n, knobs.rank, random) * root.asDiagonal();
  const MatrixXd S = gram_matrix(A);
  if (knobs.skew == 0) return S;
  const MatrixXd K = A * skew_matrix(knobs.rank, random) * A.transpose();
  return (1 - knobs.skew) * S + knobs.skew / 2 * (K - K.transpose());
}

/// Whether the columns, small integers, are independent modulo a prime; then they are independent. The
/// converse fails for one matrix in 10^9.
bool independent_columns(const MatrixXd& A) {
  constexpr std::int64_t prime = 2147483647;
  using Integers = Eigen::Matrix<std::int64_t, Eigen::Dynamic, Eigen::Dynamic>;
  const auto modulo = [](std::int64_t a) { return (a % prime + prime) % prime; };
  Integers rest = A.cast<std::int64_t>().unaryExpr(modulo);
  for (Index c = 0; c < rest.cols(); ++c) {
    Index pivot = c;
    while (pivot < rest.rows() && rest(pivot, c) == 0) ++pivot;
    if (pivot == rest.rows()) return false;
    rest.row(c).swap(rest.row(pivot));
    // Columns are combined without division: column j times the pivot less column c times its entry.
    for (Index j = c + 1; j < rest.cols(); ++j) {
      const std::int64_t entry = rest(c, j);
      for (Index i = c; i < rest.rows(); ++i)
        rest(i, j) = modulo(modulo(rest(i, j) * rest(c, c)) - modulo(entry * rest(i, c)));
    }
  }
  return true;
}

/// n x rank, uniform entries, drawn again while its columns are dependent.
MatrixXd integer_factor(const SemidefiniteKnobs& knobs, Random& random) {
  MatrixXd A(knobs.n, knobs.rank);
  do {
    for (Index j = 0; j < knobs.rank; ++j)
      for (Index i = 0; i < knobs.n; ++i)
        A(i, j) = static_cast<double>(random.integer(-kFactorEntries, kFactorEntries));
  } while (!independent_columns(A));
  return A;
}

MatrixXd integer_matrix(const SemidefiniteKnobs& knobs, Random& random) {
  const MatrixXd A = integer_factor(knobs, random);
  MatrixXd middle = MatrixXd::Identity(knobs.rank, knobs.rank);
  if (knobs.skew > 0) {
    for (Index j = 0; j < knobs.rank; ++j)
      for (Index i = 0; i < j; ++i) {
        middle(i, j) = static_cast<double>(random.integer(-1, 1));
        middle(j, i) = -middle(i, j);
      }
  }
  return A * middle * A.transpose();
}

std::vector<Instance> generate_semidefinite(SemidefiniteKnobs knobs, const Draw& draw) {
  if (knobs.rank == 0) knobs.rank = knobs.n / 2;
  if (knobs.active == 0) knobs.active = knobs.n / 2;
  check(knobs);
  Random random(draw.seed);
  const auto positive = [&] {
    return knobs.integer ? static_cast<double>(random.integer(1, kPlantedEntries))
                         : random.between(0.1, 1);
  };
  std::vector<Instance> instances;
  for (Index k = 0; k < draw.count; ++k) {
    const PlantedPairs pairs =
        planted_pairs(knobs.n, knobs.active, knobs.degenerate, positive, random, "semidefinite");
    const MatrixXd M = knobs.integer ? integer_matrix(knobs, random) : real_matrix(knobs, random);
    instances.push_back(drawn_instance(draw, k, M, pairs, kSource));
  }
  return instances;
}

const FamilyRegistration semidefinite{
    {"semidefinite",
     "positive semidefinite M of given rank, a planted solution with degenerate pairs",
     "Cottle, Pang and Stone 2009, 3.1 and 4.4", 20},
    SemidefiniteKnobs{},
    knob_table,
    generate_semidefinite};

}  // namespace
}  // namespace lcp
