#include "harness/studies/sweep.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>

#include "harness/cli/measurement.h"
#include "harness/cli/page.h"

namespace lcp::cli {

namespace {

struct SweepArguments {
  Measurement measurement;
  std::vector<std::string> solvers;
  std::vector<std::string> options;
};

/// Without the signs of a pattern.
std::string fit_for_a_file(std::string name) {
  std::erase_if(name, [](char c) { return c == '*' || c == '?' || c == '[' || c == ']'; });
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "all" : name;
}

int sweep(const SweepArguments& arguments) {
  const SweepPlan plan = plan_sweep(arguments.solvers, arguments.options);
  if (!plan.without_ladder.empty())
    fmt::print(stderr, "run as they are, without a ladder to climb: {}\n",
               fmt::join(plan.without_ladder, ", "));
  return measure(arguments.measurement, make_solvers(plan.settings),
                 "runs/sweep-" + fit_for_a_file(parse_spelling(arguments.solvers.front()).name));
}

void sweep_options(CLI::App& page, SweepArguments& arguments) {
  add(page, "--solver", arguments.solvers, "NAME[:key=value,...], pattern, own or all; repeatable")
      ->required();
  add(page, "--option", arguments.options,
      "Option whose ladder is climbed; repeatable. Default: all that have one");
  add_options(page, arguments.measurement);
}

}  // namespace

Verb add_sweep(CLI::App& program) {
  return make_verb<SweepArguments>(
      program, "sweep",
      "Measure solvers along their accuracy options: the sheet of speed against accuracy",
      sweep_options, sweep,
      "Each option is varied alone. Rows of a pattern without a ladder run as they are. The "
      "ladders: "
      "lcpbench list solvers.\n"
      "Example:\n"
      "  lcpbench sweep --solver own --corpus squat.hdf5 --limit 5\n"
      "  lcpbench sweep --solver best-first --option epsilon --suite contact --every 10");
}

}  // namespace lcp::cli
