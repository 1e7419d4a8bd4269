#include "harness/cli/start.h"

#include <algorithm>

#include "harness/cli/page.h"

namespace lcp::cli {

void add_start_option(CLI::App& page, std::vector<std::string>& starts) {
  std::vector<std::string> names;
  for (const StartKind kind : all_values<StartKind>()) names.push_back(to_string(kind));
  add_with_default(
      page, "--start", starts,
      "Where solvers start: nowhere (cold), from the active normals of the frictionless "
      "LCP, which the same solver solves first (two-step), or from the solution of the "
      "frame before, where the instance holds it (previous); repeatable",
      CLI::IsMember(names));
}

std::vector<StartKind> start_kinds(const std::vector<std::string>& names) {
  std::vector<StartKind> kinds;
  for (const StartKind kind : all_values<StartKind>())
    if (std::find(names.begin(), names.end(), to_string(kind)) != names.end())
      kinds.push_back(kind);
  return kinds;
}

}  // namespace lcp::cli
