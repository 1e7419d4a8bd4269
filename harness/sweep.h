#pragma once

#include <string>
#include <vector>

namespace lcp {

/// The settings of a sweep: the spelling `solver` with every value of the accuracy ladder of each of
/// `options`, one option at a time, fast and rough to slow and exact; without `options`, of every
/// option that has a ladder. Throws std::invalid_argument, with the list of what is allowed, for an
/// option without a ladder, one that `solver` itself sets, or a row that has none at all.
std::vector<std::string> sweep_settings(const std::string& solver,
                                        const std::vector<std::string>& options);

}  // namespace lcp
