#include "harness/studies/replay/high_dictionary.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lcp {

namespace {

double size_of(Quad x) { return std::abs(static_cast<double>(x)); }

template <class Quads>
MatrixXd sizes_of(const Quads& numbers) {
  return numbers.template cast<double>().cwiseAbs();
}

bool is_finite(Quad x) { return std::isfinite(static_cast<double>(x)); }

}  // namespace

bool invert(QuadMatrix& matrix) {
  const Eigen::PartialPivLU<QuadMatrix> lu(matrix);
  for (Index i = 0; i < matrix.rows(); ++i)
    if (const Quad pivot = lu.matrixLU()(i, i); pivot == 0 || !is_finite(pivot)) return false;
  matrix = lu.inverse();
  return true;
}

HighProblem::HighProblem(const Problem& problem, bool scale, const std::vector<Index>& alpha)
    : M(problem.M.cast<Quad>()), q(problem.q.cast<Quad>()), c(QuadVector::Ones(problem.size())) {
  if (problem.c.size() > 0) c = problem.c.cast<Quad>();
  if (scale) {
    const QuadVector s_w = problem.s_w.cast<Quad>();
    M.array().rowwise() *= problem.s_z.cast<Quad>().transpose().array();
    M.array().colwise() /= s_w.array();
    q = q.cwiseQuotient(s_w);
    if (problem.c.size() > 0) {
      c = c.cwiseQuotient(s_w);
      c /= Quad(*std::max_element(c.begin(), c.end()));
    }
  }
  if (alpha.empty()) return;
  c = QuadVector::Ones(size()) - M(Eigen::all, alpha).rowwise().sum();
  for (const Index i : alpha) c(i) -= 1;
}

HighDictionary::HighDictionary(const HighProblem& problem, const Labels& labels, double zero)
    : problem_(&problem),
      labels_(labels),
      zero_(zero),
      rows_(labels.size()),
      place_(labels.size(), -1) {
  std::iota(rows_.begin(), rows_.end(), Index{0});
  set_kernel();
  if (!usable_) return;
  q_ = entries_of(problem_->q, rows_);
  usable_ = std::all_of(q_.begin(), q_.end(), [](const Estimate& x) {
    return is_finite(x.value) && std::isfinite(x.error);
  });
}

void HighDictionary::set_kernel() {
  for (const Index i : rows_) {
    if (!labels_.is_basic(labels_.w(i))) R_.push_back(i);
    if (labels_.is_w(labels_.basic(i))) continue;
    place_[i] = static_cast<Index>(A_.size());
    A_.push_back(labels_.basic(i));
  }
  const Index k = static_cast<Index>(A_.size());
  columns_.resize(labels_.size(), k);
  for (Index a = 0; a < k; ++a) columns_.col(a) = right_side(A_[a]);
  inverse_ = columns_(R_, Eigen::all);
  kernel_size_ = sizes_of(inverse_);
  usable_ = invert(inverse_);
  if (!usable_) return;
  inverse_size_ = sizes_of(inverse_);
  // Skeel's condition of the kernel, which the scales of rows do not change: past 1 / rounding even
  // the signs of the inverse are noise.
  const double condition = k > 0 ? (inverse_size_ * kernel_size_).rowwise().sum().maxCoeff() : 0;
  usable_ = zero_ * kQuadRounding * condition < 1;
}

QuadVector HighDictionary::right_side(Variable v) const {
  if (v == labels_.z0()) return problem_->c;
  if (!labels_.is_w(v)) return problem_->M.col(labels_.index(v));
  return -QuadVector::Unit(problem_->size(), labels_.index(v));
}

Estimates HighDictionary::kernel_solution(const QuadVector& b) const {
  const QuadVector b_R = b(R_);
  QuadVector x = -(inverse_ * b_R);
  x -= inverse_ * (b_R + columns_(R_, Eigen::all) * x);  // one step of refinement
  const VectorXd terms = sizes_of(b_R) + kernel_size_ * sizes_of(x);
  const VectorXd errors =
      static_cast<double>(x.size() + 1) * kQuadRounding * (inverse_size_ * terms);
  Estimates solution(x.size());
  for (Index a = 0; a < x.size(); ++a) solution[a] = {x(a), errors(a)};
  return solution;
}

Estimates HighDictionary::entries_of(const QuadVector& b, const std::vector<Index>& rows) const {
  const Estimates x = kernel_solution(b);
  const VectorXd sizes_of_x = inverse_size_ * sizes_of(b(R_));
  Estimates all;
  for (const Index row : rows) {
    Estimate y;
    double sizes = 0;
    if (const Index place = place_[row]; place >= 0) {
      y = x[place];
      sizes = sizes_of_x(place);
    } else {
      const Index i = labels_.index(labels_.basic(row));
      y.value = b(i);
      sizes = size_of(b(i));
      for (std::size_t a = 0; a < x.size(); ++a) {
        const Quad m = columns_(i, static_cast<Index>(a)), term = m * x[a].value;
        y.value += term;
        sizes += size_of(term);
        y.error += size_of(m) * x[a].error;
      }
      if (sizes > size_of(b(i)))
        y.error += static_cast<double>(x.size() + 1) * kQuadRounding * sizes;
    }
    if (magnitude(y.value) <= zero_ * y.error)
      y = {0, 0, y.error > kResolution * sizes ? zero_ * y.error : 0};
    all.push_back(y);
  }
  return all;
}

}  // namespace lcp
