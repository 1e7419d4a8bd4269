#include "harness/studies/sheet/sheet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <map>
#include <memory>

#include "harness/cli/verbs.h"
#include "harness/runs/run_directory.h"
#include "harness/studies/sheet/sheet_files.h"

namespace lcp::cli {

namespace {

struct SheetArguments {
  std::string directory;
  std::string out;
  std::string measure = "time";
  std::string format = "text";
  SheetOptions options;
};

const std::map<std::string, SheetFormat>& sheet_formats() {
  static const std::map<std::string, SheetFormat> all = {
      {"text", SheetFormat::text}, {"csv", SheetFormat::csv}, {"json", SheetFormat::json}};
  return all;
}

std::vector<std::string> measure_names() {
  std::vector<std::string> names;
  for (const Measure measure : all_measures()) names.push_back(to_string(measure));
  return names;
}

int write_and_print(const SheetArguments& arguments) {
  SheetOptions options = arguments.options;
  options.measure = measure_from_string(arguments.measure);
  const std::string& out = arguments.out.empty() ? arguments.directory : arguments.out;
  const Sheet sheet = make_sheet(read_run(arguments.directory), options);
  fmt::print("{}", render(sheet, sheet_formats().at(arguments.format)));
  std::fflush(stdout);  // the numbers stand, whatever becomes of the pictures
  write_sheet(sheet, out);
  fmt::print(stderr, "sheet and pictures are in {}\n", out);
  return done;
}

}  // namespace

Verb add_sheet(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "sheet", "Speed against accuracy of a run: front, profiles, curves; numbers and pictures");
  auto arguments = std::make_shared<SheetArguments>();
  SheetOptions& options = arguments->options;
  page->add_option("DIR", arguments->directory, "Directory of a run")->required();
  page->add_option("--measure", arguments->measure, "What a solve costs")
      ->check(CLI::IsMember(measure_names()))
      ->capture_default_str();
  page->add_option("--tolerance", options.tolerance,
                   "Largest natural residual (scaled) that counts as solved. Default: the run's")
      ->check(CLI::PositiveNumber);
  page->add_option("--corpus", options.corpora, "Corpus or pattern; repeatable. Default: all")
      ->allow_extra_args(false);
  page->add_option("--accuracy", options.accuracies,
                   "Natural residual of a cumulative curve; repeatable")
      ->check(CLI::PositiveNumber)
      ->allow_extra_args(false)
      ->capture_default_str();
  page->add_option("--budget", options.budgets_ms,
                   "Time (ms) of a curve of accuracy reached in it; repeatable")
      ->check(CLI::PositiveNumber)
      ->allow_extra_args(false)
      ->capture_default_str();
  page->add_option("--count-offset", options.count_offset,
                   "o in the ratio (count + o) / (least count + o), since counts may be 0")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_option("--format", arguments->format, "How it is printed")
      ->check(CLI::IsMember(&sheet_formats()))
      ->capture_default_str();
  page->add_option("--out", arguments->out, "Directory that the files go to. Default: DIR");
  page->footer(
      "Writes sheet.txt, sheet.csv, sheet.json, chart.svg (time against accuracy), "
      "sheet-profile.svg, sheet-cumulative.svg, sheet-accuracy.svg; of another measure "
      "sheet-pivots.txt and so on.\n"
      "Example:\n"
      "  lcpbench sheet runs/small --measure pivots --corpus 'random-*'");
  return {page, [arguments] { return write_and_print(*arguments); }};
}

}  // namespace lcp::cli
