#pragma once

#include <vector>

#include "solvers/problem.h"

namespace lcp {

/// y += sum_k x_k M.col(columns_k), four columns in one pass over y: what a pivot on a factorised
/// basis spends its time on. The order of additions is fixed, so that every build computes the same
/// bits. y: n; cost: n multiply-adds a column. `x` has as many entries as `columns`.
inline void add_columns(const MatrixXd& M, const std::vector<Index>& columns, const double* x,
                        VectorXd& y) {
  const Index n = M.rows(), count = static_cast<Index>(columns.size());
  double* const out = y.data();
  Index k = 0;
  for (; k + 4 <= count; k += 4) {
    const double* const a = M.col(columns[k]).data();
    const double* const b = M.col(columns[k + 1]).data();
    const double* const c = M.col(columns[k + 2]).data();
    const double* const d = M.col(columns[k + 3]).data();
    const double x0 = x[k], x1 = x[k + 1], x2 = x[k + 2], x3 = x[k + 3];
    for (Index i = 0; i < n; ++i)
      out[i] += (x0 * a[i] + x1 * b[i]) + (x2 * c[i] + x3 * d[i]);
  }
  for (; k < count; ++k) y += x[k] * M.col(columns[k]);
}

}  // namespace lcp
