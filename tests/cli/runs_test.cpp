// Runs that are resumed, shared out, merged and compared, through the command line.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

using Json = nlohmann::json;

class Runs : public ProgramTest {
 protected:
  /// Two published instances and two solvers into `out`.
  Ran measure(const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"run",      "--corpus",   "p.hdf5", "--solver", "lemke",
                                      "--solver", "best-first", "--out",  out};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  void SetUp() override {
    ASSERT_EQ(run({"generate", "published", "--count", "2", "--out", "p.hdf5"}).status, 0);
  }
  /// Changes every row of a run.
  void doctor(const std::string& name, const std::function<void(Json&)>& change) {
    std::istringstream lines(read_text(file(name + "/rows.jsonl")));
    std::string changed;
    for (std::string line; std::getline(lines, line);) {
      Json row = Json::parse(line);
      change(row);
      changed += row.dump() + "\n";
    }
    write_text(file(name + "/rows.jsonl"), changed);
  }
};

TEST_F(Runs, ResumeGoesOnWithWhatIsThereAndBeginsWhereNothingIs) {
  const Ran first = measure("r", {"--resume"});
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.err.find("0 rows were there, 4 are new"), std::string::npos) << first.err;
  std::string text = read_text(file("r/rows.jsonl"));
  text.resize(text.find('\n') + 40);
  write_text(file("r/rows.jsonl"), text);
  const Ran second = measure("r", {"--resume"});
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_NE(second.err.find("1 rows were there, 3 are new"), std::string::npos) << second.err;
  EXPECT_EQ(rows("r"), 4);
}

TEST_F(Runs, ResumeRefusesAnotherQuestion) {
  ASSERT_EQ(measure("r").status, 0);
  expect_complaint(measure("r", {"--resume", "--tolerance", "1e-9"}), 2,
                   "tolerance 1e-06, 1e-09; name a new directory with --out");
  EXPECT_EQ(rows("r"), 4);
}

TEST_F(Runs, StartTwoStepIsInRowsSettingsAndTableAndPartOfTheQuestion) {
  ASSERT_EQ(run({"generate", "squat-like", "--count", "2", "--out", "p.hdf5"}).status, 0);
  const Ran ran = measure("r", {"--start", "two-step"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("Start: two-step; pivots before it are not counted."), std::string::npos);
  EXPECT_EQ(Json::parse(read_text(file("r/run.json"))).at("start"), "two-step");
  doctor("r", [](Json& row) { EXPECT_EQ(row.at("start"), "two-step"); });
  EXPECT_EQ(measure("r", {"--start", "two-step", "--resume"}).status, 0);
  expect_complaint(measure("r", {"--resume"}), 2, "start two-step, cold; name a new directory");
  expect_complaint(measure("s", {"--start", "warm"}), 2, "two-step");

  const auto solved = [&](const std::string& start) {
    const Ran answer = run(
        {"solve", "p.hdf5#squat-like/0001", "--solver", "best-first", "--start", start, "--json"});
    return Json::parse(answer.out).at("results")[0];
  };
  const Json two_step = solved("two-step"), cold = solved("cold");
  EXPECT_EQ(two_step.at("start"), "two-step");
  EXPECT_EQ(two_step.at("verdict"), "solved");
  EXPECT_GT(two_step.at("work").at("start_pivots"), 0);
  EXPECT_GT(two_step.at("work").at("frictionless_pivots"), 0);
  EXPECT_EQ(cold.at("start"), "cold");
  EXPECT_EQ(cold.at("work").at("frictionless_pivots"), 0);
}

TEST_F(Runs, SeveralStartsAreRowsOfOneRunAndATableOfGainsAndLosses) {
  ASSERT_EQ(run({"generate", "squat-like", "--count", "3", "--out", "p.hdf5"}).status, 0);
  const std::vector<std::string> starts = {"--start", "previous", "--start",
                                           "cold",    "--start",  "two-step"};
  const Ran ran = measure("r", starts);
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(rows("r"), 18);
  EXPECT_EQ(Json::parse(read_text(file("r/run.json"))).at("start"), "cold, two-step, previous");
  for (const char* words : {"best-first [cold]", "best-first [two-step]", "best-first [previous]",
                            "gained lost", "t/cold"})
    EXPECT_NE(ran.out.find(words), std::string::npos) << words << " in\n" << ran.out;
  const Json table = Json::parse(run({"table", "r", "--format", "json"}).out).at("rows");
  ASSERT_EQ(table.size(), 6u);
  EXPECT_EQ(table[3].at("start"), "cold");
  EXPECT_TRUE(table[3].at("gained").is_null());
  EXPECT_EQ(table[5].at("start"), "previous");
  EXPECT_EQ(table[5].at("lost"), 0);
  EXPECT_EQ(table[5].at("restarted"), 1) << "the first frame";

  const Ran left =
      measure("r", {"--start", "previous", "--start", "cold", "--start", "two-step", "--resume"});
  EXPECT_NE(left.err.find("18 rows were there, 0 are new"), std::string::npos) << left.err;
  expect_complaint(measure("r", {"--resume"}), 2, "start cold, two-step, previous, cold");
  EXPECT_EQ(run({"compare", "r", "r"}).status, 0);

  const Ran dry = measure("s", {"--start", "cold", "--start", "previous", "--dry-run"});
  EXPECT_NE(dry.out.find("squat-like/0001 lemke previous\n"), std::string::npos) << dry.out;
  const Ran solved = run({"solve", "p.hdf5#squat-like/0001", "--solver", "best-first", "--start",
                          "previous", "--start", "cold", "--json"});
  const Json results = Json::parse(solved.out).at("results");
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].at("start"), "cold");
  EXPECT_GT(results[1].at("work").at("start_pivots"), 0);
  EXPECT_LT(results[1].at("work").at("pivots"), results[0].at("work").at("pivots"));
}

TEST_F(Runs, ADryRunTellsWhatIsLeftAndHowLongItTakes) {
  const Ran before = measure("runs/r", {"--dry-run"});
  EXPECT_NE(before.err.find("4 that no run below runs/ has measured: at most 40 s"),
            std::string::npos)
      << before.err;
  ASSERT_EQ(measure("runs/r").status, 0);
  const Ran after = measure("runs/s", {"--dry-run"});
  EXPECT_NE(after.err.find("expected: "), std::string::npos) << after.err;
  EXPECT_NE(after.err.find("for 4 of them"), std::string::npos) << after.err;
  EXPECT_EQ(measure("runs/r", {"--dry-run", "--resume"}).out, "");
}

TEST_F(Runs, ShardsHaveDirectoriesOfTheirOwnAndMergeIntoTheWhole) {
  for (const char* shard : {"1/2", "2/2"}) {
    const Ran ran = run({"run", "--corpus", "p.hdf5", "--solver", "lemke", "--shard", shard});
    EXPECT_EQ(ran.status, 0) << ran.err;
  }
  const Ran merged = run({"merge", "runs/p-1of2", "runs/p-2of2", "whole"});
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_EQ(merged.out, read_text(file("whole/table.txt")));
  EXPECT_EQ(rows("whole"), 2);
  expect_complaint(run({"merge", "runs/p-1of2", "runs/p-2of2", "whole"}), 2, "whole exists");
  expect_complaint(run({"merge", "runs/p-1of2", "runs/p-1of2", "twice"}), 2, "both hold lemke");
  expect_complaint(run({"merge", "runs/p-1of2", "nowhere", "x"}), 3, "nowhere/run.json");
  EXPECT_FALSE(std::filesystem::exists(file("twice")));
}

TEST_F(Runs, ADirectorysRunIsCalledAfterIt) {
  std::filesystem::create_directory(file("mine"));
  std::filesystem::rename(file("p.hdf5"), file("mine/p.hdf5"));
  EXPECT_EQ(run({"run", "--corpus", "mine/", "--solver", "lemke"}).status, 0);
  EXPECT_EQ(rows("runs/mine"), 2);
}

TEST_F(Runs, AShardThatCannotBeIsRefused) {
  expect_complaint(measure("r", {"--shard", "3/2"}), 2, "--shard 3/2: expected I/N");
}

TEST_F(Runs, CompareListsRegressionsAndFailsOnThem) {
  ASSERT_EQ(measure("old").status, 0);
  ASSERT_EQ(measure("new").status, 0);
  EXPECT_EQ(run({"compare", "old", "new", "--time-ratio", "1000"}).status, 0);
  doctor("new", [](Json& row) {
    row["work"]["pivots"] = 2 * row["work"]["pivots"].get<int>();
    if (row["instance"] == "published/kostreva-1" && row["solver"] == "best-first")
      row["verdict"] = "limit";
  });
  const Ran worse = run({"compare", "old", "new", "--time-ratio", "1000"});
  EXPECT_EQ(worse.status, 1);
  EXPECT_NE(worse.out.find("\nlost "), std::string::npos) << worse.out;
  EXPECT_NE(worse.out.find("solved limit"), std::string::npos) << worse.out;
  const Json json =
      Json::parse(run({"compare", "old", "new", "--time-ratio", "1000", "--json"}).out);
  EXPECT_EQ(json.at("compared"), 4);
  EXPECT_EQ(json.at("regressions")[0].at("kind"), "lost");
  expect_complaint(run({"compare", "old", "nowhere"}), 3, "nowhere/run.json");
}

TEST_F(Runs, SuitesTellWhenTheyWereLastMeasured) {
  EXPECT_NE(run({"list", "suites"}).out.find("not measured below runs/ or results/"),
            std::string::npos);
}

}  // namespace
}  // namespace lcp
