#include "solvers/linalg/tableau.h"

#include <algorithm>

#include "solvers/linalg/start.h"

namespace lcp {

namespace {

/// Pivots between two snapshots: returning costs at most this many more than the paths differ in.
constexpr std::size_t snapshot_every = 16;

}  // namespace

Tableau::Tableau(const ScaledProblem& problem, const std::vector<Index>& alpha,
                 const PivotingOptions& options)
    : problem_(problem),
      alpha_(alpha),
      labels_(problem.size(), alpha),
      columns_(problem.size(), problem.size() + 1),
      place_(2 * problem.size() + 1),
      covering_(covering_of(problem, alpha)) {
  set_first_dictionary(options.pivot);
}

void Tableau::set_first_dictionary(double pivot_tolerance) {
  const Index n = problem_.size();
  const MatrixXd& M = problem_.M();
  labels_ = Labels(n, alpha_);
  for (Index i = 0; i < n; ++i) place_[labels_.complement(labels_.basic(i))] = i;
  place_[labels_.z0()] = n;
  if (alpha_.empty()) {
    columns_.leftCols(n) = M;
    columns_.col(n) = covering_;
    q_ = problem_.q();
    return;
  }
  const std::vector<Index> rest = complement_of(alpha_, n);
  const Eigen::PartialPivLU<MatrixXd> lu(M(alpha_, alpha_));
  ++factorisations_;
  usable_ = smallest_pivot(lu.matrixLU()) > pivot_tolerance;
  if (!usable_) {
    q_ = problem_.q();
    return;
  }
  const MatrixXd inverse = lu.inverse();
  const MatrixXd coupling = lu.solve(M(alpha_, rest));
  columns_(alpha_, alpha_) = inverse;
  columns_(alpha_, rest) = -coupling;
  columns_(rest, alpha_) = M(rest, alpha_) * inverse;
  columns_(rest, rest) = M(rest, rest) - M(rest, alpha_) * coupling;
  columns_.col(n).setOnes();
  const VectorXd z_alpha = -lu.solve(problem_.q()(alpha_));
  q_ = problem_.q();
  q_(rest) += M(rest, alpha_) * z_alpha;
  q_(alpha_) = z_alpha;
}

void Tableau::entries(Variable v, const std::vector<Index>& rows, VectorXd& out) const {
  out = columns_.col(place_[v])(rows);
}

Variable Tableau::pivot(const Pivot& pivot, const VectorXd& column) {
  const Index r = pivot.row, place = place_[pivot.entering];
  const double size = column(r);  // divided by, not multiplied by its inverse: one rounding less
  for (Index j = 0; j < columns_.cols(); ++j) {
    if (j == place) continue;
    const double factor = -columns_(r, j) / size;
    if (factor != 0) columns_.col(j) += factor * column;
    columns_(r, j) = factor;
  }
  columns_.col(place) = column / size;
  columns_(r, place) = 1 / size;
  const double theta = -q_(r) / size;
  q_ += theta * column;
  q_(r) = theta;
  const Variable leaving = labels_.exchange(pivot);
  place_[leaving] = place;
  path_.push_back(pivot);
  if (returns_ && path_.size() % snapshot_every == 0)
    snapshots_.push_back({path_.size(), labels_, columns_, place_, q_});
  return leaving;
}

void Tableau::rebuild(const std::vector<Pivot>& path) {
  const auto fork = std::mismatch(path.begin(), path.end(), path_.begin(), path_.end()).first;
  const std::size_t shared = fork - path.begin();
  while (!snapshots_.empty() && snapshots_.back().depth > shared) snapshots_.pop_back();
  if (snapshots_.empty()) {
    set_first_dictionary(0);
    path_.clear();
  } else {
    const Snapshot& last = snapshots_.back();
    labels_ = last.labels;
    columns_ = last.columns;
    place_ = last.place;
    q_ = last.q;
    path_.resize(last.depth);
  }
  returns_ = true;
  VectorXd m;
  while (path_.size() < path.size()) {
    const Pivot& step = path[path_.size()];
    column(step.entering, m);
    pivot(step, m);
    ++replayed_;
  }
}

double Tableau::error() const {
  const Index n = problem_.size();
  VectorXd residual = problem_.q();
  for (Index row = 0; row < n; ++row) {
    const Variable v = labels_.basic(row);
    if (labels_.is_w(v)) {
      residual(v) -= q_(row);
    } else if (v == labels_.z0()) {
      residual += q_(row) * covering_;
    } else {
      residual += q_(row) * problem_.M().col(labels_.index(v));
    }
  }
  return n > 0 ? residual.lpNorm<Eigen::Infinity>() : 0;
}

}  // namespace lcp
