#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "harness/cli/verbs.h"
#include "harness/studies/laws/laws.h"

namespace lcp::cli {

namespace {

const char* word(LawOutcome::Status status) {
  switch (status) {
    case LawOutcome::Status::holds:
      return "ok";
    case LawOutcome::Status::broken:
      return "FAIL";
    case LawOutcome::Status::not_applicable:
      return "n/a";
  }
  return "";
}

int test_solvers(const std::string& pattern) {
  bool all_hold = true;
  for (const NamedSolver& solver : make_solvers({pattern})) {
    fmt::print("{}\n", solver.spelling);
    for (const Law& law : laws()) {
      fmt::print("  {:<16} ", law.name);
      std::fflush(stdout);  // so that a law that hangs or crashes is named
      const LawOutcome outcome = check(law, solver);
      fmt::print("{:<5} {}{}{}\n", word(outcome.status), law.statement,
                 outcome.detail.empty() ? "" : ": ", outcome.detail);
      if (outcome.status == LawOutcome::Status::broken) all_hold = false;
    }
  }
  return all_hold ? done : regression;
}

}  // namespace

Verb add_test_solver(CLI::App& program) {
  CLI::App* page =
      program.add_subcommand("test-solver", "Check the laws that every solver must obey");
  auto name = std::make_shared<std::string>();
  page->add_option("NAME", *name, "NAME[:key=value,...], pattern or all")->required();
  page->footer("Exit status 1 if a law is broken.\nExample:\n  lcpbench test-solver best-first");
  return {page, [name] { return test_solvers(*name); }};
}

}  // namespace lcp::cli
