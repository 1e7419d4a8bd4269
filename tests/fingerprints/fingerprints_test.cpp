// Stored fingerprints: claim, pivots and a hash of the whole pivot sequence of every pivoting row on
// fixed instances. They must come out of every build, sanitized or optimised, on every x86-64: a
// difference means that somebody's path has changed, which is either a bug or worth a line in the
// commit. After a wanted change:  LCPBENCH_WRITE_FINGERPRINTS=1 build/release/tests/.../test_fingerprints

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "problems/registry.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

using nlohmann::json;

const std::string stored_path = FINGERPRINTS_FILE;

std::vector<Instance> fixed_instances() {
  std::vector<Instance> kept = generate("published", {0, 1});
  for (const auto& [family, count, every] :
       {std::tuple("squat-like", 41, 20), std::tuple("squat-like:contacts=4,mu=0.3", 11, 5),
        std::tuple("draped-chain", 9, 4)}) {
    const std::vector<Instance> drawn = generate(family, {count, 1});
    for (std::size_t i = 0; i < drawn.size(); i += every) kept.push_back(drawn[i]);
  }
  return kept;
}

/// FNV-1a over the numbers of a pivot sequence.
class SequenceHash {
 public:
  void add(std::int64_t number) {
    for (int byte = 0; byte < 8; ++byte) {
      value_ ^= static_cast<std::uint64_t>(number >> (8 * byte)) & 0xff;
      value_ *= 0x100000001b3U;
    }
  }
  std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

json fingerprint(const NamedSolver& solver, const Instance& instance) {
  SequenceHash sequence;
  const Result result = solver.solver->solve(instance.problem, {{}, [&](const PivotEvent& event) {
                                                                  sequence.add(event.row);
                                                                  sequence.add(event.entering);
                                                                  sequence.add(event.leaving);
                                                                }});
  for (const Index i : result.basis.value_or(std::vector<Index>{})) sequence.add(i);
  return {{"claim", to_string(result.claim)},
          {"pivots", result.work.pivots},
          {"sequence", sequence.text()}};
}

/// Every pivoting row of ours; a search, which might not end, with 300 nodes.
std::vector<NamedSolver> pivoting_rows() {
  std::vector<NamedSolver> solvers;
  for (const Row& row : registry()) {
    if (row.info.peer() || row.info.kind != RowInfo::Kind::pivoting) continue;
    const OptionTable options = row.make()->options();
    const bool search = std::any_of(options.begin(), options.end(), [](const Option& option) {
      return option.name == "max_nodes";
    });
    solvers.push_back(make_solver(row.info.name + (search ? ":max_nodes=300" : "")));
  }
  return solvers;
}

json all_fingerprints() {
  json all;
  for (const NamedSolver& solver : pivoting_rows())
    for (const Instance& instance : fixed_instances())
      all[instance.name][solver.spelling] = fingerprint(solver, instance);
  return all;
}

TEST(Fingerprints, OfEveryPivotingRowAreThoseStored) {
  const json now = all_fingerprints();
  if (std::getenv("LCPBENCH_WRITE_FINGERPRINTS")) {
    std::ofstream(stored_path) << now.dump(1) << '\n';
    GTEST_SKIP() << "wrote " << stored_path;
  }
  const json stored = json::parse(std::ifstream(stored_path));
  EXPECT_EQ(now.size(), stored.size());
  for (const auto& [instance, rows] : now.items()) {
    ASSERT_TRUE(stored.contains(instance)) << instance << " has no stored fingerprint";
    for (const auto& [solver, print] : rows.items())
      EXPECT_EQ(print, stored.at(instance).value(solver, json())) << instance << ' ' << solver;
  }
}

}  // namespace
}  // namespace lcp
