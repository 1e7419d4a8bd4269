#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lcp {

/// What a program printed and how it ended.
struct ProgramOutput {
  int status = 0;         ///< 0 when it ended well; else as waitpid gives it.
  std::string out;        ///< Standard output.
  std::string complaint;  ///< First line of standard error.
};

/// Runs `program`, found by PATH, in `directory` until it ends. Throws std::system_error where it
/// cannot be started: with std::errc::no_such_file_or_directory when it is not installed.
ProgramOutput output_of(const std::string& program, const std::vector<std::string>& arguments,
                        const std::filesystem::path& directory);

}  // namespace lcp
