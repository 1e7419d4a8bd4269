#include "solvers/linalg/basis.h"

#include <algorithm>

#include "solvers/linalg/start.h"

namespace lcp {

Basis::Basis(const ScaledProblem& problem, const std::vector<Index>& alpha,
             const PivotingOptions& options)
    : problem_(problem),
      alpha_(alpha),
      refactor_every_(options.refactor_every),
      labels_(problem.size(), alpha),
      factored_(labels_),
      covering_(covering_of(problem, alpha)) {
  factorise(options.pivot);
}

Eigen::Ref<const VectorXd> Basis::data_column(Variable v) const {
  if (v == factored_.z0()) return covering_;
  return problem_.M().col(factored_.index(v));
}

void Basis::solve_kernel(VectorXd& b) const {
  b = lu_.permutationP() * b;
  lu_.matrixLU().triangularView<Eigen::UnitLower>().solveInPlace(b);
  lu_.matrixLU().triangularView<Eigen::Upper>().solveInPlace(b);
  b = -b;
}

void Basis::factorise(double pivot_tolerance) {
  const Index n = problem_.size();
  etas_.clear();
  factored_ = labels_;
  R_.clear();
  A_rows_.clear();
  for (Index i = 0; i < n; ++i) {
    if (!factored_.is_basic(factored_.w(i))) R_.push_back(i);
    if (!factored_.is_w(factored_.basic(i))) A_rows_.push_back(i);
  }
  const Index k = static_cast<Index>(R_.size());
  columns_.resize(n, k);
  for (Index a = 0; a < k; ++a) columns_.col(a) = data_column(factored_.basic(A_rows_[a]));
  q_ = problem_.q();
  kernel_error_.resize(k);
  usable_ = true;
  if (k == 0) return;

  lu_.compute(columns_(R_, Eigen::all));
  ++factorisations_;
  usable_ = smallest_pivot(lu_.matrixLU()) > pivot_tolerance;
  if (!usable_) return;
  VectorXd x = problem_.q()(R_);
  solve_kernel(x);
  VectorXd y = problem_.q();
  y.noalias() += columns_ * x;
  kernel_error_ = y(R_);
  for (Index row = 0; row < n; ++row)
    if (factored_.is_w(factored_.basic(row))) q_(row) = y(factored_.basic(row));
  q_(A_rows_) = x;
}

VectorXd Basis::kernel_part(Variable v) const {
  VectorXd x;
  if (factored_.is_w(v)) {
    x.resize(static_cast<Index>(R_.size()));
    for (Index r = 0; r < x.size(); ++r) x(r) = R_[r] == v ? -1 : 0;
  } else {
    x = data_column(v)(R_);
  }
  if (x.size() > 0) solve_kernel(x);
  return x;
}

void Basis::factored_column(Variable v, VectorXd& out) const {
  const Index n = problem_.size();
  const VectorXd x = kernel_part(v);
  VectorXd y = factored_.is_w(v) ? VectorXd(VectorXd::Zero(n)) : VectorXd(data_column(v));
  y.noalias() += columns_ * x;
  out.resize(n);
  for (Index row = 0; row < n; ++row)
    if (factored_.is_w(factored_.basic(row))) out(row) = y(factored_.basic(row));
  out(A_rows_) = x;
}

Index Basis::last_left(Variable v) const {
  for (Index t = static_cast<Index>(etas_.size()); t-- > 0;)
    if (etas_[t].left == v) return t;
  return -1;
}

VectorXd Basis::entries_after_leaving(const Eta& eta, const std::vector<Index>& rows) {
  const double inverse = 1 / eta.column(eta.pivot.row);
  VectorXd entries = inverse * eta.column(rows);
  for (std::size_t t = 0; t < rows.size(); ++t)
    if (rows[t] == eta.pivot.row) entries(static_cast<Index>(t)) = inverse;
  return entries;
}

void Basis::factored_entries(Variable v, const std::vector<Index>& rows, VectorXd& out) const {
  const VectorXd x = kernel_part(v);
  out.resize(static_cast<Index>(rows.size()));
  for (Index t = 0; t < out.size(); ++t) {
    const Variable basic = factored_.basic(rows[t]);
    if (factored_.is_w(basic)) {
      const double own = factored_.is_w(v) ? 0 : data_column(v)(basic);
      out(t) = own + columns_.row(basic).dot(x);
    } else {
      const auto place = std::lower_bound(A_rows_.begin(), A_rows_.end(), rows[t]);
      out(t) = x(place - A_rows_.begin());
    }
  }
}

void Basis::column(Variable v, VectorXd& out) {
  Index next = last_left(v);
  if (next < 0) {
    factored_column(v, out);
  } else {
    const Eta& eta = etas_[next];
    const double inverse = 1 / eta.column(eta.pivot.row);
    out = inverse * eta.column;
    out(eta.pivot.row) = inverse;
  }
  for (++next; next < static_cast<Index>(etas_.size()); ++next) {
    const Eta& eta = etas_[next];
    const Index r = eta.pivot.row;
    const double theta = -out(r) / eta.column(r);
    out += theta * eta.column;
    out(r) = theta;
  }
}

void Basis::entries(Variable v, const std::vector<Index>& rows, VectorXd& out) {
  const Index asked = static_cast<Index>(rows.size());
  const Index pivots = static_cast<Index>(etas_.size());
  // The rows asked for, then the pivot rows of the etas, on whose entries the others depend.
  std::vector<Index> followed = rows;
  for (const Eta& eta : etas_) followed.push_back(eta.pivot.row);

  Index next = last_left(v);
  if (next < 0) {
    factored_entries(v, followed, out);
  } else {
    out = entries_after_leaving(etas_[next], followed);
  }
  for (++next; next < pivots; ++next) {
    const Eta& eta = etas_[next];
    const double theta = -out(asked + next) / eta.column(eta.pivot.row);
    for (Index t = 0; t < asked + pivots; ++t) {
      const Index row = followed[t];
      out(t) = row == eta.pivot.row ? theta : out(t) + theta * eta.column(row);
    }
  }
  out.conservativeResize(asked);
}

Variable Basis::pivot(const Pivot& pivot, const VectorXd& column) {
  const Variable leaving = labels_.exchange(pivot);
  if (static_cast<Index>(etas_.size()) + 1 >= refactor_every_) {
    factorise(0);
    return leaving;
  }
  const double theta = -q_(pivot.row) / column(pivot.row);
  q_ += theta * column;
  q_(pivot.row) = theta;
  etas_.push_back({pivot, leaving, column});
  return leaving;
}

void Basis::rebuild(const std::vector<Pivot>& path) {
  labels_ = Labels(problem_.size(), alpha_);
  for (const Pivot& step : path) labels_.exchange(step);
  factorise(0);
}

double Basis::error() const {
  if (etas_.empty()) return kernel_error_.size() > 0 ? kernel_error_.lpNorm<Eigen::Infinity>() : 0;
  VectorXd residual = problem_.q();
  for (Index row = 0; row < problem_.size(); ++row) {
    const Variable v = labels_.basic(row);
    if (labels_.is_w(v)) {
      residual(v) -= q_(row);
    } else {
      residual += q_(row) * data_column(v);
    }
  }
  return residual.lpNorm<Eigen::Infinity>();
}

}  // namespace lcp
