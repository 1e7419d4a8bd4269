#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lcp {

/// Makes `path` hold `bytes` and nothing else. They go to a temporary file beside it, which is
/// synchronised to the disk and then renamed, so that at every moment `path` is either what it was
/// or complete; on failure the temporary file is removed. Throws UnwritableOutput naming path and
/// reason (no such directory, no space, no permission).
void replace_file(const std::string& path, std::string_view bytes);

/// Makes `path` a directory, with those above it, unless it is one. Throws UnwritableOutput naming path
/// and reason.
void make_directories(const std::filesystem::path& path);

/// Removes what was left anywhere below `directory` when the program was killed while it wrote:
/// whatever ends in .tmp. Nothing else may be writing there.
void remove_unfinished(const std::filesystem::path& directory);

}  // namespace lcp
