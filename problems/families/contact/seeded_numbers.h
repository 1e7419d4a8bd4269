#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace lcp {

/// Uniform in [-1, 1), from the generator's own bits: the library's distributions are not portable.
inline double symmetric_unit(std::mt19937_64& random) {
  return std::ldexp(static_cast<double>(random() >> 11), -52) - 1;
}

/// Uniform in [0, 1).
inline double unit(std::mt19937_64& random) {
  return std::ldexp(static_cast<double>(random() >> 11), -53);
}

}  // namespace lcp
