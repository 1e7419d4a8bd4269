#include "problems/io/program_output.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "problems/io/file_descriptor.h"

namespace lcp {

namespace {

/// Reads to the end: of a pipe, when its writers have closed it.
std::string read_all(int file) {
  std::string text;
  char buffer[4096];
  for (;;) {
    const ssize_t count = ::read(file, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(count));
  }
}

std::string first_line(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n");
  if (begin == std::string::npos) return "no message";
  return text.substr(begin, text.find('\n', begin) - begin);
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// What a child process is started with besides its arguments.
class SpawnActions {
 public:
  SpawnActions() { ::posix_spawn_file_actions_init(&actions); }
  ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;

  posix_spawn_file_actions_t actions;
};

}  // namespace

ProgramOutput output_of(const std::string& program, const std::vector<std::string>& arguments,
                        const std::filesystem::path& directory) {
  const FileDescriptor complaints(::memfd_create("stderr", MFD_CLOEXEC));
  int ends[2];
  if (complaints.get() < 0 || ::pipe2(ends, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "starting " + program);
  const FileDescriptor reading(ends[0]);
  FileDescriptor written(ends[1]);

  SpawnActions start;
  ::posix_spawn_file_actions_adddup2(&start.actions, written.get(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&start.actions, complaints.get(), STDERR_FILENO);
  ::posix_spawn_file_actions_addchdir_np(&start.actions, directory.c_str());
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  const int error =
      ::posix_spawnp(&child, program.c_str(), &start.actions, nullptr, pointers.data(), environ);
  if (error != 0) throw std::system_error(error, std::generic_category(), program);

  written.reset();  // the child's copy is the last: reading ends when it does
  ProgramOutput output;
  output.out = read_all(reading.get());
  output.status = wait_for(child);
  ::lseek(complaints.get(), 0, SEEK_SET);
  output.complaint = first_line(read_all(complaints.get()));
  return output;
}

}  // namespace lcp
