#pragma once

#include <string>

namespace lcp {

/// All bytes of a text file that a reader then takes apart. Throws UnreadableInput when there is no
/// such file, when it is empty, cannot be read, or is longer than `most_bytes`; `kind` says what was
/// expected: "a Matrix Market file".
std::string read_text(const std::string& path, const std::string& kind, std::size_t most_bytes);

/// Largest text file that is read; 16384 x 16384 numbers in full precision take 7 GB.
inline constexpr std::size_t longest_file = std::size_t{8} << 30;

/// Bytes of a line or word that a message shows.
inline constexpr std::size_t longest_shown = 60;

}  // namespace lcp
