// Rows that misbehave on purpose. If one of them looks good anywhere, the harness is wrong. They are
// linked into tests only.

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "solvers/peers/outside_call.h"
#include "solvers/registry.h"

namespace lcp {

namespace {

struct NoOptions {};
OptionTable no_table(NoOptions&) { return {}; }

Result claim_solved(VectorXd z) {
  Result result;
  result.claim = Claim::solved;
  result.z = std::move(z);
  return result;
}

/// The solution of LCP(I, q), which the well-behaved half of some controls gives.
VectorXd solution_for_identity(const Problem& problem) { return (-problem.q).cwiseMax(0.0); }

Result lie(const Problem& problem, const NoOptions&, const Call&) {
  return claim_solved(VectorXd::Constant(problem.size(), -1));
}

Result make_nan(const Problem& problem, const NoOptions&, const Call&) {
  return claim_solved(VectorXd::Constant(problem.size(), std::numeric_limits<double>::quiet_NaN()));
}

Result sleep_for_ever(const Problem&, const NoOptions&, const Call&) {
  for (;;) pause();
}

Result crash(const Problem&, const NoOptions&, const Call&) {
  std::fprintf(stderr, "%s", (std::string(1000, '.') + "last words").c_str());
  std::abort();
}

Result crash_outside(const Problem&, const NoOptions&, const Call&) {
  const OutsideCall under_way("outside-crasher");
  std::fprintf(stderr, "what the library says is not kept\n");
  std::abort();
}

Result throw_exception(const Problem&, const NoOptions&, const Call&) {
  throw std::runtime_error("thrown on purpose");
}

/// Takes up to 2 GiB and keeps it; gives up there, so that a harness that does not notice fails its
/// test instead of the machine.
Result eat_memory(const Problem& problem, const NoOptions&, const Call&) {
  constexpr std::size_t piece = std::size_t{1} << 20;
  std::vector<std::vector<char>> eaten;
  for (int i = 0; i < 2048; ++i) eaten.emplace_back(piece, 'x');
  Result result;
  result.claim = Claim::limit;
  result.z = VectorXd::Zero(problem.size());
  return result;
}

/// Solves LCP(I, q), but every call moves the answer by the last bit of one component.
Result flip(const Problem& problem, const NoOptions&, const Call&) {
  static int calls = 0;
  VectorXd z = solution_for_identity(problem);
  if (calls++ % 2 == 1) z(0) = std::nextafter(z(0), 2 * z(0) + 1);
  return claim_solved(std::move(z));
}

struct ScribeOptions {
  std::string label = "?";
  std::string file;
};

OptionTable scribe_table(ScribeOptions& options) {
  return {text("label", options.label, "what is written on each call"),
          text("file", options.file, "file it is appended to")};
}

/// Solves LCP(I, q), and leaves its label in a file, so that the order of calls can be seen.
Result write_label(const Problem& problem, const ScribeOptions& options, const Call&) {
  const int file = open(options.file.c_str(), O_WRONLY | O_APPEND);
  const auto size = static_cast<ssize_t>(options.label.size());
  if (write(file, options.label.data(), options.label.size()) != size)
    throw std::runtime_error(fmt::format("{}: cannot be written", options.file));
  close(file);
  return claim_solved(solution_for_identity(problem));
}

RowInfo control(const char* name, const char* summary) {
  return {
      .name = name, .summary = summary, .source = "null control", .in_suites = {.settings = {}}};
}

const Registration rows[] = {
    {control("liar", "claims solved with z = -1"), NoOptions{}, no_table, lie},
    {control("nan-maker", "claims solved with z = NaN"), NoOptions{}, no_table, make_nan},
    {control("sleeper", "never returns"), NoOptions{}, no_table, sleep_for_ever},
    {control("crasher", "aborts"), NoOptions{}, no_table, crash},
    {control("outside-crasher", "aborts in an outside library"), NoOptions{}, no_table,
     crash_outside},
    {control("thrower", "throws"), NoOptions{}, no_table, throw_exception},
    {control("memory-eater", "takes memory without end"), NoOptions{}, no_table, eat_memory},
    {control("flipper", "answers differently each time"), NoOptions{}, no_table, flip},
    {control("scribe", "tells when it was called"), ScribeOptions{}, scribe_table, write_label},
};

}  // namespace

}  // namespace lcp
