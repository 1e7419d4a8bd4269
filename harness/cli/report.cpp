#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "harness/cli/verbs.h"
#include "harness/report/report_data.h"
#include "harness/report/report_page.h"
#include "problems/io/replace_file.h"

namespace lcp::cli {

namespace {

struct ReportArguments {
  std::string directory;
  std::string out;
  std::vector<std::string> attached;
};

int write_report(const ReportArguments& arguments) {
  namespace fs = std::filesystem;
  const fs::path directory = arguments.directory;
  const ReportedRun run = read_reported_run(directory);
  std::vector<Attachments> attachments;
  if (const fs::path pictures = directory / "pictures"; fs::is_directory(pictures))
    attachments.push_back(read_attachments(pictures));
  for (const std::string& each : arguments.attached) attachments.push_back(read_attachments(each));

  const std::string out =
      arguments.out.empty() ? (directory / "report.html").string() : arguments.out;
  const std::string page = report_page(report_data(run), attachments);
  replace_file(out, page);
  fmt::print(stderr, "{} rows are in {} ({:.1f} MB), which a browser opens\n", run.rows.size(), out,
             1e-6 * static_cast<double>(page.size()));
  return done;
}

}  // namespace

Verb add_report(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "report", "Write a run as one page for a browser: matrix of verdicts, charts, tables");
  auto arguments = std::make_shared<ReportArguments>();
  page->add_option("DIR", arguments->directory, "Directory of a run")->required();
  page->add_option("--out", arguments->out, "File to write. Default: DIR/report.html");
  page->add_option("--attach", arguments->attached,
                   "Directory whose pictures (*.svg) and tables (*.txt) the page shows too, as "
                   "those of DIR/pictures; repeatable")
      ->allow_extra_args(false);
  page->footer(
      "The page needs no network and no other file.\n"
      "Example:\n"
      "  lcpbench report runs/default\n"
      "  lcpbench report runs/default --attach results/peers --out report.html");
  return {page, [arguments] { return write_report(*arguments); }};
}

}  // namespace lcp::cli
