#pragma once

#include "solvers/problem.h"

namespace lcp {

/// Rows of the largest instance that is read from a file: its M takes 2 GiB. Every reader compares
/// what a file declares with this before it allocates.
inline constexpr Index largest_rows = 16384;

}  // namespace lcp
