#pragma once

#include <Eigen/Core>

namespace lcp {

/// Makes Eigen cut its products into the same blocks on every machine: by default it asks the
/// processor for its cache sizes, and another blocking adds in another order, whose last bit may
/// flip a tied ratio test. Every program and test that compares pivots calls it first.
inline void fix_product_blocking() {
  constexpr std::ptrdiff_t kib = 1024;
  Eigen::setCpuCacheSizes(32 * kib, 512 * kib, 4096 * kib);
}

}  // namespace lcp
