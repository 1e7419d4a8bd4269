// stability perturb, through the command line.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

using Json = nlohmann::json;

class Perturb : public ProgramTest {
 protected:
  Ran perturb(const std::vector<std::string>& more) {
    std::vector<std::string> words = {"stability", "perturb", "--corpus", "p.hdf5",
                                      "--solver",  "lemke",   "--solver", "best-first",
                                      "--trials",  "2",       "--out",    "out"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  void SetUp() override {
    ASSERT_EQ(run({"generate", "squat-like:contacts=4", "--count", "2", "--out", "p.hdf5"}).status,
              0);
  }
};

TEST_F(Perturb, WritesRowsFlipsAndAPictureAndPrintsTheTable) {
  const Ran ran = perturb({});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, read_text(file("out/flips.txt")));
  for (const char* name : {"run.json", "env.json", "perturb.json", "rows.jsonl", "flips.csv",
                           "flips.json", "flips.svg", "flips.gp", "flips.dat"})
    EXPECT_TRUE(std::filesystem::exists(file(std::string("out/") + name))) << name;
  const Json rows = Json::parse(read_text(file("out/flips.json"))).at("rows");
  ASSERT_EQ(rows.size(), 2u * 6);
  for (const Json& row : rows) {
    const bool baseline = row.at("kind") == "baseline";
    EXPECT_EQ(row.at("trials"), baseline ? 2 : 4) << row;
    if (row.at("solver") == "best-first") {
      EXPECT_EQ(row.at("solved"), row.at("trials")) << row;
    }
  }
  const std::string lines = read_text(file("out/rows.jsonl"));
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2 * 2 * (1 + 5 * 2));
  EXPECT_NE(lines.find("/0001~rotation-2\""), std::string::npos);
  EXPECT_EQ(run({"table", "out"}).status, 0) << "a run directory like any other";
}

TEST_F(Perturb, ResumesItsOwnQuestionAlone) {
  ASSERT_EQ(perturb({"--kind", "noise"}).status, 0);
  const Ran again = perturb({"--kind", "noise", "--resume", "--format", "json"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("12 rows were there, 0 are new"), std::string::npos) << again.err;
  EXPECT_EQ(again.out, read_text(file("out/flips.json")));
  expect_complaint(perturb({"--kind", "noise"}), 2, "out exists: --resume continues it");
  expect_complaint(perturb({"--kind", "noise", "--seed", "2", "--resume"}), 2,
                   "begun with other disturbances");
  ASSERT_EQ(run({"run", "--corpus", "p.hdf5", "--solver", "lemke", "--out", "plain"}).status, 0);
  expect_complaint(
      run({"stability", "perturb", "--corpus", "p.hdf5", "--out", "plain", "--resume"}), 2,
      "a run without disturbances");
}

TEST_F(Perturb, ADryRunPrintsThePairsAndTheLongestTime) {
  const Ran ran = perturb({"--kind", "units", "--dry-run"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("/0000~units-mm best-first\n"), std::string::npos) << ran.out;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 2 * 2 * 3);
  EXPECT_NE(ran.err.find("12 pairs to run: at most 2 min"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(file("out")));
}

TEST_F(Perturb, HelpEndsWithAnExample) {
  const Ran ran = run({"stability", "perturb", "--help"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_NE(ran.out.find("Example:\n  lcpbench stability perturb"), std::string::npos) << ran.out;
}

TEST_F(Perturb, BadInputIsOneLineThatSaysWhatIsAllowed) {
  expect_complaint(perturb({"--kind", "wind"}), 2, "noise");
  expect_complaint(perturb({"--trials", "0"}), 2, "--trials");
  expect_complaint(perturb({"--last-bits", "0"}), 2, "--last-bits");
  expect_complaint(perturb({"--angle", "200"}), 2, "--angle");
  expect_complaint(perturb({"--format", "latex"}), 2, "--format");
  expect_complaint(perturb({"--solver", "nobody"}), 2, "nobody");
  expect_complaint(perturb({"--trails", "3"}), 2, "--trials");
  expect_complaint(run({"stability", "perturb", "--corpus", "none.hdf5"}), 3, "none.hdf5");
  expect_complaint(run({"stability", "shake"}), 2, "perturb");
}

}  // namespace
}  // namespace lcp
