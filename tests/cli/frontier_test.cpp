// `lcpbench stability frontier`, through the command line.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

class FrontierVerb : public ProgramTest {
 protected:
  FrontierVerb() : ProgramTest({"stability", "frontier"}) {}
  /// Two by two cells on which a limit of pivots is a line: active pairs and one for z0.
  Ran small(std::vector<std::string> more, const std::string& interrupt_when = "") {
    const std::vector<std::string> words{
        "semidefinite:degenerate=0", "--x",      "n=8,10",     "--y",     "active=1,4", "--solver",
        "lemke:max_pivots=3",        "--solver", "best-first", "--count", "4"};
    more.insert(more.begin(), words.begin(), words.end());
    return run(more, interrupt_when);
  }
};

TEST_F(FrontierVerb, PrintsLinesAndAgreementAndWritesEveryForm) {
  const Ran ran = small({"--check-seed", "2"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("2.5 [1.06, 3.94]"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("2 of 2 (2 of 2)"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("above"), std::string::npos) << ran.out;
  const std::string out = "runs/frontier-semidefinite-n-active";
  EXPECT_EQ(rows(out), 2 * 2 * 2 * 4);
  EXPECT_EQ(rows(out + "/seed-2"), 2 * 2 * 2 * 4);
  for (const char* name : {"run.json", "env.json", "frontier.svg", "frontier.gp", "frontier.dat"})
    EXPECT_TRUE(std::filesystem::exists(file(out + "/" + name))) << name;
  EXPECT_EQ(read_text(file(out + "/frontier.txt")), ran.out);
  const nlohmann::json json = nlohmann::json::parse(read_text(file(out + "/frontier.json")));
  EXPECT_EQ(json.at("check").at("agreement")[0].at("agree"), 2);
}

TEST_F(FrontierVerb, ResumesWithoutRepeatingAndPrintsTheFormatAskedFor) {
  ASSERT_EQ(small({"--out", "r"}).status, 0);
  EXPECT_EQ(small({"--out", "r"}).status, 2) << "exists";
  const Ran csv = small({"--out", "r", "--resume", "--format", "csv"});
  ASSERT_EQ(csv.status, 0) << csv.err;
  EXPECT_EQ(csv.out, read_text(file("r/frontier.csv")));
  EXPECT_EQ(rows("r"), 32);
  const Ran json = small({"--out", "r", "--resume", "--format", "json"});
  EXPECT_EQ(json.out, read_text(file("r/frontier.json")));
}

TEST_F(FrontierVerb, KeepsWhatIsDoneWhenInterrupted) {
  const Ran ran = run({"semidefinite:degenerate=0", "--x", "n=8,10", "--y", "active=1,2,3,4",
                       "--solver", "lemke", "--count", "100", "--max-count", "100", "--out", "r"},
                      "r/rows.jsonl");
  EXPECT_EQ(ran.status, 130) << ran.err;
  EXPECT_NE(ran.err.find("the same command with --resume goes on"), std::string::npos) << ran.err;
  EXPECT_GE(rows("r"), 1);
  EXPECT_LT(rows("r"), 800);
  EXPECT_FALSE(std::filesystem::exists(file("r/frontier.json")));
}

TEST_F(FrontierVerb, ADryRunPrintsCellsPairsAndTimeAndWritesNothing) {
  const Ran ran = small({"--dry-run", "--check-seed", "2", "--max-count", "8"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("semidefinite:degenerate=0,n=8,active=4\n"), std::string::npos) << ran.out;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 4);
  EXPECT_NE(ran.err.find("4 cells, 2 solvers, 4 draws each, two seeds: 64 pairs, at most 128"),
            std::string::npos)
      << ran.err;
  EXPECT_NE(ran.err.find("expected: "), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(file("runs")));
}

TEST_F(FrontierVerb, ComplainsInOneLineOfWhatItCannotDo) {
  const std::string x = "n=8,10", y = "active=1,4";
  expect_complaint({"semidefinit", "--x", x, "--y", y}, 2,
                   "unknown family 'semidefinit', known are: ");
  expect_complaint({"semidefinite", "--x", "m=1,2", "--y", y}, 2,
                   "semidefinite has no knob 'm', it has: n, rank");
  expect_complaint({"semidefinite", "--x", "n=8", "--y", y}, 2, "--x n=8: one value makes no axis");
  expect_complaint({"semidefinite", "--x", x, "--y", "active=1,many"}, 2, "'many' is no number");
  expect_complaint({"semidefinite", "--x", x, "--y", "n=1,4"}, 2, "--x and --y are both 'n'");
  expect_complaint({"semidefinite", "--x", x, "--y", "active=1,2.5"}, 2, "active=2.5: expected");
  expect_complaint({"semidefinite", "--x", x, "--y", "active=1,40"}, 2, "active");
  expect_complaint({"semidefinite", "--x", x}, 2, "--y is required");
  expect_complaint({"semidefinite", "--x", x, "--y", y, "--solver", "lemk"}, 2, "unknown solver");
  expect_complaint({"semidefinite", "--x", x, "--y", y, "--max-count", "4"}, 2,
                   "--max-count 4: expected at least --count, 8");
  expect_complaint({"semidefinite", "--x", x, "--y", y, "--check-seed", "1"}, 2,
                   "--check-seed 1 is --seed");
  expect_complaint({"semidefinite", "--x", x, "--y", y, "--format", "latex"}, 2, "--format");
  EXPECT_FALSE(exists("runs"));
}

}  // namespace
}  // namespace lcp
