#include <fmt/format.h>

#include <cstdio>

#include "harness/cli/stability/parts.h"
#include "harness/cli/verbs.h"
#include "problems/io/replace_file.h"

namespace lcp::cli {

void write_pages(const std::filesystem::path& directory, const std::string& name,
                 const StudyPages& pages, const std::string& format) {
  const auto file = [&](const char* ending) { return (directory / (name + ending)).string(); };
  replace_file(file(".txt"), pages.text);
  replace_file(file(".csv"), pages.csv);
  replace_file(file(".json"), pages.json);
  fmt::print("{}", format == "csv" ? pages.csv : format == "json" ? pages.json : pages.text);
  std::fflush(stdout);  // it stands, whatever becomes of the picture
  if (pages.figure) draw_figure(file(".svg"), pages.figure());
}

int report_interruption(const std::string& rows, const std::filesystem::path& directory) {
  fmt::print(stderr, "interrupted: {} are in {}; the same command with --resume goes on\n", rows,
             directory.string());
  return interrupted_by_user;
}

Verb add_stability(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "stability", "Test methods where they fail: disturbed data, families made harder, scenes");
  page->require_subcommand(1);
  page->footer("Example:\n  lcpbench stability perturb --help");
  return {page,
          {},
          {add_stability_perturb(*page), add_stability_frontier(*page), add_stability_loop(*page)}};
}

}  // namespace lcp::cli
