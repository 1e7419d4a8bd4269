#include <filesystem>
#include <memory>

#include "harness/cli/measurement.h"
#include "harness/cli/verbs.h"
#include "harness/studies/suites.h"

namespace lcp::cli {

namespace {

struct RunArguments {
  Measurement measurement;
  std::vector<std::string> solvers;
  std::vector<std::string> added;
};

/// Name of a run of a corpus: the file's name without its ending, or the directory's.
std::string stem(const std::filesystem::path& corpus) {
  return (corpus.has_filename() ? corpus : corpus.parent_path()).stem().string();
}

int run_suite_or_corpora(const RunArguments& arguments) {
  const std::string suite = suite_name(arguments.measurement);
  std::vector<std::string> solvers = arguments.solvers;
  if (solvers.empty())
    solvers = suite.empty() ? std::vector<std::string>{"own"} : find_suite(suite).solvers;
  solvers.insert(solvers.end(), arguments.added.begin(), arguments.added.end());
  const std::string name = suite.empty() ? stem(arguments.measurement.corpora.front()) : suite;
  return measure(arguments.measurement, make_solvers(solvers), "runs/" + name);
}

}  // namespace

Verb add_run(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "run", "Measure solvers on a suite or corpora; write rows, table and sheet");
  auto arguments = std::make_shared<RunArguments>();
  page->add_option(
          "--solver", arguments->solvers,
          "NAME[:key=value,...], pattern, own or all; repeatable. Default: the suite's, or own")
      ->allow_extra_args(false);
  page->add_option("--add", arguments->added, "The same, beside those of --solver or the suite")
      ->allow_extra_args(false);
  add_options(*page, arguments->measurement);
  page->footer(
      "Writes DIR/{run.json, env.json, rows.jsonl, table.txt, table.csv, table.json} and the files "
      "of "
      "lcpbench sheet; DIR is runs/SUITE unless --out names it.\n"
      "Example:\n"
      "  lcpbench run --suite small --solver 'best-first*' --solver lexicographic:delta=1e-10\n"
      "  lcpbench run --suite contact --start cold --start two-step --start previous --solver "
      "best-first");
  return {page, [arguments] { return run_suite_or_corpora(*arguments); }};
}

}  // namespace lcp::cli
