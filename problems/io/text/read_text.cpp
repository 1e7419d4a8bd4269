#include "problems/io/text/read_text.h"

#include <filesystem>
#include <fstream>

#include "problems/io/errors.h"

namespace lcp {

std::string read_text(const std::string& path, const std::string& kind, std::size_t most_bytes) {
  if (!std::filesystem::is_regular_file(path))
    throw UnreadableInput("{}: no such file, expected {}", path, kind);
  const std::uintmax_t size = std::filesystem::file_size(path);
  if (size > most_bytes)
    throw UnreadableInput("{}: has {} bytes, expected at most {}", path, size, most_bytes);
  std::ifstream file(path, std::ios::binary);
  std::string text(size, '\0');
  if (size == 0 || !file.read(text.data(), static_cast<std::streamsize>(size)))
    throw UnreadableInput("{}: empty or unreadable, expected {}", path, kind);
  return text;
}

}  // namespace lcp
