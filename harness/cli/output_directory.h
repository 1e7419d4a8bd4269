#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace lcp::cli {

/// Refuses a directory that exists, before anything is computed for it. Throws UnwritableOutput.
void require_new(const std::string& directory);

/// Makes a directory that appears with all that `fill` writes into it, or not at all. Throws
/// UnwritableOutput.
void write_directory(const std::string& directory,
                     const std::function<void(const std::filesystem::path& into)>& fill);

}  // namespace lcp::cli
