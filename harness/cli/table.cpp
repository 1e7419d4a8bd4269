#include "harness/studies/table/table.h"

#include <fmt/format.h>

#include <memory>

#include "harness/cli/table_formats.h"
#include "harness/cli/verbs.h"
#include "harness/runs/run_directory.h"

namespace lcp::cli {

namespace {

struct TableArguments {
  std::string directory;
  std::optional<double> tolerance;
  std::string criterion = "residual";
  std::string format = "text";
};

int print_table(const TableArguments& arguments) {
  const std::vector<Record> records = read_run(arguments.directory);
  const Table table =
      from_string<Acceptance::Criterion>(arguments.criterion) == Acceptance::Criterion::paper
          ? make_table(records, Acceptance{Acceptance::Criterion::paper,
                                           arguments.tolerance.value_or(by_paper.tolerance)})
          : make_table(records, arguments.tolerance);
  fmt::print("{}", render(table, table_formats().at(arguments.format)));
  return done;
}

}  // namespace

Verb add_table(CLI::App& program) {
  CLI::App* page =
      program.add_subcommand("table", "Count the rows of a run: success, failures, work, time");
  auto arguments = std::make_shared<TableArguments>();
  page->add_option("DIR", arguments->directory, "Directory of a run")->required();
  page->add_option("--tolerance", arguments->tolerance,
                   "Judge anew, from the stored residuals, at this tolerance")
      ->check(CLI::PositiveNumber);
  page->add_option("--criterion", arguments->criterion,
                   "residual, or paper: judge anew by |w - M z - q - z0 c| of the solver's own w, "
                   "unscaled, at most 1e-3 or --tolerance")
      ->check(CLI::IsMember({"residual", "paper"}))
      ->capture_default_str();
  page->add_option("--format", arguments->format, "How it is printed")
      ->check(CLI::IsMember(&table_formats()))
      ->capture_default_str();
  page->footer("Example:\n  lcpbench table runs/small --tolerance 1e-9 --format latex");
  return {page, [arguments] { return print_table(*arguments); }};
}

}  // namespace lcp::cli
