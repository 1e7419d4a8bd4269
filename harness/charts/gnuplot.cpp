#include "harness/charts/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "harness/file_descriptor.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"

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

void run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& output) {
  const FileDescriptor complaints(::memfd_create("gnuplot-stderr", MFD_CLOEXEC));
  int ends[2];
  if (complaints.get() < 0 || ::pipe2(ends, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "starting gnuplot");
  const FileDescriptor drawing(ends[0]);
  FileDescriptor drawn(ends[1]);

  SpawnActions start;
  ::posix_spawn_file_actions_adddup2(&start.actions, drawn.get(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&start.actions, complaints.get(), STDERR_FILENO);
  const std::string directory = std::filesystem::absolute(script).parent_path().string();
  ::posix_spawn_file_actions_addchdir_np(&start.actions, directory.c_str());
  std::string program = "gnuplot", file = script.filename().string();
  char* const arguments[] = {program.data(), file.data(), nullptr};
  pid_t child = 0;
  const int error =
      ::posix_spawnp(&child, program.c_str(), &start.actions, nullptr, arguments, environ);
  const std::string what = fmt::format("{}: cannot draw", output.string());
  if (error == ENOENT)
    throw UnwritableOutput(
        fmt::format("{}: gnuplot is not installed (Debian: gnuplot-nox); once it is: "
                    "cd {} && gnuplot {} > {}",
                    what, directory, file, output.filename().string()));
  if (error != 0)
    throw UnwritableOutput(
        fmt::format("{}: gnuplot: {}", what, std::generic_category().message(error)));

  drawn.reset();  // the child's copy is the last: reading ends when it does
  const std::string svg = read_all(drawing.get());
  if (wait_for(child) != 0) {
    ::lseek(complaints.get(), 0, SEEK_SET);
    throw UnwritableOutput(
        fmt::format("{}: gnuplot: {}", what, first_line(read_all(complaints.get()))));
  }
  replace_file(output.string(), svg);
}

}  // namespace lcp
