#include "harness/studies/replay/high_dictionary.h"

#include <algorithm>
#include <cmath>

namespace lcp {

namespace {

double size_of(Quad x) { return std::abs(static_cast<double>(x)); }

void set_covering_of_start(const std::vector<Index>& alpha, HighProblem& problem) {
  for (Index i = 0; i < problem.size(); ++i) {
    Quad sum = 0;
    for (const Index j : alpha) sum += problem.M(i, j);
    problem.c[i] = 1 - sum;
  }
  for (const Index i : alpha) problem.c[i] -= 1;
}

}  // namespace

HighProblem::HighProblem(const Problem& problem, bool scale, const std::vector<Index>& alpha)
    : M(problem.size(), problem.size()), q(problem.q.begin(), problem.q.end()) {
  const Index n = problem.size();
  const auto scaled = [&](Quad x, Index i) { return scale ? x / problem.s_w(i) : x; };
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      M(i, j) = scaled(scale ? static_cast<Quad>(problem.M(i, j)) * problem.s_z(j)
                             : static_cast<Quad>(problem.M(i, j)),
                       i);
  for (Index i = 0; i < n; ++i) q[i] = scaled(q[i], i);
  c.assign(n, 1);
  if (problem.c.size() > 0) {
    for (Index i = 0; i < n; ++i) c[i] = scaled(problem.c(i), i);
    if (scale) {
      const Quad largest = *std::max_element(c.begin(), c.end());
      for (Quad& x : c) x /= largest;
    }
  }
  if (!alpha.empty()) set_covering_of_start(alpha, *this);
}

HighDictionary::HighDictionary(const HighProblem& problem, const Labels& labels, double zero)
    : problem_(&problem), labels_(labels), zero_(zero), place_(labels.size(), -1) {
  set_kernel();
  if (!usable_) return;
  q_ = all_entries(problem_->q);
  usable_ = std::all_of(q_.begin(), q_.end(), [](const Estimate& x) {
    return std::isfinite(static_cast<double>(x.value)) && std::isfinite(x.error);
  });
}

void HighDictionary::set_kernel() {
  const Index n = problem_->size();
  for (Index i = 0; i < n; ++i) {
    if (!labels_.is_basic(labels_.w(i))) R_.push_back(i);
    if (labels_.is_w(labels_.basic(i))) continue;
    place_[i] = static_cast<Index>(A_.size());
    A_.push_back(labels_.basic(i));
  }
  const Index k = static_cast<Index>(A_.size());
  columns_ = QuadMatrix(n, k);
  for (Index a = 0; a < k; ++a)
    for (Index i = 0; i < n; ++i)
      columns_(i, a) =
          A_[a] == labels_.z0() ? problem_->c[i] : problem_->M(i, labels_.index(A_[a]));
  inverse_ = QuadMatrix(k, k);
  kernel_size_.resize(k, k);
  for (Index a = 0; a < k; ++a)
    for (Index r = 0; r < k; ++r) {
      inverse_(r, a) = columns_(R_[r], a);
      kernel_size_(r, a) = size_of(inverse_(r, a));
    }
  usable_ = invert(inverse_);
  if (!usable_) return;
  inverse_size_.resize(k, k);
  for (Index r = 0; r < k; ++r)
    for (Index a = 0; a < k; ++a) inverse_size_(a, r) = size_of(inverse_(a, r));
  // Skeel's condition of the kernel, which the scales of rows do not change: past 1 / rounding even
  // the signs of the inverse are noise.
  const double condition =
      k > 0 ? (inverse_size_ * kernel_size_).cwiseAbs().rowwise().sum().maxCoeff() : 0;
  usable_ = zero_ * kQuadRounding * condition < 1;
}

Quads HighDictionary::right_side(Variable v) const {
  if (v == labels_.z0()) return problem_->c;
  Quads b(problem_->size(), 0);
  const Index j = labels_.index(v);
  if (labels_.is_w(v)) {
    b[j] = -1;
  } else {
    for (Index i = 0; i < problem_->size(); ++i) b[i] = problem_->M(i, j);
  }
  return b;
}

Estimates HighDictionary::kernel_solution(const Quads& b) const {
  const Index k = static_cast<Index>(A_.size());
  Quads residual(k);
  for (Index r = 0; r < k; ++r) residual[r] = b[R_[r]];
  Quads x(k, 0);
  for (int pass = 0; pass < 2; ++pass) {  // solve, then refine
    for (Index r = 0; r < k; ++r)
      if (residual[r] != 0)
        for (Index a = 0; a < k; ++a) x[a] -= inverse_(a, r) * residual[r];
    for (Index r = 0; r < k; ++r) residual[r] = b[R_[r]];
    for (Index a = 0; a < k; ++a)
      if (x[a] != 0)
        for (Index r = 0; r < k; ++r) residual[r] += columns_(R_[r], a) * x[a];
  }
  VectorXd sizes(k), terms(k);
  for (Index a = 0; a < k; ++a) sizes(a) = size_of(x[a]);
  for (Index r = 0; r < k; ++r) terms(r) = size_of(b[R_[r]]);
  terms += kernel_size_ * sizes;
  const VectorXd errors = static_cast<double>(k + 1) * kQuadRounding * (inverse_size_ * terms);
  Estimates solution(k);
  for (Index a = 0; a < k; ++a) solution[a] = {x[a], errors(a)};
  return solution;
}

Estimate HighDictionary::entry(const Quads& b, const Estimates& x, Index row) const {
  Estimate y;
  double sizes = 0;
  if (place_[row] >= 0) {
    const Index a = place_[row];
    y = x[a];
    for (std::size_t r = 0; r < R_.size(); ++r)
      sizes += inverse_size_(a, static_cast<Index>(r)) * size_of(b[R_[r]]);
  } else {
    const Index i = labels_.index(labels_.basic(row));
    y.value = b[i];
    double terms = size_of(b[i]);
    for (std::size_t a = 0; a < x.size(); ++a) {
      if (x[a].value == 0 && x[a].error == 0) continue;
      const Quad m = columns_(i, static_cast<Index>(a));
      if (m == 0) continue;
      const Quad term = m * x[a].value;
      y.value += term;
      terms += size_of(term);
      y.error += size_of(m) * x[a].error;
    }
    if (terms > size_of(b[i])) y.error += static_cast<double>(x.size() + 1) * kQuadRounding * terms;
    sizes = terms;
  }
  if (magnitude(y.value) <= zero_ * y.error) {
    Estimate zero;
    if (y.error > kResolution * sizes) zero.doubt = zero_ * y.error;
    return zero;
  }
  return y;
}

Estimates HighDictionary::all_entries(const Quads& b) const {
  const Estimates x = kernel_solution(b);
  Estimates y(problem_->size());
  for (Index row = 0; row < problem_->size(); ++row) y[row] = entry(b, x, row);
  return y;
}

Estimates HighDictionary::column(Variable v) const { return all_entries(right_side(v)); }

Estimates HighDictionary::entries(Variable v, const std::vector<Index>& rows) const {
  const Quads b = right_side(v);
  const Estimates x = kernel_solution(b);
  Estimates y;
  for (const Index row : rows) y.push_back(entry(b, x, row));
  return y;
}

}  // namespace lcp
