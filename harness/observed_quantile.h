#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace lcp {

/// The p-quantile, 0 < p <= 1: the least value that at least the share p of `values` does not exceed;
/// empty for no values. It is always one of the values, so that it commutes with a logarithm and
/// zeros or infinities among the values do no harm. Values must be ordered: no NaN.
template <class Number>
std::optional<Number> observed_quantile(std::vector<Number> values, double p) {
  if (values.empty()) return std::nullopt;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(p * static_cast<double>(values.size())));
  const auto place = values.begin() + std::max<std::ptrdiff_t>(rank, 1) - 1;
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace lcp
