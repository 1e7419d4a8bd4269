// The robot's scenes from beginning to end, as results/ quotes them: minutes without optimisation,
// hence slow.

#include <gtest/gtest.h>

#include <numbers>

#include "harness/loop/summary.h"
#include "tests/harness/loop/soles.h"

namespace lcp {
namespace {

constexpr const char* papers_constants = "best-first:epsilon=1e-3,e_max=1e-3,polish=off,scale=off";
constexpr double degree = std::numbers::pi / 180;

LoopSummary simulate(const std::string& scene_text, const std::string& solver,
                     const Acceptance& acceptance, SoleWatch* soles = nullptr) {
  const NamedScene scene = make_scene(scene_text);
  const std::atomic<bool> interrupted = false;
  const LoopRun run = run_in_the_loop(
      scene, make_solver(solver), acceptance,
      [&](const Simulation&, const Frame& frame, const FrameRecord&) {
        if (soles) soles->look(frame);
      },
      interrupted);
  return summarise(run, scene.setup.system.model.mass(), scene.setup.system.gravity);
}

/// What must hold of the robot whatever it does.
void expect_sound(const LoopSummary& summary) {
  EXPECT_EQ(summary.broken, "");
  EXPECT_EQ(summary.failure, 0);
  EXPECT_EQ(summary.frictionless_failures, 0);
  EXPECT_LT(summary.tilt_max, 5 * degree);
  EXPECT_LT(summary.depth_max, 1e-3);
  EXPECT_LT(summary.force_mismatch, 0.02);
}

TEST(SquatInFull, BestFirstFailsInNoFrameAt1e6) {
  const LoopSummary summary = simulate("squat", "best-first", {});
  expect_sound(summary);
  EXPECT_GE(summary.total_frames, 990);
  EXPECT_LE(summary.residual_max, 1e-6);
  EXPECT_GE(summary.contacts, 12);
  EXPECT_LE(summary.contacts, 17);
  EXPECT_GE(summary.active, 1.5);
  EXPECT_LE(summary.active, 4);
  EXPECT_GE(0.300 - summary.height_min, 0.040);
  EXPECT_NEAR(summary.height_end, 0.300, 1e-3);
}

TEST(SquatInFull, ThePapersConstantsFailInNoFrameByItsCriterion) {
  expect_sound(simulate("squat", papers_constants, {Acceptance::Criterion::paper, 1e-3}));
}

TEST(SquatInFull, TheReducedFormFailsInNoFrameEither) {
  expect_sound(simulate("squat:reduction=paper", "best-first", {}));
}

TEST(TapDanceInFull, BestFirstFailsInNoFrameAt1e6) {
  SoleWatch soles;
  const LoopSummary summary = simulate("tap-dance", "best-first", {}, &soles);
  expect_sound(summary);
  EXPECT_LE(summary.residual_max, 1e-6);
  EXPECT_GE(summary.contacts, 5);
  EXPECT_LE(summary.contacts, 10);
  EXPECT_GE(summary.active, 1);
  EXPECT_LE(summary.active, 4);
  EXPECT_GE(std::abs(summary.turn), 45 * degree);
  EXPECT_GE(soles.strikes(0, 0.1, 5e-3), 10);
  EXPECT_GE(soles.strikes(1, 0.1, 5e-3), 10);
}

TEST(TapDanceInFull, ThePapersConstantsFailInNoFrameByItsCriterion) {
  SoleWatch soles;
  const LoopSummary summary =
      simulate("tap-dance", papers_constants, {Acceptance::Criterion::paper, 1e-3}, &soles);
  expect_sound(summary);
  EXPECT_GE(std::abs(summary.turn), 45 * degree);
  EXPECT_GE(soles.strikes(0, 0.1, 5e-3), 10);
  EXPECT_GE(soles.strikes(1, 0.1, 5e-3), 10);
}

}  // namespace
}  // namespace lcp
