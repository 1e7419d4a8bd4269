// Projected Gauss-Seidel: the iterative baseline, contact by contact where there are contacts.
//
// Source    F. Jourdan, P. Alart, M. Jean (1998), "A Gauss-Seidel like algorithm to solve
//           frictional contact problems"; R. Cottle, J.-S. Pang, R. Stone, The Linear
//           Complementarity Problem, 5.2 (plain form). References [4] and [2] of Yamane and
//           Nakamura (2008).
// Notation  Plain: z_i <- max(0, z_i - w_i / M_ii), rows in order, each with the newest z.
//           Contacts: f_n <- max(0, f_n - u_n / W_nn), then f_t <- P(f_t - rho u_t) with u = W f +
//           vbar, rho = 1 / trace(W_tt), and P the Euclidean projection onto the polygon mu f_n
//           conv{c_m}. The scalar rho is on purpose: with W_tt^-1 as the step the projection is one
//           in another metric, whose fixed points are not solutions of (25).
// Mapped    lambda = max(0, max_m -c_m'u), b = coefficients of f_t on the two directions next to
//           it.
// Cost      n^2 multiply-adds a sweep, plain; 9 Nc^2 with contacts, plus m Nc for the projections;
//           every `check_every` sweeps one product with M, n^2. Memory: a transpose of M or W.
// Class     Plain: converges for symmetric positive definite, strictly diagonally dominant and
//           H-matrices with positive diagonal. Contacts: no theorem with friction; slow, or never
//           there, when W is rank-deficient or badly conditioned. A fixed point is a solution.
//           Rounding only limits the residual that can be reached.
// Start     A point z (n): plain, z itself; with contacts, the forces f_n = a, f_t = sum b_m c_m.
//           A start without a point is `unsupported`.
// Differs   from the pivoting rows: there is no basis, hence no starting basis, and the answer is
//           as good as `tolerance`. It claims `solved` only by the natural residual of the LCP
//           itself.

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "solvers/errors.h"
#include "solvers/linalg/natural_residual.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

using Eigen::Vector2d;

struct GaussSeidelOptions {
  Index max_sweeps = 10000;
  double tolerance = 1e-8;
  Index check_every = 10;
};

OptionTable option_table(GaussSeidelOptions& options) {
  return {
      count("max_sweeps", options.max_sweeps, 1, 1000000000, "sweeps before giving up (limit)"),
      real("tolerance", options.tolerance, 0, 1,
           "natural residual max |min(z / s_z, w / s_w)| that counts as solved; dimensionless")
          .accuracy({"1e-02", "1e-04", "1e-06", "1e-08", "1e-10", "1e-12"}),
      count("check_every", options.check_every, 1, 1000000, "sweeps between looks at the residual"),
  };
}

/// max(0, x), but a NaN stays one, so that it is seen.
double positive_part(double x) { return x < 0 ? 0 : x; }

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Point of the segment from `a` to `b` nearest to `x`.
Vector2d nearest_on_segment(const Vector2d& a, const Vector2d& b, const Vector2d& x) {
  const Vector2d edge = b - a;
  const double length2 = edge.squaredNorm();
  if (!(length2 > 0)) return a;
  return a + std::clamp(edge.dot(x - a) / length2, 0.0, 1.0) * edge;
}

/// Euclidean projection of `x` onto radius conv{c_m}, the columns of `directions` in ascending
/// angle.
Vector2d project(const Eigen::Ref<const MatrixXd>& directions, double radius, const Vector2d& x) {
  const Index m = directions.cols();
  bool inside = true;
  Vector2d nearest = x;
  double least = std::numeric_limits<double>::infinity();
  for (Index k = 0; k < m; ++k) {
    const Vector2d a = radius * directions.col(k), b = radius * directions.col((k + 1) % m);
    inside = inside && cross(b - a, x - a) > 0;
    const Vector2d candidate = nearest_on_segment(a, b, x);
    const double distance = (candidate - x).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return inside ? x : nearest;
}

/// Non-negative coefficients b (m) with C b = x, zero but for the two directions next to x.
VectorXd cone_coefficients(const Eigen::Ref<const MatrixXd>& directions, const Vector2d& x) {
  const Index m = directions.cols();
  VectorXd b = VectorXd::Zero(m);
  if (m == 2) {  // Directions on one line enclose no sector.
    for (Index k = 0; k < m; ++k) b(k) = positive_part(directions.col(k).dot(x));
    return b;
  }
  Index sector = 0;
  Vector2d shares = Vector2d::Constant(-std::numeric_limits<double>::infinity());
  for (Index k = 0; k < m; ++k) {
    const Vector2d c = directions.col(k), next = directions.col((k + 1) % m);
    const Vector2d candidate = Vector2d(cross(x, next), cross(c, x)) / cross(c, next);
    if (candidate.minCoeff() <= shares.minCoeff()) continue;
    sector = k;
    shares = candidate;
  }
  b(sector) = positive_part(shares(0));
  b((sector + 1) % m) = positive_part(shares(1));
  return b;
}

/// The plain method on M.
class Rows {
 public:
  Rows(const Problem& problem, const VectorXd& start)
      : problem_(problem), z_(start), M_rows_(problem.M) {}

  static std::string obstacle(const Problem& problem) {
    for (Index i = 0; i < problem.size(); ++i)
      if (!(problem.M(i, i) > 0))
        return fmt::format("needs a positive diagonal, M({}, {}) is {}", i, i, problem.M(i, i));
    return {};
  }

  void sweep() {
    for (Index i = 0; i < z_.size(); ++i) {
      const double w = M_rows_.row(i).dot(z_) + problem_.q(i);
      z_(i) = positive_part(z_(i) - w / M_rows_(i, i));
    }
  }

  VectorXd z() const { return z_; }

 private:
  const Problem& problem_;
  VectorXd z_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> M_rows_;
};

/// The method on contact blocks, one contact at a time.
class Contacts {
 public:
  Contacts(const Problem& problem, const VectorXd& start)
      : n_(problem.size()),
        blocks_(*problem.friction),
        W_transposed_(blocks_.W.transpose()),
        forces_(VectorXd::Zero(3 * blocks_.contacts())) {
    const Index m = blocks_.directions_per_contact;
    for (Index i = 0; i < blocks_.contacts(); ++i) {
      forces_(3 * i) = start(blocks_.normal_row[i]);
      if (blocks_.friction_row[i] >= 0)
        forces_.segment<2>(3 * i + 1) = directions(i) * start.segment(blocks_.friction_row[i], m);
    }
  }

  static std::string obstacle(const Problem& problem) {
    const FrictionBlocks& blocks = *problem.friction;
    for (Index i = 0; i < blocks.contacts(); ++i) {
      if (!(blocks.W(3 * i, 3 * i) > 0))
        return fmt::format("needs a positive normal diagonal, W_nn of contact {} is {}", i,
                           blocks.W(3 * i, 3 * i));
      if (blocks.mu(i) > 0 && !(tangential_trace(blocks, i) > 0))
        return fmt::format(
            "needs a positive tangential diagonal, trace of W_tt of contact {} is {}", i,
            tangential_trace(blocks, i));
    }
    return {};
  }

  void sweep() {
    for (Index i = 0; i < blocks_.contacts(); ++i) {
      double& normal = forces_(3 * i);
      normal = positive_part(normal - velocity<1>(3 * i)(0) / blocks_.W(3 * i, 3 * i));
      if (blocks_.friction_row[i] < 0) continue;
      const Vector2d step = velocity<2>(3 * i + 1) / tangential_trace(blocks_, i);
      forces_.segment<2>(3 * i + 1) =
          project(directions(i), blocks_.mu(i) * normal, forces_.segment<2>(3 * i + 1) - step);
    }
  }

  /// The forces as unknowns of (25).
  VectorXd z() const {
    VectorXd z = VectorXd::Zero(n_);
    for (Index i = 0; i < blocks_.contacts(); ++i) {
      z(blocks_.normal_row[i]) = forces_(3 * i);
      if (blocks_.friction_row[i] < 0) continue;
      z.segment(blocks_.friction_row[i], blocks_.directions_per_contact) =
          cone_coefficients(directions(i), forces_.segment<2>(3 * i + 1));
      const Vector2d slip = velocity<2>(3 * i + 1);
      z(blocks_.cone_row[i]) = positive_part(-(directions(i).transpose() * slip).minCoeff());
    }
    return z;
  }

 private:
  static double tangential_trace(const FrictionBlocks& blocks, Index contact) {
    return blocks.W(3 * contact + 1, 3 * contact + 1) + blocks.W(3 * contact + 2, 3 * contact + 2);
  }

  /// Columns c_1 ... c_m of one contact.
  Eigen::Ref<const MatrixXd> directions(Index contact) const {
    const Index m = blocks_.directions_per_contact;
    return blocks_.directions.middleCols(contact * m, m);
  }

  /// Entries of W f + vbar from `first`.
  template <int Size>
  Eigen::Matrix<double, Size, 1> velocity(Index first) const {
    return W_transposed_.middleCols<Size>(first).transpose() * forces_ +
           blocks_.vbar.segment<Size>(first);
  }

  Index n_;
  const FrictionBlocks& blocks_;
  MatrixXd W_transposed_;  ///< Rows of W as columns: measured ones are not quite symmetric.
  VectorXd forces_;
};

/// Sweeps from `start` (n) until the residual of the LCP is small, the sweeps run out, or the numbers do.
template <class Iteration>
Result iterate(const Problem& problem, const GaussSeidelOptions& options, const VectorXd& start) {
  Result result;
  result.z = VectorXd::Zero(problem.size());
  result.message = Iteration::obstacle(problem);
  if (!result.message.empty()) {
    result.claim = Claim::unsupported;
    return result;
  }
  Iteration iteration(problem, start);
  VectorXd w;
  while (true) {
    const VectorXd z = iteration.z();
    const double residual = natural_residual(problem, z, w);
    if (!std::isfinite(residual)) {
      result.claim = Claim::singular;
      result.message = "the iterates grew beyond finite numbers";
      return result;
    }
    result.z = z;
    result.w = w;
    if (residual <= options.tolerance) {
      result.claim = Claim::solved;
      return result;
    }
    if (result.work.sweeps == options.max_sweeps) {
      result.claim = Claim::limit;
      result.message = fmt::format("residual {:.2g} after {} sweeps", residual, result.work.sweeps);
      return result;
    }
    const Index sweeps = std::min(options.check_every, options.max_sweeps - result.work.sweeps);
    for (Index k = 0; k < sweeps; ++k) iteration.sweep();
    result.work.sweeps += sweeps;
  }
}

/// Throws std::invalid_argument unless it has n finite entries.
const VectorXd& checked_point(const VectorXd& z, Index n) {
  if (z.size() != n)
    throw InvalidArgument("starting point has {} entries, expected {}", z.size(), n);
  if (!z.allFinite()) throw std::invalid_argument("starting point is not finite");
  return z;
}

Result solve(const Problem& problem, const GaussSeidelOptions& options, const Call& call) {
  VectorXd start = VectorXd::Zero(problem.size());
  if (call.start && call.start->z.size() == 0 && problem.size() > 0) {
    Result result;
    result.claim = Claim::unsupported;
    result.message = "takes no starting basis";
    result.z = start;
    return result;
  }
  if (call.start) start = checked_point(call.start->z, problem.size());
  return problem.friction ? iterate<Contacts>(problem, options, start)
                          : iterate<Rows>(problem, options, start);
}

const Registration projected_gauss_seidel{
    {.name = "projected-gauss-seidel",
     .summary = "sweeps over rows, or over contacts with projection onto the friction polygon",
     .source = "Jourdan, Alart, Jean 1998; Cottle, Pang, Stone, 5.2",
     .kind = RowInfo::Kind::iterative,
     .supports = "a positive diagonal, or contacts with friction blocks",
     .in_suites = {.place = 4}},
    GaussSeidelOptions{},
    option_table,
    solve};

}  // namespace
}  // namespace lcp
