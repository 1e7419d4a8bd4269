#include "solvers/registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <stdexcept>

namespace lcp {

namespace {

/// Eigen sizes the blocks of its products by the caches of the machine it finds itself on; the order
/// of summation, and with it the last bit, would follow. One set of sizes for all machines (bytes of
/// L1, L2, L3), set before any row can be called.
[[maybe_unused]] const bool blocking_is_fixed = [] {
  Eigen::setCpuCacheSizes(32 * 1024, 256 * 1024, 2 * 1024 * 1024);
  return true;
}();

std::vector<Row>& rows() {
  static std::vector<Row> all;
  return all;
}

NamedSolver make_from(const Row& row, const Spelling& spelling) {
  std::shared_ptr<Solver> solver = row.make();
  apply(solver->options(), spelling, row.info.name);
  std::string full = full_spelling(row.info.name, solver->options(), row.make()->options());
  return {std::move(full), row.info, std::move(solver)};
}

std::string row_names() {
  std::vector<std::string> names;
  for (const Row& row : registry()) names.push_back(row.info.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void Registration::add(Row row) {
  const auto place =
      std::lower_bound(rows().begin(), rows().end(), row,
                       [](const Row& a, const Row& b) { return a.info.name < b.info.name; });
  rows().insert(place, std::move(row));
}

const std::vector<Row>& registry() { return rows(); }

const Row& find_row(const std::string& name) {
  for (const Row& row : registry())
    if (row.info.name == name) return row;
  throw std::invalid_argument(fmt::format("unknown solver '{}', known are: {}", name, row_names()));
}

NamedSolver make_solver(const std::string& text) {
  const Spelling spelling = parse_spelling(text);
  return make_from(find_row(spelling.name), spelling);
}

std::vector<NamedSolver> make_solvers(const std::vector<std::string>& texts) {
  std::vector<NamedSolver> solvers;
  const auto take = [&](NamedSolver solver) {
    const bool known = std::any_of(solvers.begin(), solvers.end(), [&](const NamedSolver& other) {
      return other.spelling == solver.spelling;
    });
    if (!known) solvers.push_back(std::move(solver));
  };
  for (const std::string& text : texts) {
    const Spelling spelling = parse_spelling(text);
    const std::string pattern = spelling.name == "all" ? "*" : spelling.name;
    if (pattern.find_first_of("*?[") == std::string::npos) {
      take(make_solver(text));
      continue;
    }
    bool matched = false;
    for (const Row& row : registry()) {
      if (fnmatch(pattern.c_str(), row.info.name.c_str(), 0) != 0) continue;
      matched = true;
      take(make_from(row, spelling));
    }
    if (!matched)
      throw std::invalid_argument(
          fmt::format("no solver matches '{}', known are: {}", spelling.name, row_names()));
  }
  return solvers;
}

}  // namespace lcp
