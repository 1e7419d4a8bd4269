#include "harness/measure/runner.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "problems/registry.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

using namespace std::chrono_literals;

/// LCP(I, q) with q = (-1, 2), solved by z = (1, 0).
Instance identity_instance(const std::string& name) {
  Problem problem;
  problem.M = MatrixXd::Identity(2, 2);
  problem.q = VectorXd{{-1, 2}};
  set_plain_scales(problem);
  return make_instance(name, problem, {});
}

RunPlan plan_of(const std::vector<std::string>& solvers, int instances = 1) {
  RunPlan plan;
  for (int i = 0; i < instances; ++i)
    plan.instances.push_back(identity_instance("identity/" + std::to_string(i)));
  plan.solvers = make_solvers(solvers);
  plan.timeout = 60s;
  plan.max_samples = 3;
  plan.environment = "here";
  return plan;
}

std::vector<Record> records_of(const RunPlan& plan) {
  std::vector<Record> records;
  run(
      plan, [&](const Record& record) { records.push_back(record); }, [](const Progress&) {},
      false);
  return records;
}

Record record_of(const std::string& solver) { return records_of(plan_of({solver})).at(0); }

std::size_t open_files() {
  const std::filesystem::directory_iterator files("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

/// Fails when the body it lives through has left a child process or an open file behind.
class LeavesNothingBehind {
 public:
  ~LeavesNothingBehind() {
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
    EXPECT_EQ(open_files(), files_before_);
  }

 private:
  std::size_t files_before_ = open_files();
};

TEST(NullControl, LiarIsWrong) {
  const Record record = record_of("liar");
  EXPECT_EQ(record.verdict, Verdict::wrong);
  EXPECT_EQ(record.claim, Claim::solved);
  EXPECT_EQ(record.accuracy.value().min_z, -1);
}

TEST(NullControl, MakerOfNanIsWrong) {
  const Record record = record_of("nan-maker");
  EXPECT_EQ(record.verdict, Verdict::wrong);
  EXPECT_EQ(record.accuracy.value().residual, std::numeric_limits<double>::infinity());
}

TEST(NullControl, SleeperTimesOut) {
  RunPlan plan = plan_of({"sleeper"});
  plan.timeout = 300ms;
  const Record record = records_of(plan).at(0);
  EXPECT_EQ(record.verdict, Verdict::timeout);
  EXPECT_EQ(record.exit_signal, SIGKILL);
  EXPECT_FALSE(record.accuracy);
  ASSERT_EQ(record.times_ns.size(), 1u);
  EXPECT_GE(record.times_ns[0], plan.timeout.count());
}

TEST(NullControl, CrasherIsACrashWithTheEndOfWhatItPrinted) {
  const Record record = record_of("crasher");
  EXPECT_EQ(record.verdict, Verdict::crash);
  EXPECT_EQ(record.exit_signal, SIGABRT);
  EXPECT_EQ(record.stderr_end, std::string(390, '.') + "last words");
}

TEST(NullControl, ThrowerIsACrashWithItsText) {
  const Record record = record_of("thrower");
  EXPECT_EQ(record.verdict, Verdict::crash);
  EXPECT_EQ(record.message, "thrown on purpose");
  EXPECT_EQ(record.exit_signal, 0);
}

TEST(NullControl, MemoryEaterIsStoppedAtTheLimit) {
  RunPlan plan = plan_of({"memory-eater"});
  plan.memory_bytes = 64 << 20;
  const Record record = records_of(plan).at(0);
  EXPECT_EQ(record.verdict, Verdict::memory);
  EXPECT_EQ(record.exit_signal, SIGKILL);
  EXPECT_FALSE(record.accuracy);
}

TEST(NullControl, FlipperIsWrongAlthoughBothAnswersPass) {
  const Record record = record_of("flipper");
  EXPECT_EQ(record.verdict, Verdict::wrong);
  EXPECT_LT(record.accuracy.value().residual, 1e-12);
  EXPECT_EQ(record.message, "repetition 1 gave another answer than the first run");
  EXPECT_EQ(record.times_ns.size(), 1u);
}

TEST(Run, GoesOnAfterEveryFailureAndRunsWhatGivesNoAnswerOnce) {
  const LeavesNothingBehind guard;
  RunPlan plan =
      plan_of({"liar", "lemke", "sleeper", "crasher", "nan-maker", "flipper", "thrower"}, 2);
  plan.timeout = 1s;
  const std::vector<Record> records = records_of(plan);
  const std::vector<Verdict> expected = {Verdict::wrong, Verdict::solved, Verdict::timeout,
                                         Verdict::crash, Verdict::wrong,  Verdict::wrong,
                                         Verdict::crash};
  ASSERT_EQ(records.size(), 14u);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].instance, plan.instances[i / 7].name);
    EXPECT_EQ(records[i].solver, plan.solvers[i % 7].spelling);
    EXPECT_EQ(records[i].verdict, expected[i % 7]) << records[i].solver;
    const bool answers = i % 7 < 2;  // The liar's answer may be judged again by another criterion.
    EXPECT_EQ(records[i].times_ns.size(), answers ? 3u : 1u) << records[i].solver;
  }
}

TEST(Run, FillsTheRecordOfASolvedPair) {
  const RunPlan plan = plan_of({"lemke"});
  const Record record = records_of(plan).at(0);
  EXPECT_EQ(record.instance, "identity/0");
  EXPECT_EQ(record.corpus, "identity");
  EXPECT_EQ(record.sha256, plan.instances[0].sha256);
  EXPECT_EQ(record.n, 2);
  EXPECT_EQ(record.contacts, 0);
  EXPECT_EQ(record.solver, "lemke");
  EXPECT_EQ(record.row, "lemke");
  EXPECT_EQ(record.version, plan.solvers[0].info.version);
  EXPECT_EQ(record.options.at("pivot"), "0");
  EXPECT_EQ(record.claim, Claim::solved);
  EXPECT_EQ(record.verdict, Verdict::solved);
  EXPECT_EQ(record.accuracy.value().residual, 0);
  EXPECT_GT(record.work.pivots, 0);
  EXPECT_EQ(record.environment, "here");
  EXPECT_FALSE(record.trivial);
}

TEST(Run, RepeatsUntilTheSpreadIsSmallOrThereAreEnoughSamples) {
  RunPlan plan = plan_of({"lemke"});
  plan.max_samples = 9;
  plan.spread = std::numeric_limits<double>::infinity();
  EXPECT_EQ(records_of(plan).at(0).times_ns.size(), 3u);
  plan.max_samples = 2;
  EXPECT_EQ(records_of(plan).at(0).times_ns.size(), 2u);
  plan.max_samples = 1;
  EXPECT_EQ(records_of(plan).at(0).times_ns.size(), 1u);
}

TEST(Run, GivesEverySolverOneTurnBeforeAnyHasTheNext) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("calls");
  write_text(file, "");
  const auto scribe = [&](const std::string& label) {
    return "scribe:label=" + label + ",file=" + file;
  };
  RunPlan plan = plan_of({scribe("a"), "liar", scribe("b"), scribe("c")});
  plan.warm_up_below = 1h;
  records_of(plan);
  EXPECT_EQ(read_text(file), "abcaabbccaabbccaabbcc")
      << "a warm-up, then three samples, each right after one that is not timed";
}

TEST(Run, LeavesOutInstancesWithTooManyContacts) {
  RunPlan plan = plan_of({"lemke", "liar"}, 2);
  FrictionBlocks blocks;
  blocks.W = MatrixXd::Identity(6, 6);
  blocks.vbar = VectorXd::Zero(6);
  blocks.mu = VectorXd::Zero(2);
  blocks.directions.resize(2, 0);
  blocks.normal_row = {0, 1};
  blocks.friction_row = blocks.cone_row = {-1, -1};
  plan.instances[0].problem.friction = blocks;
  plan.max_contacts = 1;
  const std::vector<Record> records = records_of(plan);
  ASSERT_EQ(records.size(), 4u);
  for (const std::size_t i : {0, 1}) {
    EXPECT_EQ(records[i].verdict, Verdict::not_run);
    EXPECT_EQ(records[i].contacts, 2);
    EXPECT_TRUE(records[i].times_ns.empty());
    EXPECT_EQ(records[i].message, "2 contacts, more than 1");
  }
  EXPECT_EQ(records[2].verdict, Verdict::solved);
  plan.max_contacts = 2;
  EXPECT_EQ(records_of(plan).at(0).verdict, Verdict::solved);
}

TEST(Run, MarksTrivialInstancesInEveryRow) {
  RunPlan plan = plan_of({"lemke", "crasher"});
  plan.instances[0].problem.q = VectorXd{{1, 2}};
  for (const Record& record : records_of(plan)) EXPECT_TRUE(record.trivial) << record.solver;
}

TEST(Run, ReportsProgressUpToTheLastPair) {
  std::vector<std::size_t> done;
  const RunPlan plan = plan_of({"lemke", "liar"}, 2);
  run(
      plan, [](const Record&) {},
      [&](const Progress& progress) {
        EXPECT_EQ(progress.total, 4u);
        EXPECT_FALSE(progress.at.empty());
        done.push_back(progress.done);
      },
      false);
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_EQ(done.front(), 0u);
  EXPECT_EQ(done.back(), 4u);
}

TEST(Run, GivesTheSameRowsWithTwoJobsAsWithOne) {
  RunPlan plan = plan_of({"lemke", "liar", "crasher", "flipper", "thrower"}, 4);
  const auto deterministic = [&plan] {
    std::map<std::string, nlohmann::json> rows;
    for (const Record& record : records_of(plan)) {
      nlohmann::json row = record;
      for (const char* measured : {"times_ns", "median_ns", "jobs"}) row.erase(measured);
      rows[record.instance + " " + record.solver] = row;
      EXPECT_EQ(record.jobs, plan.jobs);
    }
    return rows;
  };
  const LeavesNothingBehind guard;
  const auto alone = deterministic();
  plan.jobs = 2;
  EXPECT_EQ(alone.size(), 20u);
  EXPECT_EQ(deterministic(), alone);
}

TEST(Run, InterruptedKeepsWhatIsFinishedAndLeavesNoChild) {
  const LeavesNothingBehind guard;
  RunPlan plan = plan_of({"sleeper", "liar"}, 3);
  plan.jobs = 2;
  plan.timeout = 300ms;
  std::atomic<bool> interrupted = false;
  std::set<std::string> instances;
  std::size_t records = 0;
  run(
      plan,
      [&](const Record& record) {
        instances.insert(record.instance);
        ++records;
      },
      [&](const Progress& progress) {
        if (progress.done >= 2) interrupted = true;
      },
      interrupted);
  EXPECT_GE(records, 2u);
  EXPECT_FALSE(instances.contains(plan.instances[2].name)) << "the third was not begun";
}

TEST(Run, InTwoStepsJudgesTheFrictionalLcpAndSaysSoInEveryRow) {
  RunPlan plan = plan_of({"best-first", "projected-gauss-seidel"});
  plan.instances = generate("squat-like", {.count = 4});
  plan.instances.push_back(identity_instance("identity/0"));
  plan.starts = {StartKind::two_step};
  const std::vector<Record> records = records_of(plan);
  ASSERT_EQ(records.size(), 10u);
  for (const Record& record : records) {
    EXPECT_EQ(record.start, "two-step");
    if (record.contacts == 0) {
      EXPECT_EQ(record.verdict, Verdict::unsupported);
      EXPECT_EQ(record.message, "two-step: the instance has no friction");
    } else if (record.row == "best-first") {
      EXPECT_EQ(record.verdict, Verdict::solved) << record.message;
      EXPECT_LT(record.accuracy.value().residual, 1e-9);
      EXPECT_EQ(record.work.start_pivots, record.active_contacts);
      EXPECT_GT(record.work.frictionless_pivots, 0);
      EXPECT_EQ(record.times_ns.size(), 3u) << "equal bits in every repetition";
    } else {
      EXPECT_EQ(record.verdict, Verdict::solved) << record.message;
      EXPECT_EQ(record.work.frictionless_pivots, 0);
    }
  }
}

TEST(Run, APairDoneColdIsNotDoneInTwoSteps) {
  RunPlan plan = plan_of({"lemke"});
  plan.done = {{"identity/0", plan.instances[0].sha256, "lemke", "cold"}};
  EXPECT_TRUE(open_pairs(plan).empty());
  plan.starts = {StartKind::two_step};
  EXPECT_EQ(open_pairs(plan).at(0).start, "two-step");
}

TEST(Run, FromSeveralStartsHasARowOfEachInTheirOrder) {
  RunPlan plan = plan_of({"best-first", "projected-gauss-seidel"});
  plan.instances = generate("squat-like", {.count = 2});
  plan.starts = {StartKind::cold, StartKind::two_step, StartKind::previous};
  const std::vector<Record> records = records_of(plan);
  ASSERT_EQ(records.size(), 12u);
  const std::vector<PairKey> pairs = open_pairs(plan);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(key_of(records[i]), pairs[i]);
    EXPECT_EQ(records[i].start, to_string(plan.starts[i % 3]));
    EXPECT_EQ(records[i].verdict, Verdict::solved) << records[i].message;
  }
  EXPECT_EQ(records[2].message, "no previous solution; started cold");
  EXPECT_EQ(records[2].sha256, plan.instances[0].sha256);
  EXPECT_EQ(records[6].sha256, plan.instances[1].sha256) << "cold";
  EXPECT_EQ(records[8].sha256, hash_with_previous(plan.instances[1]));
  EXPECT_NE(records[8].sha256, records[6].sha256);
  EXPECT_EQ(records[8].message, "");
  EXPECT_EQ(records[8].work.start_pivots, Index(plan.instances[1].previous->alpha.size()));
  plan.done = {pairs.begin() + 1, pairs.end()};
  ASSERT_EQ(open_pairs(plan).size(), 1u);
  EXPECT_EQ(open_pairs(plan)[0].start, "cold");
}

TEST(Run, WithoutAStartIsRefused) {
  RunPlan plan = plan_of({"lemke"});
  plan.starts.clear();
  EXPECT_THROW(records_of(plan), std::invalid_argument);
}

TEST(Run, LeavesOutOtherShardsAndPairsThatAreDone) {
  RunPlan plan = plan_of({"lemke", "liar"}, 5);
  plan.shard = {1, 2};
  plan.done = {{"identity/3", plan.instances[3].sha256, "lemke", "cold"}};
  EXPECT_EQ(open_pairs(plan).size(), 3u);
  std::vector<std::string> ran;
  for (const Record& record : records_of(plan))
    ran.push_back(record.instance + " " + record.solver + " " + std::to_string(record.place));
  EXPECT_EQ(ran, (std::vector<std::string>{"identity/1 lemke 1", "identity/1 liar 1",
                                           "identity/3 liar 3"}));
}

TEST(Run, LeavesNoChildWhenARecordCannotBeKept) {
  const LeavesNothingBehind guard;
  RunPlan plan = plan_of({"sleeper"}, 3);
  plan.timeout = 200ms;
  plan.jobs = 2;
  EXPECT_THROW(run(
                   plan, [](const Record&) { throw std::runtime_error("disk full"); },
                   [](const Progress&) {}, false),
               std::runtime_error);
}

TEST(Run, RefusesAPlanThatMakesNoSense) {
  const auto refused = [](auto spoil) {
    RunPlan plan = plan_of({"lemke"});
    spoil(plan);
    EXPECT_THROW(records_of(plan), std::invalid_argument);
  };
  refused([](RunPlan& plan) { plan.jobs = 0; });
  refused([](RunPlan& plan) { plan.timeout = 0s; });
  refused([](RunPlan& plan) { plan.memory_bytes = 0; });
  refused([](RunPlan& plan) { plan.max_samples = 0; });
  refused([](RunPlan& plan) { plan.spread = std::numeric_limits<double>::quiet_NaN(); });
  refused([](RunPlan& plan) { plan.tolerance = -1; });
  refused([](RunPlan& plan) { plan.shard = {2, 2}; });
  refused([](RunPlan& plan) { plan.instances[0].problem.s_z(0) = 0; });
}

}  // namespace
}  // namespace lcp
