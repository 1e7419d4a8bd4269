// `lcpbench paper` as its user meets it; what it computes is tested in tests/harness/paper.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

class Paper : public ProgramTest {
 protected:
  Paper() : ProgramTest({"paper"}) {}
};

TEST_F(Paper, WithoutATableOrFigureSaysWhatIsAllowed) {
  const Ran ran = run({});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.err, "lcpbench paper: expected one of --table, --figure, --choices, --all\n");
}

TEST_F(Paper, KnowsItsTablesAndFigures) {
  EXPECT_EQ(run({"--table", "7"}).status, 2);
  EXPECT_EQ(run({"--figure", "1"}).status, 2);
  EXPECT_EQ(run({"--table", "1", "--figure", "2"}).status, 2);
  EXPECT_EQ(run({"--table", "1", "--format", "pdf"}).status, 2);
}

TEST_F(Paper, ADryRunNamesTheSimulationsAndMakesNothing) {
  const Ran ran = run({"--table", "1", "--dry-run", "--out", "paper"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("simulation of squat with lemke\n"), std::string::npos) << ran.out;
  EXPECT_FALSE(std::filesystem::exists(file("paper")));
}

TEST_F(Paper, ADryRunOfTable3NamesFourScenesBySolver) {
  const Ran two = run({"--table", "3", "--dry-run", "--out", "paper"});
  EXPECT_EQ(two.status, 0) << two.err;
  EXPECT_EQ(std::count(two.out.begin(), two.out.end(), '\n'), 8) << two.out;
  EXPECT_NE(two.out.find("simulation of hoist:dt=0.01 with best-first\n"), std::string::npos)
      << two.out;
  EXPECT_FALSE(std::filesystem::exists(file("paper")));
  const Ran all = run({"--table", "3", "--all-solvers", "--dry-run", "--out", "paper"});
  EXPECT_NE(all.out.find("simulation of net with projected-gauss-seidel\n"), std::string::npos)
      << all.out;
}

TEST_F(Paper, TheLimitIsADuration) {
  const Ran ran = run({"--table", "3", "--all-solvers", "--limit", "long", "--dry-run"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("--limit"), std::string::npos) << ran.err;
}

TEST_F(Paper, OutputThatCannotBeWrittenIsOneLineAndStatus4) {
  write_text(file("taken"), "");
  const Ran ran = run({"--table", "1", "--out", "taken"});
  EXPECT_EQ(ran.status, 4) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
}

}  // namespace
}  // namespace lcp
