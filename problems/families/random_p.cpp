// random-p: random P-matrices of three kinds with a planted solution.
//
// What      kind=definite    M = (1 - s) S + s K: S symmetric positive definite with eigenvalues from
//                            1 / condition to 1, both taken, K skew-symmetric, |K|_2 = 1, s = skew.
//                            x'Mx = (1 - s) x'Sx > 0, so M is positive definite, hence P.
//           kind=dominant    M = D (I + O) D: row sums of |O| at most 0.99, so that I + O is strictly
//                            row-dominant; O = (1 - s) R + s T with R symmetric and T skew-symmetric,
//                            uniform entries. Every principal minor of I + O is positive, and D, a
//                            positive diagonal, multiplies it by positive numbers: M is an H-matrix.
//           kind=triangular  M = D L D with the variables relabelled at random: L unit lower
//                            triangular, entries below uniform in +-4 / sqrt(n). Principal minors are
//                            products of the diagonal. M is not definite: x'Mx took both signs in
//                            all draws tried, n = 8 ... 100. There is no skew share to choose.
//           In the last two D^2 runs from 1 / condition to 1, both taken.
// Condition definite: exactly that of S, and of M with skew=0; a skew part lifts the small singular
//           values of M: with skew=half 1e6 left 31 ... 138 at n = 40. dominant: M has it within
//           10 % from 100 on. triangular: more, for 1 it is 63 ... 126, for 1e6 2e6 ... 8e6 (n = 40).
// Solution  z and w are drawn first, 0 or in [0.1, 1), and q = w - M z in double: the pairs hold to
//           rounding, a few 1e-16 n |M|. A P-matrix has no second solution.
// Seed      Of the generator from which all instances of a draw come, one after the other.
// Source    R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity Problem, 2009, 3.3.

#include <cmath>
#include <limits>

#include "problems/drawing/matrices.h"
#include "problems/drawing/planted.h"
#include "problems/registry.h"
#include "solvers/errors.h"

namespace lcp {
namespace {

enum class Kind { definite, dominant, triangular };

constexpr double kDominance = 0.99;       // Largest row sum of |O|.
constexpr double kTriangularEntries = 4;  // Largest entry of L, times sqrt(n).
constexpr double kHalfSkew = 0.5;
constexpr const char* kSource = "random P-matrix with a planted solution";

struct RandomPKnobs {
  Kind kind = Kind::definite;
  Index n = 40;
  double skew = std::numeric_limits<double>::quiet_NaN();
  double condition = 100;
  Index active = 0;
  Index degenerate = 0;
};

OptionTable knob_table(RandomPKnobs& knobs) {
  return {
      choice("kind", knobs.kind, "positive definite, H-matrix, or relabelled triangular"),
      count("n", knobs.n, 2, 1000, "rows"),
      real_or("skew", knobs.skew, 0, 0.99, "half",
              "share of the skew-symmetric part, 0 is symmetric; half is 0.5, and all that "
              "kind=triangular takes"),
      real("condition", knobs.condition, 1, 1e10,
           "of the symmetric part (definite), or of the diagonal (dominant, triangular)"),
      count_or("active", knobs.active, 1, 1000, "half", "pairs with z_i > 0"),
      count("degenerate", knobs.degenerate, 0, 1000, "pairs with z_i = w_i = 0"),
  };
}

double skew_share(const RandomPKnobs& knobs) {
  return std::isnan(knobs.skew) ? kHalfSkew : knobs.skew;
}

MatrixXd definite(const RandomPKnobs& knobs, Random& random) {
  const MatrixXd Q = orthonormal_columns(knobs.n, knobs.n, random);
  const VectorXd eigenvalues = spread_spectrum(knobs.n, knobs.condition, random);
  const MatrixXd S = gram_matrix(Q * eigenvalues.cwiseSqrt().asDiagonal());
  const double s = skew_share(knobs);
  return (1 - s) * S + s * skew_matrix(knobs.n, random);
}

/// D core D.
MatrixXd scaled_both_sides(const MatrixXd& core, const RandomPKnobs& knobs, Random& random) {
  const VectorXd D = spread_spectrum(knobs.n, knobs.condition, random).cwiseSqrt();
  return D.asDiagonal() * core * D.asDiagonal();
}

MatrixXd dominant(const RandomPKnobs& knobs, Random& random) {
  const double s = skew_share(knobs);
  const MatrixXd U = uniform_matrix(knobs.n, knobs.n, random);
  const MatrixXd upper = U.triangularView<Eigen::StrictlyUpper>();
  const MatrixXd O = upper + (1 - 2 * s) * upper.transpose();
  const double largest = O.cwiseAbs().rowwise().sum().maxCoeff();
  const MatrixXd core = MatrixXd::Identity(knobs.n, knobs.n) + kDominance / largest * O;
  return scaled_both_sides(core, knobs, random);
}

MatrixXd triangular(const RandomPKnobs& knobs, Random& random) {
  const double largest = kTriangularEntries / std::sqrt(static_cast<double>(knobs.n));
  MatrixXd L = largest * uniform_matrix(knobs.n, knobs.n, random);
  L.triangularView<Eigen::StrictlyUpper>().setZero();
  L.diagonal().setOnes();
  const MatrixXd M = scaled_both_sides(L, knobs, random);
  const std::vector<Index> places = random.permutation(knobs.n);
  return M(places, places);
}

MatrixXd random_p_matrix(const RandomPKnobs& knobs, Random& random) {
  switch (knobs.kind) {
    case Kind::definite:
      return definite(knobs, random);
    case Kind::dominant:
      return dominant(knobs, random);
    case Kind::triangular:
      return triangular(knobs, random);
  }
  return {};
}

std::vector<Instance> generate_random_p(const RandomPKnobs& knobs, const Draw& draw) {
  if (knobs.kind == Kind::triangular && !std::isnan(knobs.skew))
    throw InvalidArgument(
        "random-p: skew={} with kind=triangular: expected skew=half, or another kind", knobs.skew);
  const Index active = knobs.active > 0 ? knobs.active : knobs.n / 2;
  Random random(draw.seed);
  std::vector<Instance> instances;
  for (Index k = 0; k < draw.count; ++k) {
    const PlantedPairs pairs = planted_pairs(
        knobs.n, active, knobs.degenerate, [&] { return random.between(0.1, 1); }, random,
        "random-p");
    instances.push_back(drawn_instance(draw, k, random_p_matrix(knobs, random), pairs, kSource));
  }
  return instances;
}

const FamilyRegistration random_p{
    {"random-p", "random P-matrices, definite, dominant or triangular, with a planted solution",
     "Cottle, Pang and Stone 2009, 3.3", 20},
    RandomPKnobs{},
    knob_table,
    generate_random_p};

}  // namespace
}  // namespace lcp
