#include "harness/runs/rows.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "problems/io/child_process.h"

namespace lcp {

namespace {

using nlohmann::json;

std::string rows_file(const std::string& directory) { return directory + "/rows.jsonl"; }

[[noreturn]] void throw_errno(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Keeps other processes from writing the file until this one closes it or ends.
void lock(int file, const std::string& path) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(file, F_SETLK, &whole) == 0) return;
  if (errno == EACCES || errno == EAGAIN) throw_errno(path + ": another process is writing it");
  if (errno != ENOLCK && errno != EINVAL) throw_errno(path);  // Some file systems know no locks.
}

/// The lines of rows.jsonl, or of rows.jsonl.xz where there is only that.
std::string rows_text(const std::string& path) {
  namespace fs = std::filesystem;
  if (!fs::exists(path) && fs::exists(path + ".xz")) {
    try {
      const fs::path packed = fs::absolute(path + ".xz");
      const ProgramOutput unpacked =
          output_of("xz", {"-dc", "--", packed.filename().string()}, packed.parent_path());
      if (unpacked.status == 0) return unpacked.out;
      throw std::runtime_error(fmt::format("{}.xz: {}", path, unpacked.complaint));
    } catch (const std::system_error& error) {
      throw std::runtime_error(
          fmt::format("{}.xz: cannot be unpacked: xz: {}", path, error.code().message()));
    }
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", path));
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::vector<Record> read_records(const std::string& directory) {
  const std::string path = rows_file(directory);
  std::istringstream file(rows_text(path));
  std::vector<Record> records;
  std::string line;
  while (std::getline(file, line)) {
    if (file.eof()) break;  // No line end: a killed writer's last row.
    try {
      records.push_back(json::parse(line).get<Record>());
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}:{}: {}", path, records.size() + 1, error.what()));
    }
  }
  return records;
}

RecordWriter::RecordWriter(const std::string& directory)
    : path_(rows_file(directory)),
      file_(open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (file_.get() < 0) throw_errno(path_);
  lock(file_.get(), path_);
  const off_t size = lseek(file_.get(), 0, SEEK_END);
  off_t whole = size;
  char last = '\n';
  while (whole > 0 && pread(file_.get(), &last, 1, whole - 1) == 1 && last != '\n') --whole;
  if (whole < size && ftruncate(file_.get(), whole) != 0) throw_errno(path_);
}

void RecordWriter::write(const Record& record) {
  const std::string line = json(record).dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
  std::size_t written = 0;
  while (written < line.size()) {
    // A short write is followed by one that says why: the disk is full, the file too large.
    const ssize_t count = ::write(file_.get(), line.data() + written, line.size() - written);
    if (count >= 0) {
      written += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      const int reason = errno;
      const off_t end = lseek(file_.get(), 0, SEEK_END);
      if (written > 0 && ftruncate(file_.get(), end - static_cast<off_t>(written)) != 0)
        throw_errno(path_ + ": an unfinished row could not be cut off");
      throw std::system_error(reason, std::generic_category(), path_);
    }
  }
}

}  // namespace lcp
