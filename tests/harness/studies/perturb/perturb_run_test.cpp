// Disturbed runs in a run directory.

#include <gtest/gtest.h>

#include "harness/studies/perturb/perturb_flips.h"
#include "tests/harness/runs/small_plan.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

PerturbOptions few() {
  PerturbOptions options;
  options.kinds = {DisturbanceKind::noise, DisturbanceKind::units};
  options.trials = 1;
  return options;
}

RunPlan disturbed_plan() {
  RunPlan plan = small_plan();
  plan.instances.resize(3);
  plan.solvers = make_solvers({"lemke", "best-first"});
  plan.keep_answers = true;
  return plan;
}

/// Gives up after `pairs` pairs, unless that is 0. Returns the last progress too.
std::pair<RunReport, Progress> run_disturbed(const std::string& directory, const RunPlan& plan,
                                             Existing existing, std::size_t pairs = 0) {
  std::atomic<bool> interrupted = false;
  Progress last;
  const RunReport report = run_into(
      directory, plan, expansion(few()), {"small", {}}, existing, [](const std::string&) {},
      [&](const Progress& progress) {
        last = progress;
        interrupted = pairs > 0 && progress.done >= pairs;
      },
      interrupted);
  return {report, last};
}

TEST(DisturbedRun, HoldsEachInstanceAndItsDisturbedVersionsInOrder) {
  const TemporaryDirectory directory;
  const std::string out = directory.file("run");
  const auto [report, last] = run_disturbed(out, disturbed_plan(), Existing::refuse);
  EXPECT_EQ(report.rows, 18u);
  EXPECT_EQ(last.done, 18u);
  EXPECT_EQ(last.total, 18u);
  const std::vector<Record> rows = read_run(out);
  ASSERT_EQ(rows.size(), 18u);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].place, static_cast<Index>(k / 2));
    EXPECT_EQ(rows[k].z.has_value(), rows[k].verdict == Verdict::solved) << rows[k].instance;
  }
  EXPECT_EQ(rows[2].instance, rows[0].instance + "~noise-1");
  EXPECT_EQ(rows[4].instance, rows[0].instance + "~units-mm");
  EXPECT_EQ(read_run_header(out).settings.instances, 9);
}

TEST(DisturbedRun, GoesOnAfterAnInterruptionAsIfThereHadBeenNone) {
  const TemporaryDirectory directory;
  run_disturbed(directory.file("whole"), disturbed_plan(), Existing::refuse);
  run_disturbed(directory.file("run"), disturbed_plan(), Existing::refuse, 7);
  EXPECT_LT(read_run(directory.file("run")).size(), 18u);
  const auto [report, last] =
      run_disturbed(directory.file("run"), disturbed_plan(), Existing::resume);
  EXPECT_EQ(report.rows_before + report.rows, 18u);
  EXPECT_EQ(last.done, report.rows);
  EXPECT_EQ(last.total, report.rows);
  EXPECT_EQ(deterministic_rows(directory.file("run")), deterministic_rows(directory.file("whole")));
  EXPECT_EQ(run_disturbed(directory.file("whole"), disturbed_plan(), Existing::resume).first.rows,
            0u);
  EXPECT_TRUE(read_run_header(directory.file("whole")).settings.seconds.has_value());
}

TEST(DisturbedRun, IsSharedOutByInstanceWithAllThatComesOfIt) {
  const TemporaryDirectory directory;
  RunPlan plan = disturbed_plan();
  plan.shard = {1, 2};
  run_disturbed(directory.file("second"), plan, Existing::refuse);
  const std::vector<Record> rows = read_run(directory.file("second"));
  ASSERT_EQ(rows.size(), 6u);
  for (const Record& row : rows)
    EXPECT_EQ(row.instance.rfind(plan.instances[1].name, 0), 0u) << row.instance;
  EXPECT_EQ(rows.front().place, 3);
}

TEST(DisturbedRun, KeepsNoAnswersUnlessAsked) {
  const TemporaryDirectory directory;
  RunPlan plan = disturbed_plan();
  plan.keep_answers = false;
  run_disturbed(directory.file("run"), plan, Existing::refuse);
  for (const Record& row : read_run(directory.file("run"))) EXPECT_FALSE(row.z.has_value());
}

}  // namespace
}  // namespace lcp
