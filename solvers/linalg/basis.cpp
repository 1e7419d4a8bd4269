#include "solvers/linalg/basis.h"

#include <algorithm>
#include <limits>

#include "solvers/linalg/columns.h"
#include "solvers/linalg/start.h"

namespace lcp {

namespace {

/// error_within() factorises afresh where its estimate is not this much smaller than what is asked.
constexpr double kTrust = 1000;

}  // namespace

Basis::Basis(const ScaledProblem& problem, const std::vector<Index>& alpha,
             const PivotingOptions& options)
    : problem_(problem),
      alpha_(alpha),
      refactor_every_(options.refactor_every),
      labels_(problem.size(), alpha),
      factored_(labels_) {
  etas_.reserve(refactor_every_ - 1);
  for (std::vector<Index>* list : {&R_, &A_rows_, &A_columns_}) list->reserve(problem.size());
  factorise(options.pivot);
}

const VectorXd& Basis::covering() const {
  if (covering_.size() == 0) covering_ = covering_of(problem_, alpha_);
  return covering_;
}

void Basis::solve_kernel(VectorXd& b) const {
  const auto& place = lu_.permutationP().indices();
  permuted_.resize(b.size());
  for (Index r = 0; r < b.size(); ++r) permuted_(place(r)) = -b(r);
  b.swap(permuted_);
  lu_.matrixLU().triangularView<Eigen::UnitLower>().solveInPlace(b);
  lu_.matrixLU().triangularView<Eigen::Upper>().solveInPlace(b);
}

void Basis::factorise(double pivot_tolerance) {
  const Index n = problem_.size();
  pivots_ = 0;
  drift_ = 0;
  growth_ = 1;
  kernel_error_ = 0;
  factored_ = labels_;
  R_.clear();
  A_rows_.clear();
  A_columns_.clear();
  z0_place_ = -1;
  w_of_row_.resize(n);
  for (Index i = 0; i < n; ++i) {
    if (!factored_.is_basic(factored_.w(i))) R_.push_back(i);
    const Variable v = factored_.basic(i);
    w_of_row_[i] = factored_.is_w(v) ? v : 0;
    if (factored_.is_w(v)) continue;
    if (v == factored_.z0()) {
      z0_place_ = static_cast<Index>(A_rows_.size());
    } else {
      A_columns_.push_back(factored_.index(v));
    }
    A_rows_.push_back(i);
  }
  const Index k = static_cast<Index>(R_.size());
  q_ = problem_.q();
  usable_ = true;
  if (k == 0) return;

  kernel_.resize(k, k);
  for (Index a = 0, j = 0; a < k; ++a) {
    if (a == z0_place_) {
      kernel_.col(a) = covering()(R_);
      continue;
    }
    const double* const column = problem_.stored().col(A_columns_[j]).data();
    const double scale = problem_.column_scale(A_columns_[j++]);
    for (Index r = 0; r < k; ++r)
      kernel_(r, a) = column[R_[r]] * scale * problem_.row_scales()(R_[r]);
  }
  lu_.compute(kernel_);
  ++factorisations_;
  usable_ = smallest_pivot(lu_.matrixLU()) > pivot_tolerance;
  if (!usable_) return;
  x_ = problem_.q()(R_);
  solve_kernel(x_);
  product(x_, -1, y_);
  y_ += problem_.q();
  kernel_residual_ = y_(R_);
  kernel_error_ = kernel_residual_.lpNorm<Eigen::Infinity>();
  spread(y_, x_, q_);
}

void Basis::product(const VectorXd& x, Index j, VectorXd& y) {
  const Index k = x.size();
  coefficients_.resize(k + 1);
  Index count = 0;
  for (Index a = 0; a < k; ++a)
    if (a != z0_place_) {
      coefficients_(count) = x(a) * problem_.column_scale(A_columns_[count]);
      ++count;
    }
  if (j >= 0) {
    A_columns_.push_back(j);
    coefficients_(count) = problem_.column_scale(j);
  }
  y.setZero(problem_.size());
  add_columns(problem_.stored(), A_columns_, coefficients_.data(), y);
  y.array() *= problem_.row_scales().array();
  if (j >= 0) A_columns_.pop_back();
  if (z0_place_ >= 0) y += x(z0_place_) * covering();
}

void Basis::spread(const VectorXd& y, const VectorXd& x, VectorXd& out) const {
  const Index n = problem_.size();
  out.resize(n);
  for (Index row = 0; row < n; ++row) out(row) = y(w_of_row_[row]);
  for (Index a = 0; a < x.size(); ++a) out(A_rows_[a]) = x(a);
}

void Basis::kernel_part(Variable v, VectorXd& x) const {
  const Index k = static_cast<Index>(R_.size());
  x.resize(k);
  if (factored_.is_w(v)) {
    for (Index r = 0; r < k; ++r) x(r) = R_[r] == v ? -1 : 0;
  } else if (v == factored_.z0()) {
    for (Index r = 0; r < k; ++r) x(r) = covering()(R_[r]);
  } else {
    const Index j = factored_.index(v);
    const double scale = problem_.column_scale(j);
    for (Index r = 0; r < k; ++r)
      x(r) = problem_.stored()(R_[r], j) * scale * problem_.row_scales()(R_[r]);
  }
  if (k > 0) solve_kernel(x);
}

void Basis::factored_column(Variable v, VectorXd& out) {
  kernel_part(v, x_);
  const bool of_M = !factored_.is_w(v) && v != factored_.z0();
  product(x_, of_M ? factored_.index(v) : -1, y_);
  if (v == factored_.z0()) y_ += covering();
  spread(y_, x_, out);
}

Index Basis::last_left(Variable v) const {
  for (Index t = pivots_; t-- > 0;)
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

void Basis::factored_entries(Variable v, const std::vector<Index>& rows, VectorXd& out) {
  kernel_part(v, x_);
  out.resize(static_cast<Index>(rows.size()));
  const bool of_M = !factored_.is_w(v) && v != factored_.z0();
  const Index j = of_M ? factored_.index(v) : 0;
  for (Index t = 0; t < out.size(); ++t) {
    const Variable basic = factored_.basic(rows[t]);
    if (!factored_.is_w(basic)) {
      const auto place = std::lower_bound(A_rows_.begin(), A_rows_.end(), rows[t]);
      out(t) = x_(place - A_rows_.begin());
      continue;
    }
    double sum = of_M ? problem_.stored()(basic, j) * problem_.column_scale(j) : 0;
    Index a = 0;
    for (std::size_t c = 0; c < A_columns_.size(); ++c, ++a) {
      if (a == z0_place_) ++a;
      sum += x_(a) * problem_.column_scale(A_columns_[c]) * problem_.stored()(basic, A_columns_[c]);
    }
    out(t) = sum * problem_.row_scales()(basic);
    if (z0_place_ >= 0) out(t) += x_(z0_place_) * covering()(basic);
    if (v == factored_.z0()) out(t) += covering()(basic);
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
  for (++next; next < pivots_; ++next) {
    const Eta& eta = etas_[next];
    const Index r = eta.pivot.row;
    if (out(r) == 0) continue;
    const double theta = -out(r) / eta.column(r);
    out += theta * eta.column;
    out(r) = theta;
  }
}

void Basis::entries(Variable v, const std::vector<Index>& rows, VectorXd& out) {
  const Index asked = static_cast<Index>(rows.size());
  // The rows asked for, then the pivot rows of the etas, on whose entries the others depend.
  std::vector<Index> followed = rows;
  for (Index t = 0; t < pivots_; ++t) followed.push_back(etas_[t].pivot.row);

  Index next = last_left(v);
  if (next < 0) {
    factored_entries(v, followed, out);
  } else {
    out = entries_after_leaving(etas_[next], followed);
  }
  for (++next; next < pivots_; ++next) {
    const Eta& eta = etas_[next];
    if (out(asked + next) == 0) continue;
    const double theta = -out(asked + next) / eta.column(eta.pivot.row);
    for (Index t = 0; t < asked + pivots_; ++t) {
      const Index row = followed[t];
      out(t) = row == eta.pivot.row ? theta : out(t) + theta * eta.column(row);
    }
  }
  out.conservativeResize(asked);
}

Variable Basis::pivot(const Pivot& pivot, const VectorXd& column) {
  const Variable leaving = labels_.exchange(pivot);
  if (pivots_ + 1 >= refactor_every_) {
    factorise(0);
    return leaving;
  }
  const double theta = -q_(pivot.row) / column(pivot.row);
  if (pivots_ == static_cast<Index>(etas_.size())) etas_.emplace_back();
  Eta& eta = etas_[pivots_++];
  eta.pivot = pivot;
  eta.left = leaving;
  eta.column = column;
  q_ += theta * column;
  q_(pivot.row) = theta;
  const double largest = column.lpNorm<Eigen::Infinity>();
  growth_ = std::max({growth_, largest, largest / std::abs(column(pivot.row))});
  drift_ += std::numeric_limits<double>::epsilon() * (1 + std::abs(theta)) * growth_;
  return leaving;
}

void Basis::rebuild(const std::vector<Pivot>& path) {
  labels_ = Labels(problem_.size(), alpha_);
  for (const Pivot& step : path) labels_.exchange(step);
  factorise(0);
}

bool Basis::refine() {
  if (pivots_ > 0) factorise(0);
  if (!usable_ || R_.empty()) return usable_;
  x_ = kernel_residual_;
  solve_kernel(x_);
  for (Index a = 0; a < x_.size(); ++a) q_(A_rows_[a]) += x_(a);
  return true;
}

bool Basis::error_within(double e_max) {
  if (pivots_ > 0 && kTrust * (kernel_error_ + drift_) <= e_max) return true;
  if (pivots_ > 0) factorise(0);
  return usable_ && kernel_error_ <= e_max;
}

}  // namespace lcp
