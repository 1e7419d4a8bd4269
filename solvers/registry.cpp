#include "solvers/registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>

#include "solvers/errors.h"

namespace lcp {

namespace {

/// Eigen sizes the blocks of its products by the caches of the machine it finds itself on; the order
/// of summation, and with it the last bit, would follow. One set of sizes for all machines (bytes of
/// L1, L2, L3), set before any row can be called.
[[maybe_unused]] const bool blocking_is_fixed = [] {
  Eigen::setCpuCacheSizes(32 * 1024, 256 * 1024, 2 * 1024 * 1024);
  return true;
}();

const Catalogue<RowInfo, Solver>& rows() { return Catalogue<RowInfo, Solver>::instance(); }

std::vector<AbsentPeer>& absent() {
  static std::vector<AbsentPeer> all;
  return all;
}

NamedSolver make_from(const Row& row, const Spelling& spelling) {
  Row::Made made = row.with(spelling);
  return {std::move(made.spelling), std::move(made.info), std::move(made.thing)};
}

/// Throws, naming the package, when `pattern` fits peers that are not built in.
void refuse_absent(const std::string& pattern) {
  for (const AbsentPeer& peer : absent_peers()) {
    if (fnmatch(pattern.c_str(), peer.name.c_str(), 0) != 0) continue;
    throw InvalidArgument(
        "solver '{}' is not built in: it needs {}, Debian package {}; install it, then "
        "configure and build again",
        pattern, peer.outside_library, peer.package);
  }
}

}  // namespace

Absence::Absence(const std::vector<std::string>& names, const std::string& library,
                 const std::string& package) {
  for (const std::string& name : names) absent().push_back({name, library, package});
  std::sort(absent().begin(), absent().end(),
            [](const AbsentPeer& a, const AbsentPeer& b) { return a.name < b.name; });
}

const std::vector<Row>& registry() { return rows().rows(); }

std::vector<std::string> rows_in_suites(const std::vector<Row>& rows) {
  std::vector<const RowInfo*> own;
  for (const Row& row : rows)
    if (!row.info.peer()) own.push_back(&row.info);
  std::stable_sort(own.begin(), own.end(), [](const RowInfo* a, const RowInfo* b) {
    return a->in_suites.place < b->in_suites.place;
  });
  std::vector<std::string> spellings;
  for (const RowInfo* info : own)
    for (const std::string& setting : info->in_suites.settings)
      spellings.push_back(setting.empty() ? info->name : info->name + ":" + setting);
  return spellings;
}

const std::vector<AbsentPeer>& absent_peers() { return absent(); }

const Row& find_row(const std::string& name) {
  refuse_absent(name);
  return rows().find(name);
}

NamedSolver make_solver(const std::string& text) {
  const Spelling spelling = parse_spelling(text);
  return make_from(find_row(spelling.name), spelling);
}

bool names_several(const std::string& text) {
  const std::string name = parse_spelling(text).name;
  return name == "own" || name == "all" || name.find_first_of("*?[") != std::string::npos;
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
    const bool own = spelling.name == "own";
    const std::string pattern = own || spelling.name == "all" ? "*" : spelling.name;
    if (!names_several(text)) {
      take(make_solver(text));
      continue;
    }
    bool matched = false;
    for (const Row& row : registry()) {
      if (fnmatch(pattern.c_str(), row.info.name.c_str(), 0) != 0) continue;
      if (own && row.info.peer()) continue;
      matched = true;
      take(make_from(row, spelling));
    }
    if (matched) continue;
    refuse_absent(pattern);
    throw InvalidArgument("no solver matches '{}', known are: {}", spelling.name,
                          fmt::join(rows().names(), ", "));
  }
  return solvers;
}

}  // namespace lcp
