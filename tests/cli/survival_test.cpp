// What becomes of a run when the program is killed: resumed, it ends as if nothing had happened.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

using Json = nlohmann::json;
using std::chrono::milliseconds;

/// Rows of a run without what depends on time and machine, sorted.
std::vector<Json> rows_of(const std::string& directory) {
  std::vector<Json> rows;
  std::istringstream lines(read_text(directory + "/rows.jsonl"));
  for (std::string line; std::getline(lines, line);) {
    rows.push_back(Json::parse(line));
    for (const char* field : {"times_ns", "median_ns", "environment"}) rows.back().erase(field);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

class Survival : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run({"generate", "published", "--count", "12", "--out", "corpus.hdf5"}).status, 0);
    ASSERT_EQ(run(command("whole")).status, 0);
  }
  static std::vector<std::string> command(const std::string& out,
                                          const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"run",         "--corpus", "corpus.hdf5",
                                      "--solver",    "lemke*",   "--solver",
                                      "best-first*", "--out",    out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Ran run(const std::vector<std::string>& words) {
    return run_program(LCPBENCH, words, directory_.path());
  }
  std::string at(const std::string& name) const { return directory_.file(name); }
  /// Resumes the run `name` to its end and expects the rows and files of `whole`.
  void expect_whole_after_resuming(const std::string& name) {
    const Ran resumed = run(command(name, {"--resume"}));
    EXPECT_EQ(resumed.status, 0) << resumed.err;
    EXPECT_EQ(rows_of(at(name)), rows_of(at("whole")));
    std::vector<std::string> files[2];
    for (const int k : {0, 1})
      for (const auto& entry : std::filesystem::directory_iterator(at(k == 0 ? name : "whole")))
        files[k].push_back(entry.path().filename());
    for (auto& names : files) std::sort(names.begin(), names.end());
    EXPECT_EQ(files[0], files[1]);
  }

  const TemporaryDirectory directory_;
};

TEST_F(Survival, KilledAtTwentyRandomTimesARunIsResumedToTheSameRows) {
  const auto time_of = [](const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - begin);
  };
  milliseconds whole = time_of([&] { ASSERT_EQ(run(command("again")).status, 0); });
  std::mt19937 random(2008);
  int killed = 0, with_rows = 0;
  // As other work comes and goes, some runs end before they are killed, others are killed before
  // their first row.
  for (int trial = 0; (killed < 20 || with_rows < 5) && trial < 100; ++trial) {
    const milliseconds delay(random() % static_cast<unsigned>(whole.count() + 1));
    const std::string name = fmt::format("r{}", trial);
    if (run_and_kill(LCPBENCH, command(name), directory_.path(), delay).status == -SIGKILL) {
      ++killed;
      if (std::filesystem::exists(at(name + "/rows.jsonl")))
        with_rows += !read_text(at(name + "/rows.jsonl")).empty();
    }
    SCOPED_TRACE(testing::Message() << "killed after " << delay.count() << " ms");
    const milliseconds resumed = time_of([&] { expect_whole_after_resuming(name); });
    whole = (whole + std::max(whole, resumed)) / 2;
    std::filesystem::remove_all(at(name));
  }
  EXPECT_GE(killed, 20);
  EXPECT_GE(with_rows, 5) << "kills came before the first row";
}

TEST_F(Survival, KilledAgainAndAgainItStillEnds) {
  std::mt19937 random(1968);
  for (int trial = 0; trial < 10; ++trial)
    run_and_kill(LCPBENCH, command("r", {"--resume"}), directory_.path(),
                 milliseconds(100 + random() % 200));
  expect_whole_after_resuming("r");
}

TEST_F(Survival, KilledInsideARowsWriteItLosesThatRowAlone) {
  for (const int row : {1, 7, 30}) {
    const std::string name = fmt::format("r{}", row);
    ASSERT_EQ(
        run_and_kill_in_write(LCPBENCH, command(name), directory_.path(), "rows.jsonl", row).status,
        -SIGKILL);
    const std::string rows = read_text(at(name + "/rows.jsonl"));
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), row - 1);
    EXPECT_NE(rows.back(), '\n') << "no row was torn";
    expect_whole_after_resuming(name);
  }
}

TEST_F(Survival, FourShardsMergedAreTheWholeRun) {
  std::vector<std::string> merge = {"merge"};
  for (const char* shard : {"1/4", "2/4", "3/4", "4/4"}) {
    merge.push_back(std::string("s") + shard[0]);
    ASSERT_EQ(run(command(merge.back(), {"--shard", shard})).status, 0);
  }
  merge.push_back("merged");
  ASSERT_EQ(run(merge).status, 0);
  EXPECT_EQ(rows_of(at("merged")), rows_of(at("whole")));
  EXPECT_EQ(run({"compare", "whole", "merged", "--time-ratio", "1000"}).status, 0);
}

TEST_F(Survival, ADiskThatFillsUpEndsInOneLineAndKeepsTheRows) {
  std::string words;
  for (const std::string& word : command("r")) words += " '" + word + "'";
  // The limit on file size, 20 blocks of 512 bytes, stands for the disk.
  const Ran full =
      run_program("/bin/sh", {"-c", "ulimit -f 20; " LCPBENCH + words}, directory_.path());
  EXPECT_EQ(full.status, 4);
  EXPECT_EQ(std::count(full.err.begin(), full.err.end(), '\n'), 1) << full.err;
  EXPECT_NE(full.err.find("r/rows.jsonl"), std::string::npos) << full.err;
  EXPECT_GT(rows_of(at("r")).size(), 3u);
  expect_whole_after_resuming("r");
}

}  // namespace
}  // namespace lcp
