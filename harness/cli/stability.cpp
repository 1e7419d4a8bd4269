#include "harness/cli/stability/parts.h"
#include "harness/cli/verbs.h"

namespace lcp::cli {

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
