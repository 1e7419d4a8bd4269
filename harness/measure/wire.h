#pragma once

#include <string>

#include "solvers/result.h"

namespace lcp {

/// A result as bytes (CBOR) and back: every number keeps its bits (a NaN only that it is one), so
/// two results have equal bytes exactly when all their fields are equal.
std::string encode(const Result& result);
/// Throws nlohmann::json::exception or std::invalid_argument on bytes that are no result.
Result decode(const std::string& bytes);

}  // namespace lcp
