#pragma once

#include "harness/judge/quad.h"
#include "solvers/problem.h"

namespace lcp {

/// A dense matrix of Quads, column by column.
class QuadMatrix {
 public:
  QuadMatrix() = default;
  QuadMatrix(Index rows, Index columns)
      : rows_(rows), columns_(columns), numbers_(rows * columns) {}

  Index rows() const { return rows_; }
  Index columns() const { return columns_; }
  Quad& operator()(Index i, Index j) { return numbers_[j * rows_ + i]; }
  Quad operator()(Index i, Index j) const { return numbers_[j * rows_ + i]; }

 private:
  Index rows_ = 0, columns_ = 0;
  Quads numbers_;
};

/// Replaces a square matrix by its inverse: Gauss-Jordan elimination with row exchanges, k^3
/// multiply-adds. False, and the matrix undefined, where a pivot is 0 or not finite.
bool invert(QuadMatrix& matrix);

}  // namespace lcp
