#pragma once

#include <vector>

namespace lcp {

/// 113 bits hold the product of two doubles exactly, so that of sums of such products only the
/// additions round.
using Quad = __float128;
using Quads = std::vector<Quad>;

/// 2^-113, by which one operation on Quads may be off, relative to its result.
inline constexpr double kQuadRounding = 0x1p-113;

inline Quad magnitude(Quad x) { return x < 0 ? -x : x; }

}  // namespace lcp
