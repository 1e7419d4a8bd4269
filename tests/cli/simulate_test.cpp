// `lcpbench simulate` as its user meets it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

class Simulate : public ProgramTest {
 protected:
  Simulate() : ProgramTest({"simulate"}) {}
};

TEST_F(Simulate, PrintsASummary) {
  const Ran ran = run({"squat:points=8", "--duration", "20ms"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_NE(ran.out.find("squat:points=8, best-first in the loop: 0.02 s at 1 ms"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("19 solved, 0 failed"), std::string::npos) << ran.out;
}

TEST_F(Simulate, PrintsJson) {
  const Ran ran = run({"squat:points=8", "--duration", "20ms", "--dt", "2ms", "--json"});
  const nlohmann::json summary = nlohmann::json::parse(ran.out);
  EXPECT_EQ(summary.at("steps"), 10);
  EXPECT_EQ(summary.at("failure"), 0);
}

TEST_F(Simulate, DumpsACorpusThatOtherVerbsRead) {
  const Ran ran =
      run({"squat:points=8", "--duration", "5ms", "--dump", "corpus", "--log", "log.csv"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.err.find("16 instances are in corpus"), std::string::npos) << ran.err;
  EXPECT_TRUE(std::filesystem::exists(file("log.csv")));
  const Ran solved = run_program(
      LCPBENCH, {"solve", "corpus/0000.hdf5#squat:points=8/00004", "--solver", "best-first"},
      file("."));
  EXPECT_NE(solved.out.find("best-first: solved"), std::string::npos) << solved.out << solved.err;
}

TEST_F(Simulate, BadWordsAreOneLineAndStatus2) {
  expect_complaint({"sqat"}, 2,
                   "unknown scene 'sqat', known are: hoist, net, ring, squat, tap-dance");
  expect_complaint({"squat:pints=3"}, 2, "pints");
  expect_complaint({"squat", "--duration", "3 apples"}, 2, "--duration");
  expect_complaint({"squat", "--solver", "lemkey"}, 2, "unknown solver 'lemkey'");
  expect_complaint({"squat", "--tolerance", "-1"}, 2, "--tolerance");
}

TEST_F(Simulate, OutputThatCannotBeWrittenIsOneLineAndStatus4) {
  write_text(file("taken"), "");
  expect_complaint({"squat", "--duration", "2ms", "--dump", "taken"}, 4, "taken: exists already");
  expect_complaint({"squat", "--duration", "2ms", "--log", "nowhere/log.csv"}, 4,
                   "nowhere/log.csv");
}

TEST_F(Simulate, InterruptedKeepsWholeShardsAndSaysSo) {
  const Ran ran =
      run({"squat:points=8,mu=0", "--duration", "100s", "--dump", "corpus"}, "corpus/0000.hdf5");
  EXPECT_EQ(ran.status, 130);
  EXPECT_NE(ran.out.find("ended early: interrupted"), std::string::npos) << ran.out;
  const Ran info = run_program(LCPBENCH, {"info", "corpus"}, file("."));
  EXPECT_EQ(info.status, 0) << info.err;
}

}  // namespace
}  // namespace lcp
