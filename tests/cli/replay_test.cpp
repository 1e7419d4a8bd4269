#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

class ReplayCli : public ProgramTest {
 protected:
  void SetUp() override {
    // tests/harness/studies/replay/rounded_zero.h
    write_text(file("zero.json"),
               R"({"name": "zero", "M": [[0.5, 1, 0], [-48.5, 0, 0], [-48.5, 0, 0]],)"
               R"( "q": [-1, 48, 48]})");
  }
};

TEST_F(ReplayCli, PrintsTheFirstWrongPivot) {
  const Ran ran = run({"replay", "zero.json", "--solver", "lemke"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("zero (n = 3), lemke: ray"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("first wrong pivot: number 3"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("in 113 bits: solved after 3 pivots"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.err, "");
}

TEST_F(ReplayCli, PrintsJson) {
  const Ran ran = run({"replay", "zero.json", "--solver", "lemke", "--json"});
  const nlohmann::json page = nlohmann::json::parse(ran.out);
  EXPECT_EQ(page["instance"], "zero");
  EXPECT_EQ(page["departure"]["pivot"], 3);
}

TEST_F(ReplayCli, ShowsTheWindowAskedForOrEverything) {
  const auto lines = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"replay", "zero.json", "--solver", "lemke"};
    words.insert(words.end(), more.begin(), more.end());
    const std::string out = run(words).out;
    return std::count(out.begin(), out.end(), '\n');
  };
  EXPECT_LT(lines({"--window", "1"}), lines({"--all"}) + 1);
  EXPECT_GE(lines({"--all"}), lines({}));
}

TEST_F(ReplayCli, WantsOneInstanceAndOneSolver) {
  ASSERT_EQ(run({"generate", "published", "--count", "3", "--out", "three.hdf5"}).status, 0);
  expect_complaint({"replay", "three.hdf5", "--solver", "lemke"}, 2, "holds 3 instances");
  expect_complaint({"replay", "zero.json", "--solver", "nosuch"}, 2, "'nosuch'");
  expect_complaint({"replay", "zero.json", "--solver", "lemke*"}, 2, "'lemke*'");
  expect_complaint({"replay", "zero.json"}, 2, "--solver");
  expect_complaint({"replay", "nosuch.hdf5", "--solver", "lemke"}, 3, "nosuch.hdf5");
  expect_complaint({"replay", "zero.json", "--solver", "lemke", "--start", "warm"}, 2, "--start");
}

}  // namespace
}  // namespace lcp
