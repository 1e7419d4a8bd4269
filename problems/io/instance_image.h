#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problems/instance.h"

namespace lcp {

/// Instances as bytes, for a pipe between two processes of this program; never for a file.
std::string to_image(const std::vector<Instance>& instances);

/// Reads the bytes of to_image; hashes are computed again. Throws std::invalid_argument when they end
/// too early or hold what check(Problem) refuses.
std::vector<Instance> from_image(std::string_view image);

}  // namespace lcp
