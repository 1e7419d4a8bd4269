#pragma once

#include <unistd.h>

#include <string>
#include <string_view>
#include <utility>

namespace lcp {

/// An open file descriptor, closed when it goes; -1 stands for no file.
class FileDescriptor {
 public:
  explicit FileDescriptor(int number = -1) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileDescriptor() { reset(); }

  int get() const { return number_; }
  /// Closes it; false, with errno set, where the system says that what was written is lost.
  bool reset() { return number_ < 0 || close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

/// Both ends of a pipe, which programs that are started do not inherit.
struct Pipe {
  FileDescriptor reading, writing;
};

/// Throws std::system_error when the system refuses.
Pipe make_pipe();

/// Writes all of `bytes`; false, with errno set, where the system refuses or nobody listens.
bool write_all(int file, std::string_view bytes);

/// Reads to the end: of a pipe, when its writers have closed it.
std::string read_all(int file);

}  // namespace lcp
