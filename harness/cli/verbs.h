#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace lcp::cli {

/// Exit status of the program.
enum ExitStatus {
  done = 0,
  regression = 1,  ///< A comparison or check found a regression, or a law is broken.
  usage = 2,       ///< The message says what is allowed.
  unreadable_input = 3,
  unwritable_output = 4,
  system_failure = 70,  ///< No memory, no process: nothing the caller named.
  interrupted_by_user = 130,
};

/// A verb of the command line: its page of help and options, and what it does. The action returns an
/// ExitStatus; it prints results on stdout, progress and notes on stderr, and throws
/// std::invalid_argument (usage), UnreadableInput or UnwritableOutput. A verb of several parts
/// (`stability perturb`) has these in place of an action.
struct Verb {
  CLI::App* page;
  std::function<int()> act;
  std::vector<Verb> parts = {};
};

Verb add_compare(CLI::App& program);
Verb add_convert(CLI::App& program);
Verb add_generate(CLI::App& program);
Verb add_info(CLI::App& program);
Verb add_list(CLI::App& program);
Verb add_merge(CLI::App& program);
Verb add_paper(CLI::App& program);
Verb add_report(CLI::App& program);
Verb add_run(CLI::App& program);
Verb add_sheet(CLI::App& program);
Verb add_replay(CLI::App& program);
Verb add_run(CLI::App& program);
Verb add_shrink(CLI::App& program);
Verb add_simulate(CLI::App& program);
Verb add_solve(CLI::App& program);
Verb add_stability(CLI::App& program);
Verb add_sufficient(CLI::App& program);
Verb add_sweep(CLI::App& program);
Verb add_table(CLI::App& program);
Verb add_test_solver(CLI::App& program);

}  // namespace lcp::cli
