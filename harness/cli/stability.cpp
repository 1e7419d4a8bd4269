#include <fmt/format.h>

#include <cstdio>

#include "harness/cli/stability/parts.h"
#include "harness/cli/study_output.h"

namespace lcp::cli {

void write_pages(const std::filesystem::path& directory, const std::string& name,
                 const Described& study, const std::string& format) {
  write_texts(directory, name, study);
  print(study, format);
  std::fflush(stdout);  // it stands, whatever becomes of the picture
  if (!study.figure.panels.empty()) draw_figure(directory / (name + ".svg"), study.figure);
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
