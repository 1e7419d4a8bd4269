#include "harness/runs/merge.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "tests/harness/runs/small_plan.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

using nlohmann::json;

class Merge : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return directory_.file(name); }
  StoredRun shard(Index index, Index count) {
    RunPlan plan = small_plan();
    plan.shard = {index, count};
    const std::string directory = at("shard" + std::to_string(index));
    run_small(directory, plan);
    return read_stored_run(directory);
  }
  StoredRun merged(const std::vector<StoredRun>& runs, bool mixed = false) {
    return merge(runs, at("out"), {.mixed = mixed},
                 [this](const std::string& line) { noted_.push_back(line); });
  }
  void expect_refused(const std::vector<StoredRun>& runs, const std::string& why) {
    try {
      merged(runs);
      ADD_FAILURE() << "merged, expected: " << why;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  }

  std::vector<std::string> noted_;

 private:
  const TemporaryDirectory directory_;
};

TEST_F(Merge, OfFourShardsIsTheWholeRun) {
  run_small(at("whole"), small_plan());
  // In any order of the shards.
  const std::vector<StoredRun> shards = {shard(2, 4), shard(0, 4), shard(3, 4), shard(1, 4)};
  write_stored_run(merged(shards));
  EXPECT_TRUE(noted_.empty());
  EXPECT_EQ(deterministic_rows(at("out")), deterministic_rows(at("whole")));
  EXPECT_EQ(read_stored_run(at("out")).settings.shard, Shard{});
}

TEST_F(Merge, TellsWhichShardsAreMissingAndTheResultCanBeResumed) {
  run_small(at("whole"), small_plan());
  write_stored_run(merged({shard(0, 4), shard(2, 4)}));
  EXPECT_EQ(noted_, std::vector<std::string>{"missing: shard 2, 4 of 4"});
  run_small(at("out"), small_plan(), Existing::resume);
  EXPECT_EQ(deterministic_rows(at("out")), deterministic_rows(at("whole")));
}

TEST_F(Merge, RefusesOtherCommitsAndEnvironmentsUnlessTold) {
  const StoredRun here = shard(0, 2);
  StoredRun there = shard(1, 2);
  there.environments[0]["id"] = "elsewhere";
  there.environments[0]["cpu"] = "an abacus";
  expect_refused({here, there}, "an abacus");
  there.environments[0]["commit"] = "0123456";
  expect_refused({here, there}, "different commits");
  const StoredRun both = merged({here, there}, true);
  EXPECT_EQ(both.rows.size(), 18u);
  EXPECT_EQ(both.environments.size(), 2u);
}

TEST_F(Merge, RefusesRunsThatWereAskedForDifferentThings) {
  const StoredRun here = shard(0, 2);
  StoredRun there = shard(1, 2);
  there.settings.timeout_s = 1;
  expect_refused({here, there}, "timeout in s 60, 1");
}

TEST_F(Merge, RefusesAPairThatHasTwoRows) {
  const StoredRun here = shard(0, 2);
  expect_refused({here, here}, "both hold lemke of published/");
}

TEST_F(Merge, WritesNothingOverWhatIsThere) {
  const StoredRun here = shard(0, 1);
  std::filesystem::create_directory(at("out"));
  EXPECT_THROW(write_stored_run(merged({here})), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(at("out")));
}

}  // namespace
}  // namespace lcp
