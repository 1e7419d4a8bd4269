#include "harness/studies/paper/dance_figure.h"

#include <gtest/gtest.h>

namespace lcp {
namespace {

/// One foot, 1 ms a letter: `x` where it carries force.
LoopRun foot(const std::string& pattern) {
  LoopRun run;
  run.dt = 1e-3;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    FrameRecord frame;
    frame.time = 1e-3 * static_cast<double>(i);
    frame.yaw = 0.5 + 0.01 * static_cast<double>(i);
    frame.handle_forces = {{0, 0, pattern[i] == 'x' ? 5.0 : 0.0}};
    run.frames.push_back(frame);
  }
  return run;
}

TEST(DanceFigure, AFootStrikesWhenItCarriesForceAfterTenMillisecondsWithout) {
  const std::vector<Stance> all = stances(foot("xxx..xx..........xxx"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_FALSE(all[0].struck) << "it stands from the start";
  EXPECT_NEAR(all[0].end, 0.007, 1e-12);
  EXPECT_TRUE(all[1].struck);
  EXPECT_NEAR(all[1].begin, 0.017, 1e-12);
  EXPECT_NEAR(all[1].end, 0.020, 1e-12);
}

TEST(DanceFigure, SettlingInTheFirstMillisecondsIsNoStrike) {
  const std::vector<Stance> all = stances(foot("..x.x"));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_FALSE(all[0].struck);
}

TEST(DanceFigure, CsvHasTheTurnInDegreesAndTheStrikes) {
  const std::string csv = dance_csv(foot("x..........x"));
  EXPECT_TRUE(csv.starts_with("time_s,turn_deg,link_1_N,link_1_strikes\n0,0,5,0\n")) << csv;
  EXPECT_TRUE(csv.ends_with("0.011,6.30253575,5,1\n")) << csv;
}

}  // namespace
}  // namespace lcp
