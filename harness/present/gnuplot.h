#pragma once

#include <filesystem>

namespace lcp {

/// Runs `gnuplot SCRIPT` in the script's directory; what it prints becomes the file `output`.
/// Throws UnwritableOutput when gnuplot is missing or fails, with the first line of its complaint;
/// `output` is then left as it was.
void run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& output);

}  // namespace lcp
