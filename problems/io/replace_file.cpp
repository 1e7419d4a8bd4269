#include "problems/io/replace_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <vector>

#include "problems/io/errors.h"
#include "problems/io/file_descriptor.h"

namespace lcp {

namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  const int reason = errno;
  throw UnwritableOutput("{}: cannot {}: {}", path, what, std::strerror(reason));
}

/// A file that is removed again unless it was renamed to what it shall be.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target)
      : target_(target),
        path_(fmt::format("{}.{}.tmp", target, getpid())),
        file_(open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (file_.get() < 0) fail(target_, "write");
  }
  ~TemporaryFile() {
    if (!renamed_) unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view bytes) {
    if (!write_all(file_.get(), bytes) || fsync(file_.get()) != 0 || !file_.reset())
      fail(target_, "write");
  }

  void rename() {
    if (std::rename(path_.c_str(), target_.c_str()) != 0) fail(target_, "replace");
    renamed_ = true;
  }

 private:
  std::string target_;
  std::string path_;
  FileDescriptor file_;
  bool renamed_ = false;
};

/// Makes the renaming itself survive a loss of power; a file system that cannot do this has its
/// reasons, and the content is safe already.
void synchronise_directory_of(const std::string& path) {
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  const FileDescriptor directory(open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_CLOEXEC));
  fsync(directory.get());
}

}  // namespace

void replace_file(const std::string& path, std::string_view bytes) {
  TemporaryFile file(path);
  file.write(bytes);
  file.rename();
  synchronise_directory_of(path);
}

void make_directories(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw UnwritableOutput("{}: cannot create: {}", path.string(), error.message());
}

void remove_unfinished(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> unfinished;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
    if (entry.path().extension() == ".tmp") unfinished.push_back(entry.path());
  for (const std::filesystem::path& path : unfinished) {
    std::error_code nobody_minds;
    std::filesystem::remove_all(path, nobody_minds);
  }
}

}  // namespace lcp
