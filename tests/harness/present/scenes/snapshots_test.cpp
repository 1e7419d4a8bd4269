#include "harness/present/scenes/snapshots.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/harness/studies/paper/pictured_run.h"

namespace lcp {
namespace {

TEST(Snapshots, RefuseTimesOutsideTheSimulation) {
  EXPECT_THROW(Snapshots({0.5, 1.001}, 1e-3, 1), std::invalid_argument);
  EXPECT_THROW(Snapshots({-0.1}, 1e-3, 1), std::invalid_argument);
  EXPECT_THROW(Snapshots({NAN}, 1e-3, 1), std::invalid_argument);
  try {
    Snapshots({2}, 1e-3, 1);
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "a picture at 2 s: the simulation goes from 0 to 1 s");
  }
}

TEST(Snapshots, TakeTheNearestFramesInOrderAndTheLastForTheEnd) {
  const PicturedRun squat = pictured("squat", 0.02, {0.02, 0, 0.0104, 0.01});
  ASSERT_EQ(squat.snapshots.size(), 3u);
  EXPECT_NEAR(squat.snapshots[0].time, 0, 1e-12);
  EXPECT_NEAR(squat.snapshots[1].time, 0.010, 1e-12);
  EXPECT_NEAR(squat.snapshots[2].time, 0.019, 1e-12);
}

TEST(Snapshots, HoldTheForcesThatTheFrameRecordSums) {
  const PicturedRun squat = pictured("squat", 0.03, {0.025});
  const FrameRecord& record = squat.run.frames[25];
  ASSERT_EQ(static_cast<Index>(squat.snapshots.front().touches.size()), record.contacts);
  Vector3d sum = Vector3d::Zero();
  for (const Snapshot::Touch& touch : squat.snapshots.front().touches) sum += touch.force;
  EXPECT_NEAR((sum - record.handle_forces[0] - record.handle_forces[1]).norm(), 0, 1e-9);
}

TEST(Snapshots, EvenlySpreadFromStartToEnd) {
  EXPECT_EQ(evenly_spread(2, 3), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(evenly_spread(2, 1), (std::vector<double>{0}));
}

}  // namespace
}  // namespace lcp
