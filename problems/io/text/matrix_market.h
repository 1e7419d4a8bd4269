#pragma once

#include <string>

#include "problems/instance.h"

namespace lcp {

/// A Matrix Market pair: `NAME.M.mtx` (coordinate or array, real or integer; general, symmetric or
/// skew-symmetric) and `NAME.q.mtx` (array, n x 1). Written general, in the shortest decimals that
/// read back as the same bits.

/// The ending of the file that stands for the pair.
inline constexpr const char* matrix_market_ending = ".M.mtx";

/// Reads the pair to which `path` (NAME.M.mtx) belongs as an instance called `name`, with plain
/// scales. Nothing is allocated beyond largest_rows, or for entries that the file is too short for.
/// Throws UnreadableInput, naming the file, the line and what was expected, when one is missing,
/// malformed or too large, when M is not square or q not n x 1, and on patterns, complex or non-finite
/// numbers.
Instance read_matrix_market(const std::string& path, const std::string& name);

/// Writes the pair to which `path` (NAME.M.mtx) belongs, q first. What an instance knows besides its
/// problem (name, provenance, known solution) has no place there and is left out. Throws
/// UnwritableOutput, with the reason, when the format cannot hold the problem itself: friction
/// blocks, its own covering vector, pivot limit or scales, or n = 0.
void write_matrix_market(const std::string& path, const Instance& instance);

}  // namespace lcp
