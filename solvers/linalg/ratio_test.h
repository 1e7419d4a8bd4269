#pragma once

#include <algorithm>

#include "solvers/linalg/labels.h"

namespace lcp {

/// The choice of Step 1.
struct Blocking {
  Index row = -1;    ///< Row of the blocking variable y_s; -1: nothing blocks (ray).
  double ratio = 0;  ///< -q'_s / m'_s.
  Index tied = 0;    ///< Rows that could not be told from the minimum.
};

/// Step 1 as the paper compares with: the least -q'_i / m'_i over m'_i < -pivot_tolerance, the
/// lowest row where floating-point numbers tie. O(n).
Blocking first_index_ratio_test(const VectorXd& q, const VectorXd& m, double pivot_tolerance);

/// The three tolerances of the lexicographic ratio test; see LexicographicOptions for their scale.
struct RatioTolerances {
  double pivot = 0;  ///< m'_i < -pivot may be a pivot.
  double delta = 0;  ///< Rows within delta of the minimum are tied.
  double z0 = 0;     ///< z0's row is taken if within z0 of the minimum.
};

/// Step 1 with lexicographic order: of the rows whose ratio is within delta of the least, keep
/// those within delta of the least entry of column w_1 of the basis inverse over -m'_i, then of
/// w_2, and so on until one is left; after w_n the least value wins, then the lowest row. With a
/// starting basis the columns are those of the identity at the start: `first` holds the basic
/// variable of each row of the first dictionary. z0 is taken at once when its row is within `z0` of
/// the minimum.
///
/// The columns of the basis inverse are minus those of the dictionary, unit vectors where basic.
/// Costs O(n) plus, per column looked at, the entries of the tied rows. In exact arithmetic and
/// from lexico-positive rows it never cycles; a threshold breaks that guarantee on both sides: too
/// small and rounding decides, too large and different rows count as equal.
template <class Dictionary>
Blocking lexicographic_ratio_test(Dictionary& dictionary, const VectorXd& m,
                                  const std::vector<Variable>& first,
                                  const RatioTolerances& tolerances) {
  const Labels& labels = dictionary.labels();
  const VectorXd& q = dictionary.q();
  const Blocking least = first_index_ratio_test(q, m, tolerances.pivot);
  if (least.row < 0) return least;

  const Index z0_row = labels.row_of(labels.z0());
  std::vector<Index> tied;
  for (Index i = 0; i < q.size(); ++i) {
    if (!(m(i) < -tolerances.pivot)) continue;
    const double ratio = -q(i) / m(i);
    if (i == z0_row && ratio <= least.ratio + tolerances.z0) return {i, ratio, least.tied};
    if (ratio <= least.ratio + tolerances.delta) tied.push_back(i);
  }
  const Index tied_at_first = static_cast<Index>(tied.size());

  VectorXd entries;
  for (std::size_t j = 0; j < first.size() && tied.size() > 1; ++j) {
    const bool last = j + 1 == first.size();
    const Index unit_row = labels.row_of(first[j]);
    if (unit_row >= 0) {
      const auto place = std::find(tied.begin(), tied.end(), unit_row);
      if (place == tied.end()) continue;  // 0 in all tied rows
      entries.setZero(static_cast<Index>(tied.size()));
      entries(place - tied.begin()) = 1;
    } else {
      dictionary.entries(first[j], tied, entries);
      entries = -entries;
    }
    for (std::size_t t = 0; t < tied.size(); ++t) entries(t) /= -m(tied[t]);
    const double threshold = entries.minCoeff() + (last ? 0 : tolerances.delta);
    std::size_t kept = 0;
    for (std::size_t t = 0; t < tied.size(); ++t)
      if (entries(t) <= threshold) tied[kept++] = tied[t];
    if (kept == 0) return {least.row, least.ratio, tied_at_first};  // NaN: the pivot will show it.
    tied.resize(kept);
  }
  return {tied.front(), -q(tied.front()) / m(tied.front()), tied_at_first};
}

}  // namespace lcp
