// tests/data/shrunk: the least that failures need, as `lcpbench shrink` left it; its README says of each
// what it shows.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <set>

#include "harness/judge.h"
#include "harness/measure/solve.h"
#include "harness/replay/replay.h"
#include "harness/shrink/parts.h"
#include "harness/shrink/shrink.h"
#include "problems/io/load.h"
#include "problems/registry.h"

namespace lcp {
namespace {

std::vector<Instance> stored() { return load_instances(SHRUNK_INSTANCES); }

/// The solver of a stored instance; empty where this build lacks its library.
std::optional<NamedSolver> solver_of(const Instance& instance) {
  const std::string& spelling = instance.provenance.at("solver");
  for (const AbsentPeer& peer : absent_peers())
    if (peer.name == parse_spelling(spelling).name) return std::nullopt;
  return make_solver(spelling);
}

Verdict verdict_of(const NamedSolver& solver, const Instance& instance) {
  return judge(instance, solve_instance(*solver.solver, instance), 1e-6).verdict;
}

class ShrunkInstance : public testing::TestWithParam<Instance> {};

TEST_P(ShrunkInstance, StillFailsWithTheSameVerdict) {
  const std::optional<NamedSolver> solver = solver_of(GetParam());
  if (!solver) GTEST_SKIP() << GetParam().provenance.at("solver") << " is not built in";
  EXPECT_EQ(to_string(verdict_of(*solver, GetParam())), GetParam().provenance.at("verdict"));
}

TEST_P(ShrunkInstance, IsSolvedByBestFirst) {
  const NamedSolver best_first = make_solver("best-first");
  EXPECT_EQ(verdict_of(best_first, GetParam()), Verdict::solved);
}

TEST_P(ShrunkInstance, IsNotTrivial) { EXPECT_GT(zero_residual(GetParam().problem), 1e-6); }

TEST_P(ShrunkInstance, IsNamedAfterItsContent) {
  EXPECT_EQ(GetParam().name,
            fmt::format("shrunk/{}-{}-{}", parse_spelling(GetParam().provenance.at("solver")).name,
                        GetParam().provenance.at("verdict"), GetParam().sha256.substr(0, 8)));
}

/// Of the rows that shrinking took away none could come back and go: without any one row that is left,
/// the failure or the solution is gone.
TEST_P(ShrunkInstance, NeedsEachOfItsRows) {
  const std::optional<NamedSolver> solver = solver_of(GetParam());
  if (!solver) GTEST_SKIP() << GetParam().provenance.at("solver") << " is not built in";
  const std::atomic<bool> never = false;
  Trials trials({.solver = *solver, .reference = make_solver("best-first")}, ShrinkOptions().limits,
                1000, never, [](Index) {});
  Fared as_it_is;
  as_it_is.solver = trials.run(*solver, GetParam().problem);
  trials.begin_with(GetParam().problem, as_it_is);
  for (Index out = 0; out < GetParam().problem.size(); ++out) {
    std::vector<Index> rows;
    for (Index i = 0; i < GetParam().problem.size(); ++i)
      if (i != out) rows.push_back(i);
    EXPECT_FALSE(trials.keeps(keep_rows(GetParam().problem, rows))) << "without row " << out + 1;
  }
}

std::string name_of(const testing::TestParamInfo<Instance>& instance) {
  std::string name = instance.param.name.substr(instance.param.name.find('/') + 1);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Stored, ShrunkInstance, testing::ValuesIn(stored()), name_of);

}  // namespace

void PrintTo(const Instance& instance, std::ostream* out) { *out << instance.name; }

}  // namespace lcp
