#include "solvers/peers/outside_call.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/common_interface_defs.h>
#endif

namespace lcp {

namespace {

struct UnderWay {
  const char* row = nullptr;  ///< Of the call under way.
  int out = -1, err = -1;     ///< Where its descriptors 1 and 2 really lead.
  bool for_good = false;      ///< Descriptors 1 and 2 lead to /dev/null until the process ends.
};
UnderWay under_way;

void write_all(int file, const char* text) {
  if (write(file, text, std::strlen(text)) < 0) return;  // Nobody is left to tell.
}

/// Says on the real stderr whose call ended the process. Only calls that a signal handler may make.
void last_words(const char* how) {
  if (!under_way.row) return;
  write_all(under_way.err, under_way.row);
  write_all(under_way.err, how);
}

void on_signal(int signal) {
  last_words(signal == SIGABRT ? ": the outside library aborted the process\n"
                               : ": the outside library crashed the process\n");
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void on_exit() { last_words(": the outside library ended the process with exit()\n"); }

/// A sanitizer keeps the signals it reports.
void listen_for_the_end() {
  std::atexit(on_exit);
#ifdef __SANITIZE_ADDRESS__
  const int signals[] = {SIGABRT};
#else
  const int signals[] = {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
#endif
  for (const int signal : signals) {
    const auto before = std::signal(signal, on_signal);
    if (before != SIG_DFL && before != SIG_ERR) std::signal(signal, before);
  }
}

void report_to([[maybe_unused]] int file) {
#ifdef __SANITIZE_ADDRESS__
  __sanitizer_set_report_fd(reinterpret_cast<void*>(static_cast<std::intptr_t>(file)));
#endif
}

void restore(int from, int to) {
  if (from < 0) {  // It was closed before.
    close(to);
    return;
  }
  dup2(from, to);
  close(from);
}

}  // namespace

Option scale_option(PeerOptions& options) {
  return flag("scale", options.scale, "the library sees the problem divided by s_z and s_w");
}

namespace {

void silence() {
  [[maybe_unused]] static const bool listening = (listen_for_the_end(), true);
  std::fflush(stdout);  // What is ours must not go the library's way.
  std::fflush(stderr);
  under_way.out = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  under_way.err = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  // Opened each time: a worker process closes the descriptors that it inherits.
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  if (nowhere > STDERR_FILENO) close(nowhere);
  report_to(under_way.err);
}

}  // namespace

void silence_outside_calls() {
  silence();
  under_way.for_good = true;
}

OutsideCall::OutsideCall(const char* row) {
  if (!under_way.for_good) silence();
  under_way.row = row;
}

OutsideCall::~OutsideCall() {
  under_way.row = nullptr;
  if (under_way.for_good) return;
  std::fflush(stdout);
  std::fflush(stderr);
  restore(under_way.out, STDOUT_FILENO);
  restore(under_way.err, STDERR_FILENO);
  report_to(STDERR_FILENO);
}

BoxedForm::BoxedForm(const ScaledProblem& scaled, Index padded)
    : A(MatrixXd::Zero(padded, scaled.size())),
      x(VectorXd::Zero(scaled.size())),
      w(x),
      b(-scaled.q()),
      low(x),
      high(VectorXd::Constant(scaled.size(), std::numeric_limits<double>::infinity())),
      friction(scaled.size(), -1) {
  A.topRows(scaled.size()) = scaled.M().transpose();
}

Obstacle unsymmetric(const MatrixXd& M, double symmetry) {
  const double difference = (M - M.transpose()).cwiseAbs().maxCoeff();
  const double largest = M.cwiseAbs().maxCoeff();
  if (difference <= symmetry * largest) return "";
  return fmt::format("needs a symmetric M: |M - M'| is {:.2g} of max |M|, allowed is {:.2g}",
                     difference / largest, symmetry);
}

Obstacle no_positive_diagonal(const MatrixXd& M) {
  for (Index i = 0; i < M.rows(); ++i)
    if (!(M(i, i) > 0))
      return fmt::format("needs a positive diagonal: M_{},{} is {:.2g}", i + 1, i + 1, M(i, i));
  return "";
}

Obstacle negative_diagonal(const MatrixXd& M) {
  for (Index i = 0; i < M.rows(); ++i)
    if (!(M(i, i) >= 0))
      return fmt::format("needs a diagonal >= 0: M_{},{} is {:.2g}", i + 1, i + 1, M(i, i));
  return "";
}

Obstacle any_start(const Call& call) { return call.start ? "takes no starting point" : ""; }

Result refuse(const Problem& problem, const Obstacle& why) {
  Result result;
  result.claim = Claim::unsupported;
  result.message = why;
  result.z = VectorXd::Zero(problem.size());
  return result;
}

Result solved_empty() {
  Result result;
  result.claim = Claim::solved;
  return result;
}

Result outside_result(const ScaledProblem& scaled, Claim claim, std::string message, VectorXd z,
                      VectorXd w, const Work& work) {
  Result result;
  result.claim = claim;
  result.message = std::move(message);
  result.work = work;
  result.z = std::move(z);
  result.w = std::move(w);
  const bool has_w = result.w.size() == scaled.size() && result.w.allFinite();
  if (!has_w) result.w = VectorXd::Zero(scaled.size());
  VectorXd covering = VectorXd::Zero(scaled.size());
  scaled.unscale(result.z, result.w, covering);
  if (!has_w) result.w.resize(0);
  if (!result.z.allFinite()) {
    if (claim == Claim::solved) {
      result.claim = Claim::singular;
      result.message = "the library reported success with a z that is not finite";
    }
    result.z = VectorXd::Zero(scaled.size());
    result.w.resize(0);
  }
  return result;
}

}  // namespace lcp
