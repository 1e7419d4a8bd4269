// Rows that misbehave on purpose, through the real command line: each is a row of the table with the
// right verdict, and the run goes on.

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

using Json = nlohmann::json;

TEST(NullControls, AreRowsWithTheirVerdictsAndTheRunGoesOn) {
  const TemporaryDirectory directory;
  ASSERT_EQ(run_program(LCPBENCH, {"generate", "published", "--count", "2", "--out", "p.json"},
                        directory.path())
                .status,
            0);
  const Ran ran = run_program(LCPBENCH_WITH_CONTROLS,
                              {"run",
                               "--corpus",
                               "p.json",
                               "--timeout",
                               "3s",
                               "--memory",
                               "64MiB",
                               "--solver",
                               "liar",
                               "--solver",
                               "nan-maker",
                               "--solver",
                               "sleeper",
                               "--solver",
                               "crasher",
                               "--solver",
                               "outside-crasher",
                               "--solver",
                               "memory-eater",
                               "--solver",
                               "thrower",
                               "--solver",
                               "lexicographic-pivot",
                               "--out",
                               "r"},
                              directory.path());
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json rows = Json::parse(read_text(directory.file("r/table.json"))).at("rows");
  std::map<std::string, Json> row_of;
  for (const Json& row : rows) row_of[row.at("solver")] = row;
  const std::map<std::string, std::string> expected = {
      {"liar", "wrong"},    {"nan-maker", "wrong"},       {"sleeper", "timeout"},
      {"crasher", "crash"}, {"outside-crasher", "crash"}, {"memory-eater", "memory"},
      {"thrower", "crash"}};
  for (const auto& [solver, verdict] : expected) {
    const Json& row = row_of.at(solver);
    EXPECT_EQ(row.at("success"), 0) << solver;
    EXPECT_EQ(row.at("trivial"), 0) << solver;
    EXPECT_EQ(row.at("failure"), 2) << solver;
    EXPECT_EQ(row.at("verdicts"), (Json{{verdict, 2}})) << solver;
  }
  EXPECT_EQ(row_of.at("lexicographic-pivot").at("instances"), 2);
  EXPECT_NE(read_text(directory.file("r/rows.jsonl"))
                .find("outside-crasher: the outside library aborted the process"),
            std::string::npos);
}

TEST(NullControls, ACrashOfAnOutsideLibraryInThisProcessLeavesALine) {
  const TemporaryDirectory directory;
  run_program(LCPBENCH, {"generate", "published", "--count", "1", "--out", "p.json"},
              directory.path());
  const Ran ran = run_program(LCPBENCH_WITH_CONTROLS,
                              {"solve", "p.json", "--solver", "outside-crasher"}, directory.path());
  EXPECT_NE(ran.status, 0);
  EXPECT_EQ(ran.err, "outside-crasher: the outside library aborted the process\n");
}

TEST(NullControls, TestSolverEndsWithStatusOneForALiar) {
  const TemporaryDirectory directory;
  const Ran ran = run_program(LCPBENCH_WITH_CONTROLS, {"test-solver", "liar"}, directory.path());
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.out.find("FAIL"), std::string::npos);
}

TEST(NullControls, AnInterruptedRunKeepsWhatIsFinished) {
  const TemporaryDirectory directory;
  const std::vector<std::string> arguments = {"run",      "--suite", "small", "--timeout", "100ms",
                                              "--solver", "sleeper", "--out", "r"};
  const Ran ran = run_program(LCPBENCH_WITH_CONTROLS, arguments, directory.path(), "r/rows.jsonl");
  EXPECT_EQ(ran.status, 130);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err.rfind("interrupted: ", 0), 0u) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  const Ran table =
      run_program(LCPBENCH_WITH_CONTROLS, {"table", "r", "--format", "json"}, directory.path());
  ASSERT_EQ(table.status, 0) << table.err;
  const Json row = Json::parse(table.out).at("rows").at(0);
  EXPECT_GE(row.at("cycle"), 1);  // time-outs count there
  EXPECT_EQ(row.at("cycle"), row.at("instances"));
}

}  // namespace
}  // namespace lcp
