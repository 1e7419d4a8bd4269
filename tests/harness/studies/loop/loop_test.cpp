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
  return loop_study(
      plan, [](const Progress&) {}, never);
}

Drift most_of(const DriftLine& line) {
  return largest(line.drifts, std::numeric_limits<double>::infinity());
}

TEST(LoopStudy, TheReferenceDrivesItselfWithoutDrift) {
  const LoopStudy study = driven({"best-first"});
  ASSERT_EQ(study.lines.size(), 4u);
  EXPECT_EQ(most_of(study.lines[3]).distance, 0);
  EXPECT_EQ(most_of(study.lines[3]).energy, 0);
  EXPECT_FALSE(study.lines[3].control);
}

TEST(LoopStudy, TheControlsAreDisturbedAndFiner) {
  const LoopStudy study = driven({});
  ASSERT_EQ(study.lines.size(), 3u);
  for (const DriftLine& line : study.lines) EXPECT_TRUE(line.control);
  const Drift disturbed = most_of(study.lines[1]), halved = most_of(study.lines[2]);
  EXPECT_GT(disturbed.distance, 0);
  EXPECT_LT(disturbed.distance, 1e-9);
  EXPECT_EQ(study.lines[2].track.frames(), 60);
  EXPECT_GT(halved.distance, disturbed.distance);
  EXPECT_LT(halved.distance, 1e-3);
}

TEST(LoopStudy, ASolverThatFindsNoForcesPartsAndOneThatCrashesIsALine) {
  const LoopStudy study = driven({"nan-maker", "crasher"});
  const DriftLine &without = study.lines[3], &crashed = study.lines[4];
  EXPECT_EQ(without.track.failed, without.track.contact_frames);
  EXPECT_TRUE(departed(without, 1e-3).has_value()) << "it falls";
  EXPECT_EQ(crashed.track.frames(), 0);
  EXPECT_TRUE(crashed.drifts.empty());
  const std::string text = described(study).text;
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
  EXPECT_THROW(loop_study(
                   plan, [](const Progress&) {}, interrupted),
               Interrupted);
}

/// Drifts of 0, 1, ..., 9 mm at 0, 1, ..., 9 ms; residuals of as many times 1e-9.
DriftLine by_hand() {
  DriftLine line;
  line.label = "by hand";
  line.track.dt = 1e-3;
  line.track.time = VectorXd::LinSpaced(10, 0, 9e-3);
  line.track.residual = 1e-9 * VectorXd::LinSpaced(10, 0, 9);
  line.track.residual(4) = std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < 10; ++k) line.drifts.push_back({.time = 1e-3 * k, .distance = 1e-3 * k});
  return line;
}

TEST(DriftLine, DepartsWhenItIsFirstSoFarAway) {
  EXPECT_DOUBLE_EQ(*departed(by_hand(), 2.5e-3), 3e-3);
  EXPECT_FALSE(departed(by_hand(), 20e-3).has_value());
}

TEST(DriftLine, IsThinnedToTheLargestOfEachPart) {
  const std::vector<LoopSample> samples = thinned(by_hand(), 0.01, 5);
  ASSERT_EQ(samples.size(), 5u);
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(samples[k].time, 2e-3 * (k + 1), 1e-12);
    EXPECT_NEAR(samples[k].drift.distance, 1e-3 * (2 * k + 1), 1e-12);
    EXPECT_NEAR(samples[k].residual, 1e-9 * (2 * k + 1), 1e-18);
  }
}

TEST(LoopStudy, ThePictureHasALineForAllButTheReferenceAndOneLookForEach) {
  const LoopStudy study = driven({"best-first", "best-first:epsilon=1e-3"});
  const Figure figure = loop_figure(study);
  ASSERT_EQ(figure.legend.size(), 4u);
  const Look plain = figure.legend[2].look, loose = figure.legend[3].look;
  EXPECT_EQ(plain.colour, look_of_solver("best-first").colour);
  EXPECT_EQ(plain.colour, loose.colour) << "settings of one solver";
  EXPECT_NE(plain.marker, loose.marker);
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series)
      for (const Mark& mark : series.marks)
        EXPECT_FALSE(mark.y < panel.y.low || mark.y > panel.y.high);
}

TEST(LoopStudy, TheCurvesAreALineForEachPart) {
  const LoopStudy study = driven({"best-first"});
  const std::string csv = described(study).csv;
  EXPECT_GE(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 30);
}

}  // namespace
}  // namespace lcp
