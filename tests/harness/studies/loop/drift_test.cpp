#include "harness/studies/loop/drift.h"

#include <gtest/gtest.h>

#include <limits>

#include "harness/studies/loop/drift_study.h"

namespace lcp {
namespace {

constexpr double kWindow = 0.02;  // s
constexpr double kForever = std::numeric_limits<double>::infinity();

/// Two links of one mechanism with one handle, at rest for `frames` frames; weight 10 N.
Track at_rest(Index frames, double dt = 1e-3) {
  Track track;
  track.dt = dt;
  track.weight = 10;
  track.time = VectorXd::LinSpaced(frames, 0, dt * static_cast<double>(frames - 1));
  track.centres = MatrixXd::Zero(6, frames);
  track.impulse = MatrixXd::Zero(3, frames);
  track.travel = MatrixXd::Zero(1, frames);
  track.depth = track.energy = track.residual = VectorXd::Zero(frames);
  return track;
}

TEST(Drift, OfAMotionFromItselfIsZero) {
  const Track track = at_rest(30);
  const std::vector<Drift> drifts = drift(track, track, kWindow);
  ASSERT_EQ(drifts.size(), 30u);
  const Drift most = largest(drifts, kForever);
  EXPECT_EQ(most.distance, 0);
  EXPECT_EQ(most.force, 0);
  EXPECT_EQ(most.slip, 0);
  EXPECT_EQ(most.depth, 0);
}

TEST(Drift, IsTheLargestDistanceOfALinkAndTheMeanOverLinks) {
  const Track reference = at_rest(3);
  Track track = reference;
  track.centres.col(2) << 3, 0, 4, 0, 1, 0;
  const std::vector<Drift> drifts = drift(track, reference, kWindow);
  EXPECT_EQ(drifts[1].distance, 0);
  EXPECT_DOUBLE_EQ(drifts[2].distance, 5);
  EXPECT_DOUBLE_EQ(drifts[2].mean_distance, 3);
  EXPECT_EQ(largest(drifts, 1.5e-3).distance, 0) << "what comes later does not count";
}

TEST(Drift, AveragesForcesOverTheWindowBeforeAndOverTheWeight) {
  const Track reference = at_rest(101);
  Track track = reference;
  for (Index k = 0; k <= 100; ++k)  // 5 N upwards from 10 ms on
    track.impulse(2, k) = 5 * std::max(0.0, track.time(k) - 0.01);
  const std::vector<Drift> drifts = drift(track, reference, kWindow);
  EXPECT_NEAR(drifts[10].force, 0, 1e-12);
  EXPECT_NEAR(drifts[20].force, 0.25, 1e-12) << "half of the window at half of the weight";
  EXPECT_NEAR(drifts[60].force, 0.5, 1e-12);
}

TEST(Drift, AForceSharedOutOtherwiseWithinAMechanismIsNoDifference) {
  const NamedScene squat = make_scene("squat");
  const std::vector<Index> of = mechanisms(squat.setup.system.model);
  for (const Index mechanism : of) EXPECT_EQ(mechanism, 0) << "both feet are of one robot";
}

TEST(Drift, ReadsTheFinerMotionBetweenItsFrames) {
  Track coarse = at_rest(3, 0.004), fine = at_rest(9, 0.0015);
  for (Index k = 0; k < 9; ++k) fine.depth(k) = 2 * fine.time(k);
  for (Index k = 0; k < 3; ++k) coarse.depth(k) = 2 * coarse.time(k);
  for (const auto& [a, b] : {std::pair(coarse, fine), {fine, coarse}}) {
    const std::vector<Drift> drifts = drift(a, b, kWindow);
    ASSERT_EQ(drifts.size(), 3u) << "at the frames of the coarser one";
    for (const Drift& each : drifts) EXPECT_NEAR(each.depth, 0, 1e-15);
  }
}

TEST(Drift, EndsWhereOneOfTheTwoEnds) {
  EXPECT_EQ(drift(at_rest(5), at_rest(9), kWindow).size(), 5u);
  EXPECT_EQ(drift(at_rest(9), at_rest(5), kWindow).size(), 5u);
  EXPECT_TRUE(drift(Track{}, at_rest(5), kWindow).empty()) << "a crash has no frames";
}

TEST(Drift, RefusesOtherBodies) {
  Track other = at_rest(5);
  other.centres = MatrixXd::Zero(9, 5);
  EXPECT_THROW(drift(other, at_rest(5), kWindow), std::invalid_argument);
}

TEST(Mechanisms, AreLinksHeldTogetherByJoints) {
  const Model ring = make_scene("ring:wires=2").setup.system.model;
  const std::vector<Index> of = mechanisms(ring);
  EXPECT_EQ(of.front(), 0);
  EXPECT_EQ(of.back(), 1);
  for (Index i = 0; i < ring.size(); ++i) EXPECT_EQ(of[i], i < ring.size() / 2 ? 0 : 1);
  // A string hangs at the world by a joint and a loop: two strings are two mechanisms.
  const Model net = make_scene("net:strings=2,cylinders=1").setup.system.model;
  EXPECT_EQ(mechanisms(net).back(), 2);
}

Track tracked_squat(double disturbance = 0) {
  NamedScene named = make_scene("squat:points=8");
  named.setup.duration = 0.03;
  if (disturbance > 0) disturb_start(named, disturbance);
  const std::atomic<bool> never = false;
  return run_tracked(
      named, make_solver("best-first"), {}, [] {}, never);
}

std::vector<DriftLine> simulated(
    const std::vector<TrackedTask>& tasks,
    const std::function<void(const Progress&)>& progress = [](const Progress&) {}) {
  const std::atomic<bool> never = false;
  return DriftStudy{{}, kWindow, std::chrono::seconds(60), progress, never}.simulate(tasks);
}

TEST(Track, HoldsWhatTheRobotStandsOn) {
  const Track track = tracked_squat();
  ASSERT_EQ(track.frames(), 30);
  EXPECT_EQ(track.centres.rows(), 3 * 21);
  EXPECT_EQ(track.travel.rows(), 2);
  EXPECT_NEAR(track.weight, 6.711926 * 9.80665, 1e-6);
  const double force = (track.impulse(2, 29) - track.impulse(2, 9)) / 0.02;
  EXPECT_NEAR(force, track.weight, 0.05 * track.weight);
  EXPECT_GE(track.travel.minCoeff(), 0);
  EXPECT_GT(track.n, 0);
  EXPECT_GE((track.step_s - track.lcp_s).minCoeff(), 0);
  EXPECT_GT(track.step_s.sum(), 0);
}

TEST(Track, SurvivesItsWayOutOfAProcess) {
  NamedScene scene = make_scene("squat:points=8");
  scene.setup.duration = 0.03;
  std::size_t beats = 0;
  const std::vector<DriftLine> lines =
      simulated({{scene, "best-first", {}, "a"}}, [&](const Progress&) { ++beats; });
  const Track here = tracked_squat(), &there = lines.front().track;
  EXPECT_EQ(there.centres, here.centres);
  EXPECT_EQ(there.impulse, here.impulse);
  EXPECT_EQ(there.travel, here.travel);
  EXPECT_EQ(there.solver, here.solver);
  EXPECT_EQ(beats, 30u);
}

TEST(Track, ASmallDisturbanceStaysSmallWhereBodiesStand) {
  const Track here = tracked_squat(), again = tracked_squat(), disturbed = tracked_squat(1e-9);
  EXPECT_EQ(here.centres, again.centres);
  const Drift most = largest(drift(disturbed, here, kWindow), kForever);
  EXPECT_GT(most.distance, 0);
  EXPECT_LT(most.distance, 1e-8);
}

TEST(Track, ASimulationThatThrowsIsATrackWithoutFrames) {
  NamedScene scene = make_scene("squat:points=8"), refused = scene;
  scene.setup.duration = 0.01;
  refused.setup.system.mu = -1;  // by the simulation
  const Track track =
      simulated({{scene, "best-first", {}, "a"}, {refused, "best-first", {}, "b"}})[1].track;
  EXPECT_EQ(track.frames(), 0);
  EXPECT_NE(track.broken.find("mu is -1"), std::string::npos) << track.broken;
  EXPECT_THROW(simulated({{refused, "best-first", {}, "a"}}), std::runtime_error) << "a reference";
}

TEST(DriftStudy, ComparesWithTheFirstThatItEverMade) {
  NamedScene scene = make_scene("squat:points=8");
  scene.setup.duration = 0.01;
  const TrackedTask standing{scene, "best-first", {}, "a"};
  const std::function<void(const Progress&)> unseen = [](const Progress&) {};
  const std::atomic<bool> never = false;
  DriftStudy study{{}, kWindow, std::chrono::seconds(60), unseen, never};
  EXPECT_EQ(largest(study.simulate({standing})[0].drifts, kForever).distance, 0);
  EXPECT_GT(largest(study.simulate({disturbed(standing, 1e-9)})[0].drifts, kForever).distance, 0);
}

}  // namespace
}  // namespace lcp
