#include "harness/studies/loop/in_the_loop.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "harness/studies/loop/summary.h"
#include "problems/contact/islands.h"

namespace lcp {
namespace {

constexpr double kShort = 0.02;  // s: some frames in the air, then contact

LoopRun short_squat(const std::string& solver, const Acceptance& acceptance = {},
                    const FrameLook& look = {}) {
  NamedScene scene = make_scene("squat:points=8");
  scene.setup.duration = kShort;
  const std::atomic<bool> interrupted = false;
  return run_in_the_loop(scene, make_solver(solver), acceptance, look, interrupted);
}

LoopSummary summary_of(const LoopRun& run) { return summarise(run, 6.711926, {0, 0, -9.80665}); }

TEST(InTheLoop, RecordsEveryFrame) {
  const LoopRun run = short_squat("best-first");
  ASSERT_EQ(run.frames.size(), 20u);
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    EXPECT_EQ(run.frames[i].frame, static_cast<Index>(i));
    EXPECT_NEAR(run.frames[i].time, 1e-3 * static_cast<double>(i), 1e-12);
  }
  const FrameRecord& last = run.frames.back();
  EXPECT_EQ(last.contacts, 8);
  EXPECT_EQ(last.n, 8 * 10);
  EXPECT_EQ(last.frictional, Verdict::solved);
  EXPECT_EQ(last.applied, Applied::frictional);
  EXPECT_LE(last.accuracy.residual, 1e-6);
  EXPECT_EQ(last.violated, 0);
  EXPECT_GT(last.work.nodes, 0);
  EXPECT_GT(last.step_ns, last.frictional_ns + last.frictionless_ns);
}

TEST(InTheLoop, SameSolverSameMotion) {
  const LoopRun a = short_squat("best-first"), b = short_squat("best-first");
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    EXPECT_EQ(a.frames[i].centre_of_mass, b.frames[i].centre_of_mass);
    EXPECT_EQ(a.frames[i].work.pivots, b.frames[i].work.pivots);
  }
}

TEST(InTheLoop, AnAnswerThatIsNotAcceptedLetsTheFrictionlessOneAct) {
  // No answer of a sensible search passes a tolerance of 1e-300 with friction, nor without.
  const LoopRun run = short_squat("best-first", {Acceptance::Criterion::residual, 1e-300});
  const LoopSummary summary = summary_of(run);
  EXPECT_GT(summary.failure, 0);
  EXPECT_EQ(summary.failure, summary.error);
  for (const FrameRecord& frame : run.frames) {
    if (frame.contacts == 0 || frame.frictional == Verdict::solved) continue;
    EXPECT_NE(frame.applied, Applied::frictional);
    EXPECT_EQ(frame.applied == Applied::none, frame.frictionless != Verdict::solved);
  }
}

TEST(InTheLoop, ThePapersCriterionLooksAtTheSolversOwnW) {
  const Acceptance paper{Acceptance::Criterion::paper, 1e-3};
  const LoopRun run = short_squat("best-first:epsilon=1e-3,e_max=1e-3,polish=off,scale=off", paper);
  const LoopSummary summary = summary_of(run);
  EXPECT_EQ(summary.failure, 0);
  EXPECT_GT(summary.residual_max, 1e-6) << "the judge would have refused it";
  for (const FrameRecord& frame : run.frames)
    if (frame.contacts > 0) {
      EXPECT_LE(frame.accuracy.paper_error, 1e-3);
    }
}

TEST(InTheLoop, AMethodWithoutABasisStartsCold) {
  const LoopRun run = short_squat("projected-gauss-seidel");
  const LoopSummary summary = summary_of(run);
  EXPECT_EQ(summary.restarts, summary.total_frames);
  EXPECT_GT(summary.success, 0);
}

TEST(InTheLoop, ContactsThatDoNotInfluenceOneAnotherAreSolvedApart) {
  NamedScene scene = make_scene("net:strings=8,cylinders=8");
  scene.setup.duration = 0.06;
  scene.setup.stepping.dt = 0.002;
  const std::atomic<bool> never = false;
  std::size_t most = 0;
  const auto frames_with = [&](const NamedSolver& solver) {
    return run_in_the_loop(
        scene, solver, {},
        [&](const Simulation&, const Frame& frame, const FrameRecord& record) {
          if (record.contacts == 0) return;
          most = std::max(most, split_islands(frame.solution.frictional).size());
          EXPECT_EQ(record.frictional, Verdict::solved);
          EXPECT_LE(record.accuracy.residual, 1e-6);
        },
        never);
  };
  const NamedSolver solver = make_solver("best-first");
  EXPECT_EQ(frames_with(solver).frames.size(), 30u);
  EXPECT_GT(most, 1u) << "nothing is tested without islands";
  // Asked for each island apart: no problem that the solver sees has islands.
  const auto watched = std::make_shared<Solver>(*solver.solver);
  watched->run = [inner = solver.solver](const Problem& problem, const Call& call) {
    EXPECT_FALSE(has_islands(problem));
    return inner->solve(problem, call);
  };
  frames_with({solver.spelling, solver.info, watched});
}

TEST(InTheLoop, StopsWhenInterrupted) {
  NamedScene scene = make_scene("squat");
  std::atomic<bool> interrupted = false;
  const LoopRun run = run_in_the_loop(
      scene, make_solver("best-first"), {},
      [&](const Simulation&, const Frame& frame, const FrameRecord&) {
        if (frame.number == 4) interrupted = true;
      },
      interrupted);
  EXPECT_EQ(run.frames.size(), 5u);
  EXPECT_EQ(run.broken, "interrupted");
  EXPECT_TRUE(run.stopped);
}

TEST(InTheLoop, StopsAtItsLimitOfTimeWithTheFramesThatItDid) {
  NamedScene scene = make_scene("squat:points=8");
  const std::atomic<bool> never = false;
  const LoopRun run = run_in_the_loop(
      scene, make_solver("best-first"), {},
      [&](const Simulation&, const Frame& frame, const FrameRecord&) {
        if (frame.number == 2) std::this_thread::sleep_for(std::chrono::milliseconds(300));
      },
      never, 0.3);
  ASSERT_LE(run.frames.size(), 3u);
  EXPECT_TRUE(run.stopped);
  EXPECT_EQ(run.broken, fmt::format("stopped after 0.3 s of computing at t = {:g} s",
                                    1e-3 * static_cast<double>(run.frames.size())));
  EXPECT_TRUE(summary_of(run).stopped);
  EXPECT_FALSE(short_squat("best-first").stopped);
}

TEST(LoopSummary, CountsAddUp) {
  const LoopSummary summary =
      summary_of(short_squat("lemke", {Acceptance::Criterion::paper, 1e-3}));
  EXPECT_EQ(summary.steps, 20);
  EXPECT_EQ(summary.success + summary.failure + summary.unsupported, summary.total_frames);
  EXPECT_EQ(summary.no_solution + summary.cycle + summary.error, summary.failure);
  EXPECT_LE(summary.both_failures, summary.frictionless_failures);
}

TEST(LoopSummary, ForcesMatchWeightPlusMassTimesAcceleration) {
  NamedScene scene = make_scene("squat:points=8");
  scene.setup.duration = 0.1;
  const std::atomic<bool> interrupted = false;
  LoopRun run = run_in_the_loop(scene, make_solver("best-first"), {}, {}, interrupted);
  EXPECT_LT(summary_of(run).force_mismatch, 1e-3);
  for (FrameRecord& frame : run.frames) frame.handle_forces.front().z() *= 1.1;
  EXPECT_GT(summary_of(run).force_mismatch, 0.02) << "the check must be able to fail";
}

TEST(LoopSummary, SurvivesJson) {
  const LoopSummary written = summary_of(short_squat("lemke"));
  const LoopSummary read = nlohmann::json::parse(nlohmann::json(written).dump()).get<LoopSummary>();
  // As text: NaN, such as the energy of a driven robot, equals no NaN.
  EXPECT_EQ(nlohmann::json(read).dump(), nlohmann::json(written).dump());
  nlohmann::json damaged = written;
  damaged.erase("failure");
  EXPECT_THROW(damaged.get<LoopSummary>(), std::invalid_argument);
}

TEST(LoopSummary, CsvHasALineForEveryFrame) {
  const LoopRun run = short_squat("best-first");
  const std::string csv = frames_csv(run);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 21);
  const auto columns = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  std::size_t begin = 0;
  const auto header = columns(csv.substr(0, csv.find('\n')));
  while (begin < csv.size()) {
    const std::size_t end = csv.find('\n', begin);
    EXPECT_EQ(columns(csv.substr(begin, end - begin)), header);
    begin = end + 1;
  }
}

}  // namespace
}  // namespace lcp
