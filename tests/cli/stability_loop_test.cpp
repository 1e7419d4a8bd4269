// `lcpbench stability loop` as its user meets it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

class StabilityLoop : public ProgramTest {
 protected:
  StabilityLoop() : ProgramTest({"stability", "loop"}) {}
};

TEST_F(StabilityLoop, PrintsALineForEachSolverAndForTheControls) {
  const Ran ran = run({"squat:points=8", "--duration", "30ms", "--solver", "best-first", "--solver",
                       "lexicographic:delta=1e-8", "--out", "answer"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  for (const char* words : {"reference, disturbed by 1e-12", "reference, half the time step",
                            "lexicographic ", "went to 0.03 s"})
    EXPECT_NE(ran.out.find(words), std::string::npos) << words << "\n" << ran.out;
  for (const char* name : {"answer/loop.txt", "answer/loop.csv", "answer/loop.json",
                           "answer/loop.svg", "answer/env.json"})
    EXPECT_TRUE(std::filesystem::exists(file(name))) << name;
  expect_complaint({"squat", "--solver", "best-first", "--out", "answer"}, 4,
                   "answer: exists already");
}

TEST_F(StabilityLoop, ASolverThatCrashesIsALineToo) {
  const Ran ran = run_other(LCPBENCH_WITH_CONTROLS, {"squat:points=8", "--duration", "10ms",
                                                     "--solver", "crasher", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const nlohmann::json rows = nlohmann::json::parse(ran.out).at("rows");
  EXPECT_NE(rows.back().at("broken").get<std::string>().find("crashed with signal"),
            std::string::npos)
      << rows.back().dump();
  EXPECT_TRUE(rows.back().at("distance_mm").is_null() || rows.back().at("frames") == 0);
}

TEST_F(StabilityLoop, DryRunSimulatesNothing) {
  const Ran ran = run({"hoist", "--solver", "lexicographic*", "--dry-run"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("lexicographic-revised"), std::string::npos) << ran.out;
}

TEST_F(StabilityLoop, BadWordsAreOneLineAndStatus2) {
  expect_complaint({"sqat", "--solver", "lemke"}, 2, "unknown scene 'sqat'");
  expect_complaint({"squat"}, 2, "--solver");
  expect_complaint({"squat", "--solver", "lemkey"}, 2, "unknown solver 'lemkey'");
  expect_complaint({"squat", "--solver", "lemke", "--limit", "soon"}, 2, "--limit");
  expect_complaint({"squat", "--solver", "lemke", "--departure", "0"}, 2, "--departure");
}

}  // namespace
}  // namespace lcp
