#include "harness/studies/loop/loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcp {
namespace {

LoopStudy driven(const std::vector<std::string>& solvers) {
  LoopPlan plan;
  plan.scene = "squat:points=8";
  plan.duration = 0.03;
  plan.reference = "best-first";
  plan.solvers = solvers;
  const std::atomic<bool> never = false;
  return *loop_study(
      plan, [](const Progress&) {}, never);
}

Drift most_of(const LoopLine& line) {
  return largest(line.drifts, std::numeric_limits<double>::infinity());
}

TEST(LoopStudy, TheReferenceDrivesItselfWithoutDrift) {
  const LoopStudy study = driven({"best-first"});
  ASSERT_EQ(study.lines.size(), 3u);
  EXPECT_EQ(most_of(study.lines[2]).distance, 0);
  EXPECT_EQ(most_of(study.lines[2]).energy, 0);
  EXPECT_FALSE(study.lines[2].control);
}

TEST(LoopStudy, TheControlsAreDisturbedAndFiner) {
  const LoopStudy study = driven({});
  ASSERT_EQ(study.lines.size(), 2u);
  const Drift disturbed = most_of(study.lines[0]), halved = most_of(study.lines[1]);
  EXPECT_GT(disturbed.distance, 0);
  EXPECT_LT(disturbed.distance, 1e-9);
  EXPECT_EQ(study.lines[1].track.frames(), 60);
  EXPECT_GT(halved.distance, disturbed.distance);
  EXPECT_LT(halved.distance, 1e-3);
}

TEST(LoopStudy, ASolverThatFindsNoForcesPartsAndOneThatCrashesIsALine) {
  const LoopStudy study = driven({"nan-maker", "crasher"});
  const LoopLine &without = study.lines[2], &crashed = study.lines[3];
  EXPECT_EQ(without.track.failed, without.track.contact_frames);
  EXPECT_TRUE(departed(without, 1e-3).has_value()) << "it falls";
  EXPECT_EQ(crashed.track.frames(), 0);
  EXPECT_TRUE(crashed.drifts.empty());
  const std::string text = render(study, TableFormat::text);
  EXPECT_NE(text.find("broke at t = 0 s: crashed"), std::string::npos) << text;
}

TEST(LoopStudy, AReferenceWithoutAFrameIsNone) {
  LoopPlan plan;
  plan.scene = "squat:points=8";
  plan.duration = 0.01;
  plan.reference = "crasher";
  const std::atomic<bool> never = false;
  EXPECT_THROW(loop_study(
                   plan, [](const Progress&) {}, never),
               std::runtime_error);
}

TEST(LoopStudy, EndsWithoutAnAnswerWhenInterrupted) {
  LoopPlan plan;
  plan.scene = "squat";
  plan.reference = "best-first";
  const std::atomic<bool> interrupted = true;
  EXPECT_FALSE(loop_study(
                   plan, [](const Progress&) {}, interrupted)
                   .has_value());
}

/// Drifts of 0, 1, ..., 9 mm at 0, 1, ..., 9 ms; residuals of as many times 1e-9.
LoopLine by_hand() {
  LoopLine line;
  line.label = "by hand";
  line.track.dt = 1e-3;
  line.track.time = VectorXd::LinSpaced(10, 0, 9e-3);
  line.track.residual = 1e-9 * VectorXd::LinSpaced(10, 0, 9);
  line.track.residual(4) = std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < 10; ++k) line.drifts.push_back({.time = 1e-3 * k, .distance = 1e-3 * k});
  return line;
}

TEST(LoopLine, DepartsWhenItIsFirstSoFarAway) {
  EXPECT_DOUBLE_EQ(*departed(by_hand(), 2.5e-3), 3e-3);
  EXPECT_FALSE(departed(by_hand(), 20e-3).has_value());
}

TEST(LoopLine, IsThinnedToTheLargestOfEachPart) {
  const std::vector<LoopSample> samples = thinned(by_hand(), 0.01, 5);
  ASSERT_EQ(samples.size(), 5u);
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(samples[k].time, 2e-3 * (k + 1), 1e-12);
    EXPECT_NEAR(samples[k].drift.distance, 1e-3 * (2 * k + 1), 1e-12);
    EXPECT_NEAR(samples[k].residual, 1e-9 * (2 * k + 1), 1e-18);
  }
}

TEST(LoopStudy, TheCurvesAreALineForEachPart) {
  const LoopStudy study = driven({"best-first"});
  const std::string csv = render(study, TableFormat::csv);
  EXPECT_GE(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 30);
  EXPECT_THROW(render(study, TableFormat::latex), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
