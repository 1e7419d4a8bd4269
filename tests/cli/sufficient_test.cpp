// `lcpbench sufficient` as its user meets it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

/// Every axis but friction and time step kept, so that there is little to simulate.
const std::string kSmall = "squat:points=8,reduction=none,active_only=off,matrix=clean";

class Sufficient : public ProgramTest {
 protected:
  Sufficient() : ProgramTest({"sufficient"}) {}
};

TEST_F(Sufficient, PrintsTheTableTheFloorAndWhatIsEnough) {
  const Ran ran = run({kSmall, "--duration", "12ms", "--rounds", "1", "--out", "answer"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  for (const char* words : {"Noise floor:", "frictionless", "dt=0.01", "tolerances"})
    EXPECT_NE(ran.out.find(words), std::string::npos) << words << "\n" << ran.out;
  EXPECT_TRUE(ran.out.find("Cheapest that passes:") != std::string::npos ||
              ran.out.find("Nothing cheaper") != std::string::npos)
      << ran.out;
  for (const char* name : {"answer/sufficient.txt", "answer/sufficient.csv",
                           "answer/sufficient.json", "answer/sufficient.svg", "answer/env.json"})
    EXPECT_TRUE(std::filesystem::exists(file(name))) << name;
  EXPECT_FALSE(std::filesystem::exists(file("answer.tmp")));
  expect_complaint({kSmall, "--duration", "12ms", "--out", "answer"}, 4, "answer: exists already");
}

TEST_F(Sufficient, PrintsJson) {
  const Ran ran = run({kSmall + ",directions=16,dt=0.001", "--duration", "12ms", "--rounds", "1",
                       "--json", "--force", "5"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const nlohmann::json study = nlohmann::json::parse(ran.out).at("studies").at(0);
  EXPECT_EQ(study.at("criteria").at("force_percent"), 5);
  EXPECT_EQ(study.at("kept").size(), 5u);
  EXPECT_EQ(study.at("rows").at(0).at("axis"), "reference");
  EXPECT_EQ(study.at("rows").at(1).at("axis"), "disturbed");
}

TEST_F(Sufficient, DryRunSimulatesNothing) {
  const Ran ran = run({"hoist", "net", "--dry-run", "--solver", "lemke-revised"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  for (const char* words : {"hoist:directions=16,matrix=clean", "net: up to", "lemke-revised"})
    EXPECT_NE(ran.out.find(words), std::string::npos) << words << "\n" << ran.out;
}

TEST_F(Sufficient, BadWordsAreOneLineAndStatus2) {
  expect_complaint({"sqat"}, 2, "unknown scene 'sqat', known are: hoist");
  expect_complaint({"squat", "--solver", "lemkey"}, 2, "unknown solver 'lemkey'");
  expect_complaint({"squat", "--duration", "3 apples"}, 2, "--duration");
  expect_complaint({"squat", "net", "hoist", "--duration", "1s", "--duration", "2s"}, 2,
                   "2 of them for 3 scenes");
  expect_complaint({"squat", "--force", "-1"}, 2, "--force");
  expect_complaint({"squat:dt=0.002", "--reference-dt", "1ms"}, 2, "its dt is given");
  expect_complaint({"squat", "--format", "latex"}, 2, "--format");
}

}  // namespace
}  // namespace lcp
