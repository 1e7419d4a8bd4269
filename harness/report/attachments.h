#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lcp {

/// Pictures and tables that a report shows as they are.
struct Attachments {
  struct File {
    std::string name;  ///< Without its directory.
    std::string bytes;
  };
  std::string heading;         ///< The directory, as it was named.
  std::vector<File> pictures;  ///< Its *.svg by name.
  std::vector<File> texts;     ///< Its *.txt by name.
};

/// The pictures and texts that stand directly in a directory. Throws UnreadableInput, naming it, where
/// it is no directory, holds neither, or a file cannot be read.
Attachments read_attachments(const std::filesystem::path& directory);

/// Bytes in base 64 (RFC 4648), as a data URI wants them.
std::string base64(const std::string& bytes);

}  // namespace lcp
