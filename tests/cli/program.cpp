#include "tests/cli/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
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

namespace {

int status_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status); }

Ran ended(pid_t child, const std::string& out, const std::string& err) {
  int status = 0;
  waitpid(child, &status, 0);
  return {status_of(status), read_text(out), read_text(err)};
}

/// What the descriptor `file` of a process leads to.
std::string target_of(pid_t process, unsigned long long file) {
  std::error_code closed;
  return std::filesystem::read_symlink(
             "/proc/" + std::to_string(process) + "/fd/" + std::to_string(file), closed)
      .filename()
      .string();
}

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

}  // namespace

Ran run_and_kill(const std::string& program, const std::vector<std::string>& arguments,
                 const std::string& directory, std::chrono::milliseconds delay) {
  const TemporaryDirectory streams;
  const std::string out = streams.file("out"), err = streams.file("err");
  const pid_t child = start(program, arguments, directory, out, err);
  std::this_thread::sleep_for(delay);
  kill(child, SIGKILL);
  return ended(child, out, err);
}

Ran run_and_kill_in_write(const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& directory, const std::string& file, int count) {
  const TemporaryDirectory streams;
  const std::string out = streams.file("out"), err = streams.file("err");
  const pid_t child = start(program, arguments, directory, out, err);
  require(ptrace(PTRACE_SEIZE, child, nullptr, PTRACE_O_TRACESYSGOOD) == 0, "ptrace: no seizing");
  require(ptrace(PTRACE_INTERRUPT, child, nullptr, nullptr) == 0, "ptrace: no stopping");
  bool killing = false;
  int status = 0;
  while (waitpid(child, &status, 0) == child && WIFSTOPPED(status)) {
    const bool at_call = WSTOPSIG(status) == (SIGTRAP | 0x80);
    __ptrace_syscall_info call = {};
    if (at_call) ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof call, &call);
    if (killing && call.op == PTRACE_SYSCALL_INFO_EXIT) kill(child, SIGKILL);
    if (call.op == PTRACE_SYSCALL_INFO_ENTRY && call.entry.nr == SYS_write &&
        target_of(child, call.entry.args[0]) == file && --count == 0) {
      user_regs_struct registers;
      ptrace(PTRACE_GETREGS, child, nullptr, &registers);
      registers.rdx /= 2;
      ptrace(PTRACE_SETREGS, child, nullptr, &registers);
      killing = true;
    }
    const bool signalled = !at_call && status >> 16 == 0;
    ptrace(PTRACE_SYSCALL, child, nullptr, signalled ? WSTOPSIG(status) : 0);
  }
  return {status_of(status), read_text(out), read_text(err)};
}

Ran run_program(const std::string& program, const std::vector<std::string>& arguments,
                const std::string& directory, const std::string& interrupt_when) {
  const TemporaryDirectory streams;
  const std::string out = streams.file("out"), err = streams.file("err");
  const pid_t child = start(program, arguments, directory, out, err);
  if (!interrupt_when.empty()) {
    wait_for_line(child, directory + "/" + interrupt_when);
    kill(child, SIGINT);
  }
  return ended(child, out, err);
}

}  // namespace lcp
