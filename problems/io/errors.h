#pragma once

#include <string>

#include "solvers/errors.h"

namespace lcp {

/// The same text with '?' for line breaks and other control characters, which names and lines of a
/// damaged file may hold.
std::string one_line(std::string text);

/// A file that cannot be read as instances: missing, truncated, hostile, of another format. The
/// message is one line `file: place: what is wrong, expected ...`. Exit status 3 of the command line.
struct UnreadableInput : std::runtime_error {
  explicit UnreadableInput(const std::string& message) : std::runtime_error(one_line(message)) {}
  template <class... Arguments>
  explicit UnreadableInput(fmt::format_string<Arguments...> text, Arguments&&... arguments)
      : UnreadableInput(fmt::format(text, std::forward<Arguments>(arguments)...)) {}
};

/// A file that cannot be written, or instances that its format cannot hold. The message is one line
/// `file: what is wrong`. Exit status 4 of the command line.
struct UnwritableOutput : Formatted<std::runtime_error> {
  using Formatted::Formatted;
};

}  // namespace lcp
