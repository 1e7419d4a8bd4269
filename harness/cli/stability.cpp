#include "harness/cli/stability/parts.h"
#include "harness/cli/verbs.h"

namespace lcp::cli {

Verb add_stability(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "stability", "Test methods where they fail: disturbed data, families made harder, scenes");
  page->require_subcommand(1);
  page->footer("Example:\n  lcpbench stability frontier --help");
  return {page, {}, {add_frontier(*page)}};
}

}  // namespace lcp::cli
