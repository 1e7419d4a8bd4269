#include "harness/cli/output_directory.h"

#include <fmt/format.h>

#include <system_error>

#include "problems/io/errors.h"

namespace lcp::cli {

namespace fs = std::filesystem;

namespace {

/// Removed again unless it was renamed to what it shall be.
class Unfinished {
 public:
  explicit Unfinished(fs::path path) : path_(std::move(path)) {}
  ~Unfinished() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Without a slash at its end.
fs::path as_named(const std::string& directory) {
  const fs::path path = fs::path(directory).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

void require_new(const std::string& directory) {
  if (fs::exists(directory))
    throw UnwritableOutput(fmt::format("{}: exists already, expected a new directory", directory));
}

void write_directory(const std::string& directory,
                     const std::function<void(const fs::path& into)>& fill) {
  require_new(directory);
  const fs::path target = as_named(directory);
  const Unfinished unfinished(target.string() + ".tmp");
  std::error_code error;
  fs::remove_all(unfinished.path(), error);
  fs::create_directories(unfinished.path(), error);
  if (error)
    throw UnwritableOutput(fmt::format("{}: cannot write: {}", directory, error.message()));
  fill(unfinished.path());
  fs::rename(unfinished.path(), target, error);
  if (error)
    throw UnwritableOutput(fmt::format("{}: cannot write: {}", directory, error.message()));
}

}  // namespace lcp::cli
