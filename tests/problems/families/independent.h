#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "problems/instance.h"

namespace lcp::independent {

/// M z + q in long double, row by row.
inline std::vector<long double> slack(const Problem& problem, const VectorXd& z) {
  std::vector<long double> w;
  for (Index i = 0; i < problem.size(); ++i) {
    long double sum = problem.q(i);
    for (Index j = 0; j < problem.size(); ++j)
      sum += static_cast<long double>(problem.M(i, j)) * static_cast<long double>(z(j));
    w.push_back(sum);
  }
  return w;
}

struct Pairs {
  Index active = 0;      ///< z_i > 0 = w_i.
  Index degenerate = 0;  ///< z_i = w_i = 0.
  Index inactive = 0;    ///< z_i = 0 < w_i.
  Index violated = 0;    ///< Anything else.
};

/// Counts the pairs of a solution; numbers up to `zero` in size are 0.
inline Pairs pairs(const Problem& problem, const VectorXd& z, double zero) {
  Pairs found;
  const std::vector<long double> w = slack(problem, z);
  for (Index i = 0; i < problem.size(); ++i) {
    const bool z_is_zero = std::abs(z(i)) <= zero, w_is_zero = std::abs(w[i]) <= zero;
    if (z_is_zero && w_is_zero) {
      ++found.degenerate;
    } else if (w_is_zero && z(i) > 0) {
      ++found.active;
    } else if (z_is_zero && w[i] > 0) {
      ++found.inactive;
    } else {
      ++found.violated;
    }
  }
  return found;
}

/// Determinant of the principal submatrix of the rows whose bit in `rows` is set: elimination with
/// row exchanges, in long double.
inline long double principal_minor(const MatrixXd& M, unsigned rows) {
  std::vector<Index> kept;
  for (Index i = 0; i < M.rows(); ++i)
    if (rows >> i & 1) kept.push_back(i);
  const std::size_t k = kept.size();
  std::vector<std::vector<long double>> A(k, std::vector<long double>(k));
  for (std::size_t i = 0; i < k; ++i)
    for (std::size_t j = 0; j < k; ++j) A[i][j] = M(kept[i], kept[j]);
  long double determinant = 1;
  for (std::size_t c = 0; c < k; ++c) {
    std::size_t best = c;
    for (std::size_t i = c + 1; i < k; ++i)
      if (std::abs(A[i][c]) > std::abs(A[best][c])) best = i;
    if (A[best][c] == 0) return 0;
    if (best != c) {
      std::swap(A[best], A[c]);
      determinant = -determinant;
    }
    determinant *= A[c][c];
    for (std::size_t i = c + 1; i < k; ++i) {
      const long double factor = A[i][c] / A[c][c];
      for (std::size_t j = c; j < k; ++j) A[i][j] -= factor * A[c][j];
    }
  }
  return determinant;
}

/// Whether all 2^n - 1 principal minors are positive.
inline bool is_p_matrix(const MatrixXd& M) {
  for (unsigned rows = 1; rows < 1U << M.rows(); ++rows)
    if (!(principal_minor(M, rows) > 0)) return false;
  return true;
}

/// Rank of an integer matrix modulo a prime: a lower bound of the rank, and equal to it unless the
/// prime divides every minor of that size.
inline Index rank_modulo(const MatrixXd& M, std::int64_t prime) {
  __extension__ using Wide = __int128;
  const auto times = [prime](std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<Wide>(a) * b % prime);
  };
  const auto inverse = [&](std::int64_t a) {  // a^(prime - 2).
    std::int64_t power = 1;
    for (std::int64_t rest = prime - 2; rest > 0; rest /= 2, a = times(a, a))
      if (rest % 2 == 1) power = times(power, a);
    return power;
  };
  std::vector<std::vector<std::int64_t>> A;
  for (Index i = 0; i < M.rows(); ++i) {
    A.emplace_back();
    for (Index j = 0; j < M.cols(); ++j)
      A.back().push_back((static_cast<std::int64_t>(M(i, j)) % prime + prime) % prime);
  }
  std::size_t rank = 0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(M.cols()) && rank < A.size(); ++c) {
    std::size_t pivot = rank;
    while (pivot < A.size() && A[pivot][c] == 0) ++pivot;
    if (pivot == A.size()) continue;
    std::swap(A[rank], A[pivot]);
    const std::int64_t scale = inverse(A[rank][c]);
    for (std::size_t i = rank + 1; i < A.size(); ++i) {
      const std::int64_t factor = times(A[i][c], scale);
      if (factor == 0) continue;
      for (std::size_t j = c; j < A[i].size(); ++j)
        A[i][j] = (A[i][j] + prime - times(factor, A[rank][j])) % prime;
    }
    ++rank;
  }
  return static_cast<Index>(rank);
}

inline MatrixXd symmetric_part(const MatrixXd& M) { return (M + M.transpose()) / 2; }
inline MatrixXd skew_part(const MatrixXd& M) { return (M - M.transpose()) / 2; }

/// Ascending.
VectorXd eigenvalues(const MatrixXd& symmetric);
inline VectorXd eigenvalues_of_symmetric_part(const MatrixXd& M) {
  return eigenvalues(symmetric_part(M));
}

/// Descending.
VectorXd singular_values(const MatrixXd& M);

inline bool all_integers(const MatrixXd& M) { return M.array().round().matrix() == M; }

}  // namespace lcp::independent
