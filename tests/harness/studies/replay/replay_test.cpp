#include "harness/studies/replay/replay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "harness/studies/replay/render.h"
#include "harness/studies/replay/search_check.h"
#include "problems/registry.h"
#include "tests/harness/studies/replay/rounded_zero.h"

namespace lcp {
namespace {

using Why = Departure::Why;

Replay replay_of(const Instance& instance, const std::string& solver,
                 StartKind start = StartKind::cold, const ReplayOptions& options = {}) {
  return replay(make_solver(solver), instance, start, options);
}

Instance well_behaved(std::uint64_t seed = 3) {
  return make_instance("well-behaved", strictly_complementary(8, seed, false).problem, {});
}

const std::vector<std::string> family = {"lemke", "lemke-revised", "lexicographic",
                                         "lexicographic-pivot", "lexicographic-revised"};

TEST(Replay, FindsThePivotThatIsARoundedZero) {
  const Replay shown = replay_of(rounded_zero(), "lemke");
  EXPECT_EQ(shown.comparison, Beside::path);
  EXPECT_EQ(shown.judgement.verdict, Verdict::ray);
  ASSERT_TRUE(shown.departure);
  EXPECT_EQ(shown.departure->why, Why::zero_pivot);
  EXPECT_EQ(shown.departure->pivot, 3);
  EXPECT_EQ(shown.departure->row, 2);
  EXPECT_EQ(shown.steps.at(2).event.pivot, -0x1p-53);
  EXPECT_EQ(static_cast<double>(shown.departure->size.value), 0);
  ASSERT_TRUE(shown.first_none);
  EXPECT_EQ(shown.first_none->pivot, 3);
  EXPECT_EQ(shown.departure->rule.row, 0);
  EXPECT_EQ(shown.departure->rule_leaves, 6);
  EXPECT_EQ(shown.path.claim, Claim::solved);
  EXPECT_EQ(shown.path.pivots.size(), 3u);
  EXPECT_DOUBLE_EQ(shown.path.z(0), 48 / 48.5);
  EXPECT_DOUBLE_EQ(shown.path.z(1), 1 - 24 / 48.5);
  EXPECT_LT(shown.path_residual, 1e-15);
}

TEST(Replay, ItsSentenceNamesRowsFromOneAndBothPivots) {
  EXPECT_EQ(sentence(replay_of(rounded_zero(), "lemke"), 3),
            "first wrong pivot: number 3: z_2 enters and takes row 3 (w_3 leaves) with pivot "
            "-1.11e-16, which is 0 in exact arithmetic; the rule takes row 1 (z0 leaves; ratio "
            "0.5052, pivot -0.9898)");
}

TEST(Replay, TakesTheDataAsExact) {
  const Replay shown = replay_of(rounded_zero(-0x1p-52), "lemke");
  ASSERT_GE(shown.path.pivots.size(), 3u);
  EXPECT_EQ(shown.path.pivots[2].choice.row, 2);
  EXPECT_EQ(static_cast<double>(shown.path.pivots[2].choice.pivot.value), -0x1p-52);
  EXPECT_FALSE(shown.departure && shown.departure->pivot <= 3);
}

TEST(Replay, APivotToleranceKeepsTheRunOnThePath) {
  const Replay shown = replay_of(rounded_zero(), "lemke:pivot=1e-12");
  EXPECT_FALSE(shown.departure);
  EXPECT_EQ(shown.judgement.verdict, Verdict::solved);
  EXPECT_EQ(sentence(shown, 3), "no wrong pivot: both take the same 3");
}

TEST(Replay, FollowsEveryRowOfTheFamilyToTheSameEnd) {
  for (const std::string& row : family)
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      const Replay shown = replay_of(well_behaved(seed), row);
      SCOPED_TRACE(row);
      EXPECT_EQ(shown.comparison, Beside::path);
      EXPECT_FALSE(shown.departure);
      EXPECT_EQ(shown.path.claim, Claim::solved);
      EXPECT_EQ(shown.path.pivots.size(), shown.steps.size());
      EXPECT_LT(shown.path_residual, 1e-15);
    }
}

/// Exact ties throughout, small whole numbers: doubles make no error, so that nothing may differ.
TEST(Replay, BreaksTiesAsTheRulesDo) {
  for (const NamedProblem& problem : sample_problems())
    for (const std::string& row : family) {
      SCOPED_TRACE(problem.name + ", " + row);
      const Replay shown = replay_of(make_instance("sample", problem.problem, {}), row);
      if (problem.name == "contact") continue;  // its data are not whole
      EXPECT_FALSE(shown.departure) << sentence(shown, problem.problem.size());
      EXPECT_EQ(shown.path.claim, shown.island_claim);
    }
}

TEST(Replay, FollowsFromAStart) {
  Instance instance = well_behaved();
  instance.previous = Start{.alpha = {0, 3}, .z = {}};
  for (const std::string& row : family) {
    const Replay shown = replay_of(instance, row, StartKind::previous);
    SCOPED_TRACE(row);
    EXPECT_FALSE(shown.departure);
    EXPECT_EQ(shown.path.claim, Claim::solved);
    EXPECT_EQ(shown.path.pivots.size(), shown.steps.size());
  }
  for (const NamedProblem& problem : sample_problems()) {
    if (problem.name != "contact") continue;
    const Replay shown = replay_of(make_instance("corner", problem.problem, {}),
                                   "lexicographic-revised", StartKind::two_step);
    EXPECT_EQ(shown.path.claim, Claim::solved);
    EXPECT_LT(shown.path_residual, 1e-14);
  }
}

TEST(Replay, ChecksEachPivotOfASearch) {
  const Replay shown = replay_of(well_behaved(), "best-first");
  EXPECT_EQ(shown.comparison, Beside::search);
  EXPECT_FALSE(shown.departure);
  EXPECT_EQ(shown.checked, shown.steps.size());
  EXPECT_GT(shown.checked, 0u);
}

TEST(Replay, FindsThePivotThatASearchMayNotTake) {
  const Replay shown =
      replay_of(rounded_zero(), "best-first-tableau:epsilon=1e-9,e_max=1e-3,scale=off");
  EXPECT_EQ(shown.comparison, Beside::search);
  const Problem problem = rounded_zero().problem;
  // The pivots of `lemke`, as if a search had taken them.
  const std::vector<Trace::Step> steps = replay_of(rounded_zero(), "lemke").steps;
  std::size_t checked = 0;
  const std::optional<Departure> departure = check_search(
      problem, {.epsilon = 1e-9, .pivot = 0, .scale = false}, {}, steps, HighLimits(), checked);
  ASSERT_TRUE(departure);
  EXPECT_EQ(departure->why, Why::zero_pivot);
  EXPECT_EQ(departure->pivot, 3);
  EXPECT_EQ(checked, 3u);
}

/// Row 2 blocks at 1/2, row 1 at 1: taking row 1 leaves q'_2 = -1.
TEST(Replay, ASearchMayNotMakeAValueNegative) {
  const Problem problem = plain_problem(MatrixXd{{1, 0}, {-1, 1}}, VectorXd{{-2, -1}});
  PivotEvent step0;
  step0.node = 1;
  step0.row = 1;  // q = (-2, -1): z0 = 1 leaves q'_1 = -1
  step0.entering = 4;
  const std::vector<Trace::Step> steps = {{step0, {}}};
  std::size_t checked = 0;
  const std::optional<Departure> departure = check_search(
      problem, {.epsilon = 1e-9, .pivot = 0, .scale = false}, {}, steps, HighLimits(), checked);
  ASSERT_TRUE(departure);
  EXPECT_EQ(departure->why, Why::infeasible);
  EXPECT_EQ(static_cast<double>(departure->q_min), -1);
}

TEST(Replay, SaysWhereThereIsNothingToCompare) {
  const Replay shown = replay_of(well_behaved(), "projected-gauss-seidel");
  EXPECT_EQ(shown.comparison, Beside::none);
  const std::string page = text(shown, "title", 8);
  EXPECT_NE(page.find("no comparison: this method takes no pivots"), std::string::npos) << page;
}

TEST(Replay, SolvesTheClaimedBasisInHighPrecision) {
  const Replay right = replay_of(rounded_zero(), "lemke:pivot=1e-12");
  ASSERT_TRUE(right.basis_residual);
  EXPECT_EQ(*right.basis_residual, 0);
  // z_1 = -1 in the basis {1}, of scale 1.
  EXPECT_EQ(basis_residual(plain_problem(MatrixXd::Ones(1, 1), VectorXd::Ones(1)), {0}, 10), 1);
  EXPECT_EQ(basis_residual(plain_problem(MatrixXd::Ones(2, 2), VectorXd::Ones(2)), {0, 1}, 10),
            std::nullopt);
}

/// z0 = 1 enters for w_1, then z_1: row 2 blocks at 0.1, but z0, at 1, is within 1 of that and is taken,
/// which leaves w_2 = -0.9. Exact arithmetic does the same.
TEST(Replay, TellsAWrongAnswerOfTheRuleFromOneOfRounding) {
  const Instance instance =
      make_instance("early", plain_problem(MatrixXd::Identity(2, 2), VectorXd{{-1, -0.9}}), {});
  const Replay shown = replay_of(instance, "lexicographic:delta=0,z0=1");
  EXPECT_EQ(shown.judgement.verdict, Verdict::wrong);
  EXPECT_EQ(shown.path.claim, Claim::solved);
  EXPECT_EQ(shown.path_verdict, Verdict::wrong);
  EXPECT_DOUBLE_EQ(shown.path_residual, 0.9);
  EXPECT_FALSE(shown.departure);
}

TEST(Replay, StopsWhereItIsToldAndSaysSo) {
  ReplayOptions options;
  options.high.most_pivots = 2;
  const Replay shown = replay_of(well_behaved(), "lemke", StartKind::cold, options);
  EXPECT_TRUE(shown.path.cut_short);
  EXPECT_FALSE(shown.departure);
  EXPECT_EQ(sentence(shown, 8), "no wrong pivot among the 2 followed");
}

TEST(Replay, ShowsAWindowAroundTheDeparture) {
  ReplayOptions options;
  options.before = 1;
  options.after = 0;
  const Replay shown = replay_of(rounded_zero(), "lemke", StartKind::cold, options);
  EXPECT_EQ(shown.begin, 1u);
  EXPECT_EQ(shown.end, 3u);
  EXPECT_FALSE(shown.steps[0].condition);
  EXPECT_TRUE(shown.steps[2].condition);
  const std::string page = text(shown, "rounded-zero (n = 3), lemke", 3);
  EXPECT_NE(page.find("\n>     3"), std::string::npos) << page;
  EXPECT_NE(page.find("left out: 1 pivots before these, 0 after"), std::string::npos) << page;
}

TEST(Replay, IsOneScreen) {
  for (const char* row : {"lemke", "lexicographic", "best-first", "lemke-revised"}) {
    const Instance frame = generate("squat-like:contacts=8", {.count = 1, .seed = 4}).front();
    std::istringstream lines(text(replay_of(frame, row), frame.name, frame.problem.size()));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 100u) << line;
    EXPECT_LE(count, 24) << row;
  }
}

TEST(Replay, ItsJsonHoldsWhatThePageSays) {
  const nlohmann::ordered_json page = json(replay_of(rounded_zero(), "lemke"), 3);
  EXPECT_EQ(page["departure"]["pivot"], 3);
  EXPECT_EQ(page["departure"]["why"], "zero pivot");
  EXPECT_EQ(page["departure"]["row"], 3);
  EXPECT_EQ(page["departure"]["rule_row"], 1);
  EXPECT_EQ(page["in_113_bits"]["claim"], "solved");
  EXPECT_EQ(page["shown"][2]["leaving"], "w_3");
  EXPECT_EQ(page["shown"][2]["in_113_bits"]["leaving"], "z0");
}

}  // namespace
}  // namespace lcp
