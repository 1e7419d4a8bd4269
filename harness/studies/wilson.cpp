#include "harness/studies/wilson.h"

#include <cmath>

namespace lcp {

Interval wilson_interval(Index count, Index trials, double quantile) {
  if (trials == 0) return {0, 1};
  const double n = static_cast<double>(trials), p = static_cast<double>(count) / n;
  const double spread = quantile * quantile / n;  // z^2 / n
  const double centre = (p + spread / 2) / (1 + spread);
  const double reach = std::sqrt(p * (1 - p) * spread + spread * spread / 4) / (1 + spread);
  return {count == 0 ? 0 : centre - reach, count == trials ? 1 : centre + reach};
}

}  // namespace lcp
