#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace lcp::cli {

/// Reads a positive duration: 10s, 500ms, 2min. Throws std::invalid_argument naming `option`.
std::chrono::nanoseconds parse_duration(const std::string& text, const std::string& option);

/// Reads a positive number of bytes: 2GiB, 512MiB, 64KiB. Throws as above.
std::int64_t parse_bytes(const std::string& text, const std::string& option);

/// For a reader: `52 s`, `3 min 20 s`, `2 h 5 min`.
std::string printed_duration(double seconds);

}  // namespace lcp::cli
