#include "harness/studies/paper/columns/paper_directory.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "harness/measure/environment.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Held until the descriptor is closed. Child processes do not inherit it.
FileDescriptor lock(const fs::path& directory) {
  const std::string path = (directory / "lock").string();
  FileDescriptor file(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (file.get() < 0)
    throw UnwritableOutput(fmt::format("{}: cannot write: {}", path, std::strerror(errno)));
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(file.get(), F_SETLK, &whole) != 0 && (errno == EACCES || errno == EAGAIN))
    throw UnwritableOutput(fmt::format("{}: another process works in it", directory.string()));
  return file;
}

std::vector<json> environments(const fs::path& directory) {
  std::vector<json> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (!entry.path().filename().string().starts_with("env-")) continue;
    if (entry.path().extension() != ".json") continue;
    found.push_back(read_json_file(entry.path()));
    if (!found.back().is_object() || !found.back().contains("commit"))
      throw UnreadableInput(fmt::format("{}: field 'commit' is missing", entry.path().string()));
  }
  return found;
}

}  // namespace

json read_json_file(const fs::path& path) {
  std::ifstream stream(path);
  if (!stream) throw UnreadableInput(fmt::format("{}: cannot be read", path.string()));
  try {
    return json::parse(stream);
  } catch (const json::exception& error) {
    throw UnreadableInput(fmt::format("{}: {}", path.string(), error.what()));
  }
}

PaperDirectory::PaperDirectory(const fs::path& path, int jobs,
                               const std::function<void(const std::string&)>& note)
    : path_(path), environment_(describe_environment(jobs)) {
  make_directories(path_);
  for (const json& begun : environments(path_))
    if (begun.at("commit") != environment_.at("commit"))
      throw std::invalid_argument(fmt::format(
          "{} was begun by commit {}, this program is {}: move {} away, or name another directory "
          "with --out",
          path_.string(), begun.at("commit").get<std::string>(),
          environment_.at("commit").get<std::string>(), path_.string()));
  lock_ = lock(path_);
  remove_unfinished(path_);
  if (environment_.at("dirty") == true)
    note("built from a changed tree: columns of different code cannot be told apart");
  const fs::path file = path_ / fmt::format("env-{}.json", environment_id());
  if (!fs::exists(file)) replace_file(file.string(), environment_.dump(1) + "\n");
}

PaperDirectory::~PaperDirectory() {
  try {
    remove_unfinished(path_);
  } catch (const std::exception&) {  // the next session does it
  }
}

}  // namespace lcp
