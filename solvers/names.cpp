#include "solvers/names.h"

#include <fmt/ranges.h>

#include <stdexcept>

namespace lcp {

void refuse_unknown(const std::string& kind, const std::string& name, const std::string& expected,
                    const std::vector<std::string>& known) {
  throw std::invalid_argument(
      fmt::format("unknown {} '{}', {} {}", kind, name, expected, fmt::join(known, ", ")));
}

}  // namespace lcp
