#include "harness/cli/start.h"

#include <vector>

#include "harness/measure/solve.h"

namespace lcp::cli {

void add_start_option(CLI::App& page, std::string& start) {
  std::vector<std::string> names;
  for (const StartKind kind : all_start_kinds()) names.push_back(to_string(kind));
  page.add_option("--start", start,
                  "Starting basis: none, or the active normals of the frictionless LCP, which the "
                  "same solver solves first")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
}

}  // namespace lcp::cli
