#include "harness/runs/rows.h"
#include "harness/runs/run_directory.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "problems/io/errors.h"
#include "tests/harness/runs/small_plan.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

using nlohmann::json;

template <class Error>
std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "no complaint";
}

class RunDirectory : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return directory_.file(name); }
  void expect_refused(const RunPlan& plan, const std::string& why) {
    const std::string said =
        complaint<std::invalid_argument>([&] { run_small(at("r"), plan, Existing::resume); });
    EXPECT_NE(said.find(why), std::string::npos) << said;
  }

 private:
  const TemporaryDirectory directory_;
};

TEST_F(RunDirectory, ResumedAfterInterruptionsHoldsTheRowsOfAnUninterruptedRun) {
  run_small(at("whole"), small_plan());
  for (const std::size_t pairs : {1u, 4u, 3u, 7u})
    run_small(at("r"), small_plan(), Existing::resume, pairs);
  EXPECT_LT(read_run(at("r")).size(), 18u);
  const RunReport last = run_small(at("r"), small_plan(), Existing::resume);
  EXPECT_EQ(last.rows_before + last.rows, 18u);
  EXPECT_EQ(deterministic_rows(at("r")), deterministic_rows(at("whole")));
}

TEST_F(RunDirectory, ResumedWhenDoneRunsNothing) {
  run_small(at("r"), small_plan());
  const std::string rows = read_text(at("r/rows.jsonl")), settings = read_text(at("r/run.json"));
  EXPECT_EQ(run_small(at("r"), small_plan(), Existing::resume).rows, 0u);
  EXPECT_EQ(read_text(at("r/rows.jsonl")), rows);
  EXPECT_EQ(read_text(at("r/run.json")), settings);
}

TEST_F(RunDirectory, ResumedWithAnotherSolverRunsThatAlone) {
  run_small(at("r"), small_plan());
  RunPlan more = small_plan();
  more.solvers = make_solvers({"lemke", "lemke-revised"});
  EXPECT_EQ(run_small(at("r"), more, Existing::resume).rows, 6u);
  EXPECT_EQ(read_stored_run(at("r")).settings.solvers,
            (std::vector<std::string>{"lemke", "lexicographic", "best-first", "lemke-revised"}));
}

TEST_F(RunDirectory, KeepsInstancesOfEqualContentApart) {
  RunPlan plan = small_plan();
  plan.instances = {plan.instances[0], plan.instances[0]};
  plan.instances[1].name = "published/twin";
  run_small(at("r"), plan, Existing::refuse, 1);
  run_small(at("r"), plan, Existing::resume);
  EXPECT_EQ(read_run(at("r")).size(), 6u);
}

TEST_F(RunDirectory, TheTimeStandsOnlyWhereOneSessionDidAll) {
  run_small(at("r"), small_plan());
  EXPECT_GT(read_run_header(at("r")).settings.seconds.value(), 0);
  run_small(at("s"), small_plan(), Existing::refuse, 2);
  run_small(at("s"), small_plan(), Existing::resume);
  EXPECT_FALSE(read_run_header(at("s")).settings.seconds);
}

TEST_F(RunDirectory, IsNotResumedAsSomethingElse) {
  run_small(at("r"), small_plan(), Existing::refuse, 2);
  RunPlan plan = small_plan();
  plan.tolerance = 1e-9;
  expect_refused(plan, "tolerance 1e-06, 1e-09");
  plan = small_plan();
  plan.starts = {StartKind::two_step};
  expect_refused(plan, "start cold, two-step");
  plan = small_plan();
  plan.shard = {1, 2};
  expect_refused(plan, "holds shard 1/1, this is 2/2");
  json environment = json::parse(read_text(at("r/env.json")));
  environment["commit"] = "0123456";
  write_text(at("r/env.json"), environment.dump());
  expect_refused(small_plan(), "was begun by commit 0123456");
}

TEST_F(RunDirectory, InTwoStepsIsResumedAsSuchAndHoldsTheSameRows) {
  RunPlan plan = small_plan();
  plan.instances = generate("squat-like", {.count = 2});
  plan.starts = {StartKind::two_step};
  run_small(at("whole"), plan);
  run_small(at("r"), plan, Existing::refuse, 2);
  const RunReport last = run_small(at("r"), plan, Existing::resume);
  EXPECT_EQ(last.rows_before + last.rows, 6u);
  EXPECT_EQ(deterministic_rows(at("r")), deterministic_rows(at("whole")));
  EXPECT_EQ(read_run_header(at("r")).settings.start, "two-step");
  plan.starts = {StartKind::cold};
  expect_refused(plan, "start two-step, cold");
}

TEST_F(RunDirectory, InAnotherEnvironmentItKeepsBoth) {
  run_small(at("r"), small_plan(), Existing::refuse, 2);
  RunPlan plan = small_plan();
  plan.jobs = 2;
  run_small(at("r"), plan, Existing::resume);
  const StoredRun run = read_stored_run(at("r"));
  ASSERT_EQ(run.environments.size(), 2u);
  EXPECT_EQ(run.environments[0].at("jobs"), 1);
  EXPECT_EQ(run.environments[1].at("jobs"), 2);
  EXPECT_EQ(run.rows.back().environment, run.environments[1].at("id"));
}

TEST_F(RunDirectory, BeginsWhereAKilledRunLeftNothingButItsEnvironment) {
  std::filesystem::create_directory(at("r"));
  write_text(at("r/env.json"), "{\"half\": ");
  write_text(at("r/run.json.17.tmp"), "{");
  EXPECT_EQ(run_small(at("r"), small_plan(), Existing::resume).rows, 18u);
}

TEST_F(RunDirectory, RemovesWhatAKilledWriterLeftBesideAFile) {
  run_small(at("r"), small_plan(), Existing::refuse, 2);
  write_text(at("r/table.json.17.tmp"), "{");
  run_small(at("r"), small_plan(), Existing::resume);
  EXPECT_FALSE(std::filesystem::exists(at("r/table.json.17.tmp")));
}

TEST_F(RunDirectory, RowsWithoutSettingsAreNotResumed) {
  std::filesystem::create_directory(at("r"));
  write_text(at("r/rows.jsonl"), "");
  expect_refused(small_plan(), "no run.json");
}

TEST_F(RunDirectory, DamagedFilesAreNamed) {
  run_small(at("r"), small_plan(), Existing::refuse, 2);
  for (const char* name : {"run.json", "env.json", "rows.jsonl"}) {
    const std::string whole = read_text(at("r/") + name);
    write_text(at("r/") + name, "{}\n");
    const std::string said =
        complaint<UnreadableInput>([&] { run_small(at("r"), small_plan(), Existing::resume); });
    EXPECT_NE(said.find(name), std::string::npos) << said;
    write_text(at("r/") + name, whole);
  }
}

TEST_F(RunDirectory, IsWrittenByOneProcessAtATime) {
  run_small(at("r"), small_plan(), Existing::refuse, 2);
  const RecordWriter other(at("r"));
  const pid_t child = fork();
  if (child == 0) {
    const std::string said =
        complaint<UnwritableOutput>([&] { run_small(at("r"), small_plan(), Existing::resume); });
    _exit(said.find("another process is writing it") != std::string::npos ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST_F(RunDirectory, ShardsShareOutTheInstances) {
  std::size_t rows = 0;
  for (Index k = 0; k < 4; ++k) {
    RunPlan plan = small_plan();
    plan.shard = {k, 4};
    const std::string directory = at(fmt::format("r{}", k));
    rows += run_small(directory, plan).rows;
    for (const Record& row : read_run(directory)) EXPECT_EQ(row.place % 4, k);
  }
  EXPECT_EQ(rows, 18u);
}

}  // namespace
}  // namespace lcp
