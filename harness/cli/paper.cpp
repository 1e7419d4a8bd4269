#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>

#include "harness/cli/interrupt.h"
#include "harness/cli/verbs.h"
#include "harness/paper/reproduce.h"
#include "harness/progress.h"

namespace lcp::cli {

namespace {

struct PaperArguments {
  int table = 0;
  std::string format = "text";
  bool all_solvers = false;
  bool dry_run = false;
  std::string out = "runs/paper";
  std::optional<int> jobs;
};

const std::map<std::string, TableFormat>& formats() {
  static const std::map<std::string, TableFormat> all = {{"text", TableFormat::text},
                                                         {"csv", TableFormat::csv},
                                                         {"json", TableFormat::json},
                                                         {"latex", TableFormat::latex}};
  return all;
}

int print_table(const PaperArguments& arguments) {
  const PaperPlan plan = paper_plan(arguments.table, arguments.all_solvers);
  Reproduction how;
  how.directory = fmt::format("{}/table{}", arguments.out, arguments.table);
  how.jobs = arguments.jobs.value_or(plan.jobs);
  how.note = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  if (arguments.dry_run) {
    for (const std::string& line : missing_work(plan, how)) fmt::print("{}\n", line);
    return done;
  }
  const std::atomic<bool>& interrupted = catch_interruptions();
  std::optional<PaperTable> table;
  {
    ProgressBar bar;
    how.progress = [&bar](const Progress& progress) { bar.update(progress); };
    table = reproduce(plan, how, interrupted);
  }
  if (!table) {
    fmt::print(stderr, "interrupted: what is finished is in {}; the same command goes on\n",
               how.directory.string());
    return interrupted_by_user;
  }
  fmt::print("{}", render(*table, formats().at(arguments.format)));
  fmt::print(stderr, "columns, corpus and rows are in {}\n", how.directory.string());
  return done;
}

}  // namespace

Verb add_paper(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "paper", "The paper's tables: published, in the loop and on a corpus, side by side");
  auto arguments = std::make_shared<PaperArguments>();
  page->add_option("--table", arguments->table, "1: squat, or 2: tap-dance")
      ->required()
      ->check(CLI::IsMember({1, 2}));
  // --figure belongs here: exactly one of the two is asked for.
  page->add_option("--format", arguments->format, "How it is printed")
      ->check(CLI::IsMember(&formats()))
      ->capture_default_str();
  page->add_flag("--all-solvers", arguments->all_solvers,
                 "Also a column for every other row of the registry");
  page->add_flag("--dry-run", arguments->dry_run, "Print what is still to be computed");
  page->add_option("--out", arguments->out, "Directory in which simulations and rows are kept")
      ->capture_default_str();
  page->add_option(
          "--jobs", arguments->jobs,
          "Simulations at the same time; disturbs the times. Default: 2 for table 1, which "
          "has none, 1 for table 2")
      ->check(CLI::Range(1, 1024));
  page->footer(
      "Computes what DIR/tableN does not hold yet: an interrupted command goes on when repeated.\n"
      "Success means the paper's criterion with e_max = 1e-3; beside it counts at residual 1e-6.\n"
      "Example:\n"
      "  lcpbench paper --table 1");
  return {page, [arguments] { return print_table(*arguments); }};
}

}  // namespace lcp::cli
