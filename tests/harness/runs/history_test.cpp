#include "harness/runs/history.h"

#include <gtest/gtest.h>

#include "tests/harness/runs/small_plan.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

TEST(PastRuns, AreTheWholeOnesMostRecentFirst) {
  const TemporaryDirectory directory;
  run_small(directory.file("first"), small_plan());
  run_small(directory.file("broken-off"), small_plan(), Existing::refuse, 2);
  run_small(directory.file("second"), small_plan());
  write_text(directory.file("notes.txt"), "no run");
  const std::vector<PastRun> found = past_runs({directory.path(), directory.file("nowhere")});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].directory.filename(), "second");
  EXPECT_EQ(found[1].directory.filename(), "first");
  EXPECT_EQ(found[0].jobs, 1);
  EXPECT_FALSE(found[0].cpu.empty());
}

TEST(Forecast, OfTheSameRunIsTheTimeItTook) {
  const TemporaryDirectory directory;
  run_small(directory.file("r"), small_plan());
  const std::vector<PastRun> past = past_runs({directory.path()});
  const Forecast whole = forecast(small_plan(), past);
  EXPECT_EQ(whole.known, 18u);
  EXPECT_EQ(whole.unknown, 0u);
  EXPECT_NEAR(whole.seconds, *past[0].settings.seconds, 1e-6);
}

TEST(Forecast, TellsHowLongUnknownPairsMayTakeAtMost) {
  const TemporaryDirectory directory;
  run_small(directory.file("r"), small_plan());
  RunPlan plan = small_plan();
  plan.solvers = make_solvers({"lemke", "lemke-revised"});
  const Forecast found = forecast(plan, past_runs({directory.path()}));
  EXPECT_EQ(found.known, 6u);
  EXPECT_EQ(found.unknown, 6u);
  EXPECT_DOUBLE_EQ(found.most_seconds, 6 * 60.0);
  EXPECT_EQ(forecast(plan, {}).known, 0u);
}

}  // namespace
}  // namespace lcp
