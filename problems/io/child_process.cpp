#include "problems/io/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <vector>

#include "problems/io/errors.h"

namespace lcp {

namespace {

constexpr int threw = 3;  ///< The child's exit status when `work` threw and the pipe says what.

void drop_output() {
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

void send(int pipe, std::string_view text) {
  while (!text.empty()) {
    const ssize_t sent = write(pipe, text.data(), text.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) _exit(EXIT_FAILURE);  // nobody listens
    text.remove_prefix(static_cast<std::size_t>(sent));
  }
}

[[noreturn]] void run_child(int pipe, unsigned seconds, const std::function<std::string()>& work) {
  drop_output();
  signal(SIGALRM, SIG_DFL);
  alarm(seconds);
  try {
    send(pipe, work());
  } catch (const std::exception& error) {
    send(pipe, error.what());
    _exit(threw);
  }
  _exit(EXIT_SUCCESS);
}

std::string receive_all(int pipe) {
  std::string text;
  std::vector<char> buffer(1 << 16);  // as much as a pipe holds
  for (;;) {
    const ssize_t received = read(pipe, buffer.data(), buffer.size());
    if (received > 0) text.append(buffer.data(), static_cast<std::size_t>(received));
    if (received == 0 || (received < 0 && errno != EINTR)) return text;
  }
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

std::string try_in_child(const std::string& what, unsigned seconds,
                         const std::function<std::string()>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw UnreadableInput(fmt::format("{}: no pipe: {}", what, std::strerror(errno)));
  const pid_t child = fork();
  if (child < 0) {
    const int reason = errno;
    close(ends[0]);
    close(ends[1]);
    throw UnreadableInput(fmt::format("{}: no child process: {}", what, std::strerror(reason)));
  }
  if (child == 0) run_child(ends[1], seconds, work);
  close(ends[1]);
  std::string answer = receive_all(ends[0]);
  close(ends[0]);
  const int status = wait_for(child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS) return answer;
  if (WIFEXITED(status) && WEXITSTATUS(status) == threw) throw UnreadableInput(answer);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    throw UnreadableInput(fmt::format("{}: still not done after {} s", what, seconds));
  if (WIFSIGNALED(status))
    throw UnreadableInput(fmt::format("{}: crashed with signal {} ({})", what, WTERMSIG(status),
                                      strsignal(WTERMSIG(status))));
  throw UnreadableInput(fmt::format("{}: ended with status {}", what, WEXITSTATUS(status)));
}

}  // namespace lcp
