#include <fmt/format.h>

#include <cstdio>

#include "harness/cli/page.h"
#include "harness/studies/laws/laws.h"

namespace lcp::cli {

namespace {

/// By LawOutcome::Status.
constexpr const char* outcome_words[] = {"ok", "FAIL", "n/a"};

struct TestSolverArguments {
  std::string name;
};

constexpr const char* words[] = {"ok", "FAIL", "n/a"};  // as LawOutcome::Status

int test_solvers(const TestSolverArguments& arguments) {
  bool all_hold = true;
  for (const NamedSolver& solver : make_solvers({arguments.name})) {
    fmt::print("{}\n", solver.spelling);
    for (const Law& law : laws()) {
      fmt::print("  {:<16} ", law.name);
      std::fflush(stdout);  // so that a law that hangs or crashes is named
      const LawOutcome outcome = check(law, solver);
      fmt::print("{:<5} {}{}{}\n", words[static_cast<int>(outcome.status)], law.statement,
                 outcome.detail.empty() ? "" : ": ", outcome.detail);
      if (outcome.status == LawOutcome::Status::broken) all_hold = false;
    }
  }
  return all_hold ? done : regression;
}

}  // namespace

Verb add_test_solver(CLI::App& program) {
  return make_verb<TestSolverArguments>(
      program, "test-solver", "Check the laws that every solver must obey",
      [](CLI::App& page, TestSolverArguments& arguments) {
        add(page, "NAME", arguments.name, "NAME[:key=value,...], pattern or all")->required();
      },
      test_solvers,
      "Exit status 1 if a law is broken.\nExample:\n  lcpbench test-solver best-first");
}

}  // namespace lcp::cli
