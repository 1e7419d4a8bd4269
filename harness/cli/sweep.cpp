#include "harness/sweep.h"

#include <memory>

#include "harness/cli/measurement.h"
#include "harness/cli/verbs.h"

namespace lcp::cli {

namespace {

struct SweepArguments {
  Measurement measurement;
  std::vector<std::string> solvers;
  std::vector<std::string> options;
};

int sweep(const SweepArguments& arguments) {
  std::vector<std::string> settings;
  for (const std::string& solver : arguments.solvers)
    for (const std::string& setting : sweep_settings(solver, arguments.options))
      settings.push_back(setting);
  const std::string first = parse_spelling(arguments.solvers.front()).name;
  return measure(arguments.measurement, make_solvers(settings), "runs/sweep-" + first);
}

}  // namespace

Verb add_sweep(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "sweep", "Measure solvers along their accuracy options: the chart of speed against accuracy");
  auto arguments = std::make_shared<SweepArguments>();
  page->add_option("--solver", arguments->solvers, "NAME[:key=value,...]; repeatable")
      ->required()
      ->allow_extra_args(false);
  page->add_option("--option", arguments->options,
                   "Option whose ladder is climbed; repeatable. Default: all that have one")
      ->allow_extra_args(false);
  add_options(*page, arguments->measurement);
  page->footer(
      "Each option is varied alone. The ladders: lcpbench list solvers.\n"
      "Example:\n"
      "  lcpbench sweep --solver best-first --option epsilon --suite contact --every 10");
  return {page, [arguments] { return sweep(*arguments); }};
}

}  // namespace lcp::cli
