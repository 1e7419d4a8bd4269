#include "harness/runs/merge.h"

#include <fmt/format.h>

#include <cstdio>

#include "harness/cli/page.h"
#include "harness/studies/sheet/sheet_files.h"
#include "harness/studies/table/table.h"

namespace lcp::cli {

namespace {

struct MergeArguments {
  std::vector<std::string> directories;  ///< The last one is written.
  MergeOptions options;
};

int merge_runs(const MergeArguments& arguments) {
  const std::string& out = arguments.directories.back();
  std::vector<StoredRun> runs;
  for (auto from = arguments.directories.begin(); from + 1 != arguments.directories.end(); ++from)
    runs.push_back(read_stored_run(*from));
  const StoredRun whole = merge(runs, out, arguments.options,
                                [](const std::string& line) { fmt::print(stderr, "{}\n", line); });
  write_stored_run(whole);
  fmt::print("{}", render(write_tables(out), TableFormat::text));
  std::fflush(stdout);
  write_sheet(out, {}, out);
  fmt::print(stderr, "{} rows of {} runs are in {}\n", whole.rows.size(), runs.size(), out);
  return done;
}

void merge_options(CLI::App& page, MergeArguments& arguments) {
  page.add_option("DIR", arguments.directories, "Run directories, then the new one: DIR... OUT")
      ->required()
      ->expected(2, CLI::detail::expected_max_vector_size);
  page.add_flag("--mixed", arguments.options.mixed,
                "Join rows of different commits or environments too");
}

}  // namespace

Verb add_merge(CLI::App& program) {
  return make_verb<MergeArguments>(
      program, "merge", "Join runs, as of shards, into one", merge_options, merge_runs,
      "Refused: runs that were asked for different things, and a pair that has two rows.\n"
      "Example:\n"
      "  lcpbench merge runs/small-1of2 runs/small-2of2 runs/small");
}

}  // namespace lcp::cli
