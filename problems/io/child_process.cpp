#include "problems/io/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "problems/io/errors.h"
#include "problems/io/file_descriptor.h"

namespace lcp {

namespace {

constexpr int threw = 3;  ///< The child's exit status when `work` threw and the pipe says what.

/// In the forked process; returns the number of its channel.
int isolate(pid_t parent, const ChildStreams& streams) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(EXIT_FAILURE);
  const rlimit no_core{0, 0};  // Writing one would count as time to failure.
  setrlimit(RLIMIT_CORE, &no_core);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  const int nowhere = open("/dev/null", O_RDWR);
  int given[] = {nowhere, streams.out < 0 ? nowhere : streams.out,
                 streams.err < 0 ? nowhere : streams.err, streams.channel};
  constexpr int streams_count = 3, channel = 3;
  // First out of the way of 0 ... 3, of which some are free when the parent has closed its own.
  for (int& file : given) file = fcntl(file, F_DUPFD_CLOEXEC, channel + 1);
  for (int number = 0; number < streams_count; ++number) dup2(given[number], number);
  if (streams.keeps_files) return given[channel];
  dup2(given[channel], channel);
  close_range(channel + 1, UINT_MAX, 0);
  return channel;
}

std::string first_line(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n");
  if (begin == std::string::npos) return "no message";
  return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

ChildProcess::ChildProcess(const ChildStreams& streams,
                           const std::function<void(int channel)>& work) {
  std::fflush(nullptr);  // What is buffered now would otherwise be printed by the child as well.
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (pid_ == 0) {
    work(isolate(parent, streams));
    _exit(EXIT_SUCCESS);  // Neither destructors nor buffers of the parent's are this process's.
  }
  setpgid(pid_, pid_);  // Here too: whichever process comes first.
}

int ChildProcess::wait() {
  if (pid_ < 0) return 0;
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status;
}

int ChildProcess::stop() {
  if (pid_ > 0) kill(-pid_, SIGKILL);
  return wait();
}

std::string how_it_ended(int status, const std::string& by_signal) {
  if (WIFSIGNALED(status))
    return fmt::format("{} signal {} ({})", by_signal, WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) == EXIT_SUCCESS) return "";
  return fmt::format("exited with status {}", WEXITSTATUS(status));
}

std::string try_in_child(const std::string& what, unsigned seconds,
                         const std::function<std::string()>& work) {
  const auto run = [&](int channel) {
    std::signal(SIGALRM, SIG_DFL);
    alarm(seconds);
    std::string answer;
    int status = EXIT_SUCCESS;
    try {
      answer = work();
    } catch (const std::exception& error) {
      answer = error.what();
      status = threw;
    }
    _exit(write_all(channel, answer) ? status : EXIT_FAILURE);
  };
  try {
    Pipe pipe = make_pipe();
    ChildProcess child({.channel = pipe.writing.get()}, run);
    pipe.writing.reset();  // the child's copy is the last: reading ends when it does
    std::string answer = read_all(pipe.reading.get());
    const int status = child.wait();
    const std::string failure = how_it_ended(status);
    if (failure.empty()) return answer;
    if (WIFEXITED(status) && WEXITSTATUS(status) == threw) throw UnreadableInput(answer);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
      throw UnreadableInput("{}: still not done after {} s", what, seconds);
    throw UnreadableInput("{}: {}", what, failure);
  } catch (const std::system_error& error) {
    throw UnreadableInput("{}: no child process: {}", what, error.what());
  }
}

ProgramOutput output_of(const std::string& program, const std::vector<std::string>& arguments,
                        const std::filesystem::path& directory) {
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const auto run = [&](int channel) {
    fcntl(channel, F_SETFD, FD_CLOEXEC);
    if (chdir(directory.c_str()) == 0) execvp(program.c_str(), pointers.data());
    const int reason = errno;
    write_all(channel, {reinterpret_cast<const char*>(&reason), sizeof reason});
    _exit(EXIT_FAILURE);
  };

  Pipe refusal = make_pipe(), printed = make_pipe();
  const FileDescriptor complaints(memfd_create("stderr", MFD_CLOEXEC));
  ChildProcess child({refusal.writing.get(), printed.writing.get(), complaints.get()}, run);
  refusal.writing.reset();
  printed.writing.reset();
  const std::string reason = read_all(refusal.reading.get());
  if (int error = 0; reason.size() == sizeof error) {
    std::memcpy(&error, reason.data(), sizeof error);
    throw std::system_error(error, std::generic_category(), program);
  }
  ProgramOutput output;
  output.out = read_all(printed.reading.get());
  output.status = child.wait();
  lseek(complaints.get(), 0, SEEK_SET);
  output.complaint = first_line(read_all(complaints.get()));
  return output;
}

}  // namespace lcp
