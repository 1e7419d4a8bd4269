#include "harness/measure/worker.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>

#include "harness/measure/wire.h"

namespace lcp {

namespace {

using std::chrono::nanoseconds;

constexpr std::size_t output_kept = 400;                   // Bytes.
constexpr std::size_t pipe_capacity = 65536;               // Bytes, the system's default.
constexpr auto look_every = std::chrono::milliseconds(5);  // At resident memory.

/// What a worker sends ahead of the bytes of a result, or of the text of an exception.
struct Header {
  std::uint64_t size;
  std::int64_t time_ns;
  bool threw;
};

/// Resident memory of a process in bytes; 0 when it is gone.
std::int64_t resident_bytes(pid_t pid) {
  std::ifstream file(fmt::format("/proc/{}/statm", pid));
  std::int64_t total = 0, resident = 0;
  file >> total >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

/// An answer, or the text of what was thrown instead.
struct Reply {
  std::string bytes;
  bool threw = true;
  nanoseconds time{};
};

Reply reply_of(const std::function<Result()>& solve) {
  Reply reply;
  Result result;
  const auto begin = std::chrono::steady_clock::now();
  try {
    result = solve();
    reply.threw = false;
  } catch (const std::exception& error) {
    reply.bytes = error.what();
  } catch (...) {
    reply.bytes = "not a std::exception";
  }
  reply.time = std::chrono::steady_clock::now() - begin;
  std::fflush(nullptr);
  if (!reply.threw) reply.bytes = encode(result);
  return reply;
}

/// One timed solve per byte that arrives, until the parent hangs up.
void serve(int socket, const std::function<Result()>& solve, nanoseconds warm_up_below) {
  const auto say = [socket](const void* bytes, std::size_t size) {  // or end: the parent has gone
    if (!write_all(socket, {static_cast<const char*>(bytes), size})) _exit(EXIT_FAILURE);
  };
  char go;
  nanoseconds last = warm_up_below;
  while (recv(socket, &go, 1, 0) == 1) {
    std::optional<Reply> untimed;
    if (last < warm_up_below) untimed = reply_of(solve);
    Reply reply = reply_of(solve);
    last = reply.time;
    // The parent compares each answer with the first: of two here it gets the one that may differ.
    if (untimed && untimed->bytes != reply.bytes) reply = *untimed;
    const Header header{reply.bytes.size(), reply.time.count(), reply.threw};
    say(&header, sizeof header);
    say(reply.bytes.data(), reply.bytes.size());
  }
}

}  // namespace

Worker::Worker(const std::function<Result()>& solve, const Limits& limits,
               const std::function<void()>& prepare)
    : limits_(limits) {
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
    throw std::system_error(errno, std::generic_category(), "socketpair");
  socket_ = FileDescriptor(sockets[0]);
  const FileDescriptor childs_socket(sockets[1]);
  Pipe output = make_pipe();
  output_ = std::move(output.reading);
  fcntl(output_.get(), F_SETFL, O_NONBLOCK);  // The child's end waits when the pipe is full.
  const int printed = output.writing.get();
  process_ = ChildProcess({childs_socket.get(), printed, printed}, [&](int channel) {
    prepare();
    serve(channel, solve, limits.warm_up_below);
  });
  resident_at_start_ = resident_bytes(process_.pid());
}

void Worker::ask() {
  received_.clear();
  asked_ = looked_ = Clock::now();
  const char go = 1;
  // A worker that is gone is noticed by check(), which then says how it went.
  send(socket_.get(), &go, 1, MSG_NOSIGNAL);
}

std::optional<Outcome> Worker::check() {
  std::optional<Outcome> outcome = receive();
  drain_output();
  if (outcome) return outcome;

  const Clock::time_point now = Clock::now();
  if (now - asked_ > limits_.time)
    return end(
        Outcome::How::timed_out,
        fmt::format("no answer within {} s", std::chrono::duration<double>(limits_.time).count()));
  if (now - looked_ < look_every) return std::nullopt;
  looked_ = now;
  const std::int64_t grown = resident_bytes(process_.pid()) - resident_at_start_;
  if (grown > limits_.resident_bytes)
    return end(Outcome::How::overgrown,
               fmt::format("resident memory grew by {} MiB, the limit is {} MiB", grown >> 20,
                           limits_.resident_bytes >> 20));
  return std::nullopt;
}

std::vector<pollfd> Worker::watched() const {
  return {{socket_.get(), POLLIN, 0}, {output_.get(), POLLIN, 0}};
}

/// One pipe full at most, so that a worker that never stops printing cannot keep the parent here.
void Worker::drain_output() {
  std::array<char, pipe_capacity> buffer;
  const ssize_t count = read(output_.get(), buffer.data(), buffer.size());
  if (count == 0) output_.reset();  // Or poll would return for its end for ever.
  if (count <= 0) return;
  output_end_.append(buffer.data(), static_cast<std::size_t>(count));
  if (output_end_.size() > output_kept) output_end_.erase(0, output_end_.size() - output_kept);
}

std::optional<Outcome> Worker::receive() {
  std::array<char, pipe_capacity> buffer;
  ssize_t count;
  while ((count = recv(socket_.get(), buffer.data(), buffer.size(), MSG_DONTWAIT)) > 0)
    received_.append(buffer.data(), static_cast<std::size_t>(count));
  const bool waiting = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);

  Header header{};
  if (received_.size() >= sizeof header) {
    std::memcpy(&header, received_.data(), sizeof header);
    if (received_.size() - sizeof header >= header.size) return read_frame();
  }
  if (waiting) return std::nullopt;
  return death();
}

/// Takes apart what `received_` holds: a header and as many bytes as it says.
Outcome Worker::read_frame() {
  Header header;
  std::memcpy(&header, received_.data(), sizeof header);
  std::string bytes = received_.substr(sizeof header, header.size);
  if (header.threw) {
    Outcome outcome = end(Outcome::How::threw, bytes);
    outcome.exit_signal = 0;  // It was ended here, after the fact.
    outcome.time_ns = header.time_ns;
    return outcome;
  }
  Outcome outcome{.how = Outcome::How::answered, .time_ns = header.time_ns};
  try {
    outcome.result = decode(bytes);
  } catch (const std::exception& error) {  // A solver has overwritten its memory or our socket.
    return end(Outcome::How::died, fmt::format("sent what is no answer: {}", error.what()));
  }
  outcome.answer = std::move(bytes);
  return outcome;
}

Outcome Worker::end(Outcome::How how, const std::string& message) {
  const nanoseconds time = Clock::now() - asked_;
  process_.stop();
  drain_output();
  return {.how = how, .time_ns = time.count(), .message = message, .exit_signal = SIGKILL};
}

Outcome Worker::death() {
  const nanoseconds time = Clock::now() - asked_;
  const int status = process_.stop();
  const std::string how = how_it_ended(status, "died of");
  return {.how = Outcome::How::died,
          .time_ns = time.count(),
          .message = how.empty() ? "exited with status 0" : how,
          .exit_signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0};
}

}  // namespace lcp
