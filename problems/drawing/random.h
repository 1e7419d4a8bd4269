#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "solvers/problem.h"

namespace lcp {

/// Seeded numbers that are the same with every standard library: mt19937_64 and arithmetic of our
/// own, since the library's distributions are not portable.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// Uniform in [low, high), in steps of 2^-53 of the range.
  double between(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(bits_() >> 11), -53);
  }

  /// Uniform in {low, ..., high}, but for the remainder of 2^64, which no table can show.
  Index integer(Index low, Index high) {
    const auto values = static_cast<std::uint64_t>(high - low + 1);
    return low + static_cast<Index>(bits_() % values);
  }

  /// 0 ... n-1 in random order.
  std::vector<Index> permutation(Index n) {
    std::vector<Index> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), Index{0});
    for (Index i = n - 1; i > 0; --i) std::swap(order[i], order[integer(0, i)]);
    return order;
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace lcp
