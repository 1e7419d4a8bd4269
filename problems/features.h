#pragma once

#include <optional>

#include "problems/instance.h"

namespace lcp {

/// Thresholds that the features of an instance depend on.
struct FeatureOptions {
  double rank_threshold = 1e-10;  ///< Singular values above this share of the largest count.
  double tie_threshold = 1e-10;   ///< How far above the least q_i / s_w,i still counts as tied.
  Index largest_svd = 1500;       ///< Rows above which no singular values are computed.
};

/// A description of an instance that needs no solve.
struct Features {
  Index n = 0;
  Index contacts = 0;    ///< 0 where there are no friction blocks.
  double asymmetry = 0;  ///< asymmetry_of M; 0 says that M is symmetric to the bit.
  double density = 0;    ///< Share of the entries of M that are not zero.
  Index tied_q = 0;      ///< Rows that share the least q_i / s_w,i: a tie before the first pivot.
  /// Singular values of W (of M where there are no contacts) above the threshold; empty when the
  /// matrix has more than `largest_svd` rows.
  std::optional<Index> rank;
  /// Largest over smallest of those singular values; empty also when there are none.
  std::optional<double> condition;
};

/// max |M - M'| / max |M|; 0 of a matrix of zeros.
double asymmetry_of(const MatrixXd& M);

/// Features of a problem that passes check(); an n = 0 problem has zeros throughout.
Features features(const Problem& problem, const FeatureOptions& options = {});

}  // namespace lcp
