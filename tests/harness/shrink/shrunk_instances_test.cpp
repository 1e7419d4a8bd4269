// tests/data/shrunk: the least that failures need, as `lcpbench shrink` left it; its README says of each
// what it shows.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

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

std::string family_of(const Instance& instance) {
  const std::string& parent = instance.provenance.at("parent");
  return parent.substr(0, parent.find('/'));
}

template <class Test>
std::vector<Instance> stored_if(const Test& test) {
  std::vector<Instance> some;
  for (const Instance& instance : stored())
    if (test(instance)) some.push_back(instance);
  return some;
}

/// Those whose parents a family draws anew; the others' are frames of scenes.
std::vector<Instance> drawn() {
  return stored_if([](const Instance& instance) {
    return family_of(instance) == "squat-like" || family_of(instance) == "stack";
  });
}

/// Those shrunk with --by-rounding.
std::vector<Instance> spoilt() {
  return stored_if([](const Instance& instance) {
    return instance.provenance.at("by_rounding") == "asked for";
  });
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

class DrawnShrunkInstance : public ShrunkInstance {};

TEST_P(DrawnShrunkInstance, IsWhatShrinkingItsParentGives) {
  const std::map<std::string, std::string>& told = GetParam().provenance;
  const std::string family = family_of(GetParam());
  const Index number = std::stoi(told.at("parent").substr(family.size() + 1));
  const Instance parent = generate(family, {.count = number + 1, .seed = 1}).back();
  ASSERT_EQ(parent.sha256, told.at("parent_sha256"));

  Invariant invariant{.solver = make_solver(told.at("solver")),
                      .reference = make_solver(told.at("reference")),
                      .tolerance = std::stod(told.at("tolerance"))};
  if (told.at("by_rounding") == "asked for") invariant.by_rounding = path_rule(invariant.solver);
  const std::atomic<bool> never = false;
  const Instance again = shrink(parent, invariant, {}, never).instance;
  EXPECT_EQ(again.name, GetParam().name);
  EXPECT_EQ(again.sha256, GetParam().sha256);
  EXPECT_EQ(again.provenance, told);
}

class SpoiltInstance : public ShrunkInstance {};

TEST_P(SpoiltInstance, LeavesThePathOfItsRuleWhich113BitsFollowToASolution) {
  const Replay shown = replay(make_solver(GetParam().provenance.at("solver")), GetParam(),
                              StartKind::cold, ReplayOptions());
  EXPECT_TRUE(shown.departure);
  EXPECT_EQ(shown.path.claim, Claim::solved);
  EXPECT_LT(shown.path_residual, 1e-12);
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
INSTANTIATE_TEST_SUITE_P(Stored, DrawnShrunkInstance, testing::ValuesIn(drawn()), name_of);
INSTANTIATE_TEST_SUITE_P(Stored, SpoiltInstance, testing::ValuesIn(spoilt()), name_of);

}  // namespace

void PrintTo(const Instance& instance, std::ostream* out) { *out << instance.name; }

}  // namespace lcp
