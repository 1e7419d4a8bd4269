#pragma once

#include <algorithm>

namespace lcp {

/// Quintic from 0 to 1 as `share` goes from 0 to 1, at rest at both ends; 0 before and 1 after.
inline double smooth_step(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * s * (10 + s * (6 * s - 15));
}

}  // namespace lcp
