#pragma once

#include <stdexcept>
#include <string>

namespace lcp {

/// The same text with '?' for line breaks and other control characters, which names and lines of a
/// damaged file may hold.
std::string one_line(std::string text);

/// A file that cannot be read as instances: missing, truncated, hostile, of another format. The
/// message is one line `file: place: what is wrong, expected ...`. Exit status 3 of the command line.
class UnreadableInput : public std::runtime_error {
 public:
  explicit UnreadableInput(const std::string& message) : std::runtime_error(one_line(message)) {}
};

/// A file that cannot be written, or instances that its format cannot hold. The message is one line
/// `file: what is wrong`. Exit status 4 of the command line.
class UnwritableOutput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lcp
