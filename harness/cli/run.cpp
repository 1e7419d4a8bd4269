#include <filesystem>

#include "harness/cli/measurement.h"
#include "harness/cli/page.h"
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

void run_options(CLI::App& page, RunArguments& arguments) {
  add(page, "--solver", arguments.solvers,
      "NAME[:key=value,...], pattern, own or all; repeatable. Default: the suite's, or own");
  add(page, "--add", arguments.added, "The same, beside those of --solver or the suite");
  add_options(page, arguments.measurement);
}

}  // namespace

Verb add_run(CLI::App& program) {
  return make_verb<RunArguments>(
      program, "run", "Measure solvers on a suite or corpora; write rows, table and sheet",
      run_options, run_suite_or_corpora,
      "Writes DIR/{run.json, env.json, rows.jsonl, table.txt, table.csv, table.json} and the files "
      "of lcpbench sheet; DIR is runs/SUITE unless --out names it.\n"
      "Example:\n"
      "  lcpbench run --suite small --solver 'best-first*' --solver lexicographic:delta=1e-10\n"
      "  lcpbench run --suite contact --start cold --start two-step --start previous --solver "
      "best-first");
}

}  // namespace lcp::cli
