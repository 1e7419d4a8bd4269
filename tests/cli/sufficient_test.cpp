// `lcpbench sufficient` as its user meets it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

/// Every axis but friction and time step kept, so that there is little to simulate.
const std::string kSmall = "squat:points=8,reduction=none,active_only=off,matrix=clean";

class Sufficient : public testing::Test {
 protected:
  Ran run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "sufficient");
    return run_program(LCPBENCH, arguments, directory_.path());
  }
  void expect_complaint(const std::vector<std::string>& arguments, int status,
                        const std::string& words) {
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.status, status) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
    EXPECT_EQ(ran.out, "");
  }
  std::string file(const std::string& name) const { return directory_.file(name); }

 private:
  TemporaryDirectory directory_;
};

TEST_F(Sufficient, PrintsTheTableTheFloorAndWhatIsEnough) {
  const Ran ran = run({kSmall, "--duration", "30ms", "--rounds", "1", "--out", "answer"});
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
  expect_complaint({kSmall, "--duration", "30ms", "--out", "answer"}, 4, "answer: exists already");
}

TEST_F(Sufficient, PrintsJson) {
  const Ran ran = run({kSmall, "--duration", "30ms", "--rounds", "1", "--json", "--force", "5"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const nlohmann::json study = nlohmann::json::parse(ran.out).at("studies").at(0);
  EXPECT_EQ(study.at("criteria").at("force_percent"), 5);
  EXPECT_EQ(study.at("kept").size(), 3u);
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
