// tests/data/shrunk: the least that failures need, as `lcpbench shrink` left it; its README says of each
// what it shows.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "harness/judge/judge.h"
#include "harness/measure/solve.h"
#include "harness/studies/replay/replay.h"
#include "harness/studies/shrink/parts.h"
#include "harness/studies/shrink/shrink.h"
#include "problems/io/load.h"
#include "problems/registry.h"

namespace lcp {
namespace {

std::vector<Instance> stored() { return load_instances(SHRUNK_INSTANCES); }

/// Names of the files, which tests are called after: to list them takes no reading.
std::vector<std::string> stored_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(SHRUNK_INSTANCES))
    if (entry.path().extension() == ".hdf5") names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

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

class ShrunkInstance : public testing::TestWithParam<std::string> {
 protected:
  const Instance instance_ = load_instances(std::string(SHRUNK_INSTANCES) + "/" + GetParam()).at(0);
};

TEST_P(ShrunkInstance, StillFailsWithTheSameVerdict) {
  const std::optional<NamedSolver> solver = solver_of(instance_);
  if (!solver) GTEST_SKIP() << instance_.provenance.at("solver") << " is not built in";
  EXPECT_EQ(to_string(verdict_of(*solver, instance_)), instance_.provenance.at("verdict"));
}

TEST_P(ShrunkInstance, IsSolvedByBestFirst) {
  const NamedSolver best_first = make_solver("best-first");
  EXPECT_EQ(verdict_of(best_first, instance_), Verdict::solved);
}

TEST_P(ShrunkInstance, IsNotTrivial) { EXPECT_GT(zero_residual(instance_.problem), 1e-6); }

TEST_P(ShrunkInstance, IsNamedAfterItsContent) {
  EXPECT_EQ(instance_.name,
            fmt::format("shrunk/{}-{}-{}", parse_spelling(instance_.provenance.at("solver")).name,
                        instance_.provenance.at("verdict"), instance_.sha256.substr(0, 8)));
}

/// Of the rows that shrinking took away none could come back and go: without any one row that is left,
/// the failure or the solution is gone.
TEST_P(ShrunkInstance, NeedsEachOfItsRows) {
  const std::optional<NamedSolver> solver = solver_of(instance_);
  if (!solver) GTEST_SKIP() << instance_.provenance.at("solver") << " is not built in";
  const std::atomic<bool> never = false;
  Trials trials({.solver = *solver, .reference = make_solver("best-first")}, ShrinkOptions().limits,
                1000, never, [](Index) {});
  Fared as_it_is;
  as_it_is.solver = trials.run(*solver, instance_.problem);
  trials.begin_with(instance_.problem, as_it_is);
  for (Index out = 0; out < instance_.problem.size(); ++out) {
    std::vector<Index> rows;
    for (Index i = 0; i < instance_.problem.size(); ++i)
      if (i != out) rows.push_back(i);
    EXPECT_FALSE(trials.keeps(restricted(instance_.problem, rows))) << "without row " << out + 1;
  }
}

std::string name_of(const testing::TestParamInfo<std::string>& file) {
  std::string name = std::filesystem::path(file.param).stem();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Stored, ShrunkInstance, testing::ValuesIn(stored_files()), name_of);

/// Those whose parents a family draws anew; the others' are frames of scenes.
TEST(ShrunkInstances, OfFamiliesAreWhatShrinkingTheirParentsGives) {
  Index drawn = 0;
  for (const Instance& instance : stored()) {
    SCOPED_TRACE(instance.name);
    const std::map<std::string, std::string>& told = instance.provenance;
    const std::string family = family_of(instance);
    if (family != "squat-like" && family != "stack") continue;
    if (!solver_of(instance)) continue;  // StillFailsWithTheSameVerdict is skipped, and says why
    ++drawn;
    const Index number = std::stoi(told.at("parent").substr(family.size() + 1));
    const Instance parent = generate(family, {.count = number + 1, .seed = 1}).back();
    ASSERT_EQ(parent.sha256, told.at("parent_sha256"));

    Invariant invariant{.solver = make_solver(told.at("solver")),
                        .reference = make_solver(told.at("reference")),
                        .tolerance = std::stod(told.at("tolerance"))};
    if (told.at("by_rounding") == "asked for") invariant.by_rounding = path_rule(invariant.solver);
    const std::atomic<bool> never = false;
    const Instance again = shrink(parent, invariant, {}, never).instance;
    EXPECT_EQ(again.name, instance.name);
    EXPECT_EQ(again.sha256, instance.sha256);
    EXPECT_EQ(again.provenance, told);
  }
  EXPECT_GE(drawn, 3);
}

/// Those shrunk with --by-rounding.
TEST(ShrunkInstances, SpoiltByRoundingLeaveThePathOfTheirRuleWhich113BitsFollowToASolution) {
  Index spoilt = 0;
  for (const Instance& instance : stored()) {
    if (instance.provenance.at("by_rounding") != "asked for") continue;
    SCOPED_TRACE(instance.name);
    ++spoilt;
    const Replay shown = replay(make_solver(instance.provenance.at("solver")), instance,
                                StartKind::cold, ReplayOptions());
    EXPECT_TRUE(shown.departure);
    EXPECT_EQ(shown.path.claim, Claim::solved);
    EXPECT_LT(shown.path_residual, 1e-12);
  }
  EXPECT_GE(spoilt, 1);
}

}  // namespace
}  // namespace lcp
