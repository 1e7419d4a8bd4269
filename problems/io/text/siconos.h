#pragma once

#include <string>

#include "problems/instance.h"
#include "problems/io/read_options.h"

namespace lcp {

/// Files of Siconos' numerics (.dat), read only. Numbers stand in any number of lines:
///
///     LCP               n, matrix (n x n), q (n)
///     friction contact  d (2 or 3), contacts Nc, matrix (d Nc x d Nc), q (d Nc), mu (Nc)
///
/// with matrices as read_siconos_matrix says. The head shows which of the two it is. Behind the numbers a text
/// may follow; friction contacts also a 0 or 1 with which Siconos says whether a guess follows, which
/// is not read.
inline constexpr const char* siconos_ending = ".dat";

/// Reads the instance and calls it `name`. An LCP has plain scales; local contacts become (25) as
/// contact_instance says. Numbers are the nearest to what is printed. Throws UnreadableInput `file:
/// line: found, expected`.
Instance read_siconos(const std::string& path, const std::string& name,
                      const ReadOptions& options = {});

}  // namespace lcp
