#include "tests/cli/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include "tests/harness/temporary_directory.h"

namespace lcp {

namespace {

pid_t start(const std::string& program, const std::vector<std::string>& arguments,
            const std::string& directory, const std::string& out, const std::string& err) {
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  pid_t child = 0;
  const int error =
      posix_spawn(&child, program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error(program + " does not start");
  return child;
}

/// Waits for a line in `file`, or for the child to end without one.
void wait_for_line(pid_t child, const std::string& file) {
  siginfo_t ended = {};
  while (read_text(file).find('\n') == std::string::npos && ended.si_pid == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
  }
}

}  // namespace

Ran run_program(const std::string& program, const std::vector<std::string>& arguments,
                const std::string& directory, const std::string& interrupt_when) {
  const TemporaryDirectory streams;
  const std::string out = streams.file("out"), err = streams.file("err");
  const pid_t child = start(program, arguments, directory, out, err);
  if (!interrupt_when.empty()) {
    wait_for_line(child, directory + "/" + interrupt_when);
    kill(child, SIGINT);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_text(out),
          read_text(err)};
}

}  // namespace lcp
