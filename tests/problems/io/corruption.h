#pragma once

#include <cstdint>
#include <string>

namespace lcp::corruption {

/// 1 to 4 random damages to `bytes`, the same for a seed with every standard library: bits flipped,
/// bytes overwritten, cut off, inserted, left out, repeated, pieces exchanged, integers of 1 ... 8
/// bytes and printed numbers replaced by what readers like least.
std::string damaged(std::string bytes, std::uint64_t seed);

}  // namespace lcp::corruption
