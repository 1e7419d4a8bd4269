#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace lcp::cli {

/// Reads a positive duration: 10s, 500ms, 2min. Throws std::invalid_argument naming `option`.
std::chrono::nanoseconds parse_duration(const std::string& text, const std::string& option);

/// Reads a positive number of bytes: 2GiB, 512MiB, 64KiB. Throws as above.
std::int64_t parse_bytes(const std::string& text, const std::string& option);

}  // namespace lcp::cli
