#include "harness/studies/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "solvers/registry.h"

namespace lcp {
namespace {

const Option& option(const OptionTable& table, const std::string& name) {
  for (const Option& each : table)
    if (each.name == name) return each;
  throw std::invalid_argument(name);
}

TEST(Sweep, ClimbsTheLadderOfTheOptionNamed) {
  const NamedSolver solver = make_solver("best-first");
  const OptionTable table = solver.solver->options();
  std::vector<std::string> expected;
  for (const std::string& value : option(table, "epsilon").accuracy_ladder)
    expected.push_back("best-first:epsilon=" + value);
  EXPECT_GE(expected.size(), 3u);
  EXPECT_EQ(sweep_settings("best-first", {"epsilon"}), expected);
}

TEST(Sweep, KeepsTheSettingsOfTheSpelling) {
  for (const std::string& setting : sweep_settings("best-first:polish=off", {"epsilon"})) {
    EXPECT_EQ(setting.rfind("best-first:polish=off,epsilon=", 0), 0u) << setting;
    EXPECT_NO_THROW(make_solver(setting));
  }
}

TEST(Sweep, WithoutAnOptionClimbsEveryLadderThatIsNotSet) {
  const std::vector<std::string> settings = sweep_settings("projected-gauss-seidel", {});
  EXPECT_EQ(settings, sweep_settings("projected-gauss-seidel", {"tolerance"}));
  for (const std::string& setting : sweep_settings("best-first:epsilon=1e-6", {}))
    EXPECT_EQ(make_solver(setting).spelling.find("epsilon=1e-06"), 11u) << setting;
}

TEST(Sweep, RefusesAnOptionWithoutALadderAndSaysWhichHaveOne) {
  try {
    sweep_settings("best-first", {"ties"});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("it can: epsilon"), std::string::npos) << error.what();
  }
}

TEST(Sweep, RefusesAnOptionThatIsBothSweptAndSet) {
  EXPECT_THROW(sweep_settings("best-first:epsilon=1e-6", {"epsilon"}), std::invalid_argument);
}

TEST(Sweep, RefusesARowWithoutAccuracyOptions) {
  EXPECT_THROW(sweep_settings("liar", {}), std::invalid_argument);
}

TEST(Sweep, OfAPatternClimbsWhatHasALadderAndRunsTheRestAsItIs) {
  const SweepPlan plan = plan_sweep({"l*"}, {"delta"});
  const std::vector<std::string> delta = sweep_settings("lexicographic", {"delta"});
  for (const std::string& setting : delta)
    EXPECT_EQ(std::count(plan.settings.begin(), plan.settings.end(), setting), 1) << setting;
  EXPECT_EQ(plan.without_ladder, (std::vector<std::string>{"lemke", "lemke-revised", "liar"}));
  EXPECT_EQ(std::count(plan.settings.begin(), plan.settings.end(), "lemke"), 1);
}

TEST(Sweep, OfOwnClimbsEveryRowsLadders) {
  const SweepPlan plan = plan_sweep({"own"}, {});
  for (const char* setting : {"best-first:epsilon=1e-03", "projected-gauss-seidel:tolerance=1e-02"})
    EXPECT_EQ(std::count(plan.settings.begin(), plan.settings.end(), setting), 1) << setting;
}

TEST(Sweep, RefusesAPatternOfRowsWithoutTheLadder) {
  EXPECT_THROW(plan_sweep({"best-first*"}, {"delta_of_nobody"}), std::invalid_argument);
  EXPECT_THROW(plan_sweep({"liar"}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
