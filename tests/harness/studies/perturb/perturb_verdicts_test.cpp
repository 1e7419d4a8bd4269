// What no disturbance may do to a verdict.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>

#include "harness/judge/judge.h"
#include "harness/measure/solve.h"
#include "harness/studies/perturb/perturb_plan.h"
#include "harness/studies/suites.h"
#include "problems/io/load.h"

namespace lcp {

void PrintTo(const Row& row, std::ostream* out) { *out << row.info.name; }

namespace {

Verdict verdict_of(const NamedSolver& solver, const Instance& instance) {
  return judge(instance, solve_instance(*solver.solver, instance), 1e-6).verdict;
}

std::vector<Row> pivoting_rows() {
  std::vector<Row> rows;
  for (const Row& row : registry())
    if (row.info.kind == RowInfo::Kind::pivoting) rows.push_back(row);
  return rows;
}

/// Strictly complementary, so that the solution's basis outlives small changes.
class PivotingRow : public testing::TestWithParam<std::tuple<Row, std::string>> {};

TEST_P(PivotingRow, NeverFlipsOnAPMatrixUnderLastBitNoise) {
  const auto& [row, kind] = GetParam();
  const NamedSolver solver = make_solver(row.info.name);
  PerturbOptions options;
  options.kinds = {DisturbanceKind::noise};
  Index solved = 0;
  for (const Instance& instance :
       generate("random-p:degenerate=0,n=20,kind=" + kind, {.count = 4, .seed = 1})) {
    const Verdict undisturbed = verdict_of(solver, instance);
    if (undisturbed == Verdict::unsupported)
      GTEST_SKIP() << row.info.name << " does not support " << kind << ", only "
                   << row.info.supports;
    solved += undisturbed == Verdict::solved;
    for (const Disturbance& each : disturbances_of(instance, options)) {
      const Disturbed disturbed = disturb(instance, each, options);
      EXPECT_EQ(to_string(verdict_of(solver, disturbed.instance)), to_string(undisturbed))
          << disturbed.instance.name;
    }
  }
  EXPECT_EQ(solved, 4) << "a row that never solves cannot flip";
}

INSTANTIATE_TEST_SUITE_P(
    Registry, PivotingRow,
    testing::Combine(testing::ValuesIn(pivoting_rows()),
                     testing::Values<std::string>("definite,skew=0", "definite", "dominant",
                                                  "triangular")),
    [](const auto& row) {
      std::string name = std::get<0>(row.param).info.name + "_" + std::get<1>(row.param);
      std::replace_if(
          name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
      return name;
    });

TEST(Peers, OfThisBuildAreAllThereAre) {
  for (const AbsentPeer& peer : absent_peers())
    GTEST_SKIP() << peer.name << " is not built in: it needs " << peer.package;
}

void expect_no_change_in_millimetres(const Instance& instance) {
  const NamedSolver solver = make_solver("best-first");
  const Instance mm = in_units(instance, {.length = 1000}, "mm").instance;
  EXPECT_EQ(to_string(verdict_of(solver, mm)), to_string(verdict_of(solver, instance)))
      << instance.name;
}

TEST(BestFirst, JudgesContactFamiliesInMillimetresAsInMetres) {
  for (const SuitePart& part : find_suite("contact").parts)
    for (const Instance& instance : generate(part.family, {.count = 2, .seed = 1}))
      expect_no_change_in_millimetres(instance);
}

TEST(BestFirst, JudgesFramesOfScenesInMillimetresAsInMetres) {
  const std::vector<Instance> frames = load_instances(SCENES_SAMPLE);
  ASSERT_GE(frames.size(), 5u);
  for (const Instance& frame : frames) expect_no_change_in_millimetres(frame);
}

}  // namespace
}  // namespace lcp
