#include "harness/studies/replay/quad_matrix.h"

#include <cmath>
#include <utility>

namespace lcp {

namespace {

Index largest_from(const QuadMatrix& matrix, Index step) {
  Index best = step;
  for (Index i = step + 1; i < matrix.rows(); ++i)
    if (magnitude(matrix(i, step)) > magnitude(matrix(best, step))) best = i;
  return best;
}

void exchange_rows(QuadMatrix& matrix, Index a, Index b) {
  if (a == b) return;
  for (Index j = 0; j < matrix.columns(); ++j) std::swap(matrix(a, j), matrix(b, j));
}

void exchange_columns(QuadMatrix& matrix, Index a, Index b) {
  if (a == b) return;
  for (Index i = 0; i < matrix.rows(); ++i) std::swap(matrix(i, a), matrix(i, b));
}

/// Solves row `step` for unknown `step` and puts that into the other rows.
void eliminate(QuadMatrix& matrix, Index step) {
  const Index k = matrix.rows();
  const Quad pivot = matrix(step, step);
  for (Index j = 0; j < k; ++j) {
    if (j == step) continue;
    const Quad factor = matrix(step, j) / pivot;
    matrix(step, j) = factor;
    if (factor == 0) continue;
    for (Index i = 0; i < k; ++i)
      if (i != step) matrix(i, j) -= factor * matrix(i, step);
  }
  for (Index i = 0; i < k; ++i) matrix(i, step) = i == step ? 1 / pivot : -matrix(i, step) / pivot;
}

}  // namespace

bool invert(QuadMatrix& matrix) {
  std::vector<Index> exchanged(matrix.rows());
  for (Index step = 0; step < matrix.rows(); ++step) {
    const Index row = exchanged[step] = largest_from(matrix, step);
    const Quad pivot = matrix(row, step);
    if (pivot == 0 || !std::isfinite(static_cast<double>(pivot))) return false;
    exchange_rows(matrix, step, row);
    eliminate(matrix, step);
  }
  for (Index step = matrix.rows(); step-- > 0;) exchange_columns(matrix, step, exchanged[step]);
  return true;
}

}  // namespace lcp
