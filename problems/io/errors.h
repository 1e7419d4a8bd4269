#pragma once

#include <stdexcept>

namespace lcp {

/// A file that cannot be read as instances: missing, truncated, hostile, of another format. The
/// message is one line `file: place: what is wrong, expected ...`. Exit status 3 of the command line.
class UnreadableInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be written, or instances that its format cannot hold. The message is one line
/// `file: what is wrong`. Exit status 4 of the command line.
class UnwritableOutput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lcp
