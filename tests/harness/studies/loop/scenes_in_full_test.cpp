// Scenes from beginning to end, as results/ quotes them, the chains as far as minutes allow: without
// optimisation much longer, hence slow.

#include <gtest/gtest.h>

#include <numbers>

#include "harness/studies/loop/summary.h"
#include "tests/harness/studies/loop/soles.h"

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

/// What must hold of chains: no frame failed, energy from nowhere, or bodies one in another by more
/// than a tenth of the thinner (m); loops closed to 1e-4 of a link (m).
void expect_sound_chain(const LoopSummary& summary, double thinner, double link) {
  EXPECT_EQ(summary.broken, "");
  EXPECT_EQ(summary.failure, 0);
  EXPECT_EQ(summary.both_failures, 0);
  EXPECT_LE(summary.energy_excess, 0.01);
  EXPECT_LT(summary.depth_max, thinner / 10);
  EXPECT_LT(summary.gap_end, 1e-4 * link);
}

LoopSummary simulate_for(const std::string& scene_text, double duration, const std::string& solver,
                         const Acceptance& acceptance) {
  NamedScene scene = make_scene(scene_text);
  scene.setup.duration = duration;
  const std::atomic<bool> interrupted = false;
  return summarise(run_in_the_loop(scene, make_solver(solver), acceptance, {}, interrupted),
                   scene.setup.system.model.mass(), scene.setup.system.gravity);
}

TEST(Hoist, IsSoundWithThePapersConstants) {
  const LoopSummary summary =
      simulate_for("hoist", 2, papers_constants, {Acceptance::Criterion::paper, 1e-3});
  expect_sound_chain(summary, 0.04, 0.1);
  EXPECT_LT(summary.force_mismatch, 0.02);
}

TEST(Hoist, At10msIsSoundToItsEndButForDepth) {
  const LoopSummary summary = simulate("hoist:dt=0.01", "best-first", {});
  expect_sound_chain(summary, 1, 0.1);
  EXPECT_GT(summary.work, 0.3) << "it is pulled";
  EXPECT_GE(summary.contacts, 35);
  EXPECT_LE(summary.contacts, 65);
  EXPECT_GE(summary.active, 15);
  EXPECT_LE(summary.active, 31);
}

TEST(Ring, IsSoundAt1e6) {
  const LoopSummary summary = simulate_for("ring", 1, "best-first", {});
  expect_sound_chain(summary, 0.01, 0.04);
  EXPECT_GE(summary.contacts, 18);
  EXPECT_LE(summary.contacts, 35);
  EXPECT_GE(summary.active, 15);
  EXPECT_LE(summary.active, 30);
}

TEST(Net, IsSoundAt1e6ToItsEnd) {
  const LoopSummary summary = simulate("net", "best-first", {});
  expect_sound_chain(summary, 0.016, 0.06);
  EXPECT_GE(summary.contacts, 18);
  EXPECT_LE(summary.contacts, 35);
  EXPECT_GE(summary.active, 11);
  EXPECT_LE(summary.active, 23);
  EXPECT_GT(summary.gap_max, 0) << "nothing is exact";
}

}  // namespace
}  // namespace lcp
