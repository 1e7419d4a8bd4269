// The verb `sheet`, and `sweep` over patterns, through the command line.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

using Json = nlohmann::json;

class SheetVerb : public ProgramTest {
 protected:
  /// Three published instances, two solvers, into r.
  void SetUp() override {
    ASSERT_EQ(run({"generate", "published", "--count", "3", "--out", "p.json"}).status, 0);
    const Ran ran = run({"run", "--corpus", "p.json", "--solver", "lemke", "--solver",
                         "projected-gauss-seidel", "--solver", "best-first", "--out", "r"});
    ASSERT_EQ(ran.status, 0) << ran.err;
  }
};

TEST_F(SheetVerb, IsWrittenByARunAndAgainByItself) {
  for (const char* name : {"sheet.txt", "sheet.csv", "sheet.json", "chart.svg", "sheet-profile.svg",
                           "sheet-cumulative.svg", "sheet-accuracy.svg"})
    EXPECT_TRUE(exists(std::string("r/") + name)) << name;
  const std::string text = read_text(file("r/sheet.txt"));
  const Ran again = run({"sheet", "r"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.out, text);
  EXPECT_EQ(again.out, read_text(file("r/sheet.txt")));
}

TEST_F(SheetVerb, ItsMassIsThatOfTheRows) {
  const Json sheet = Json::parse(run({"sheet", "r", "--format", "json", "--out", "s"}).out);
  EXPECT_EQ(sheet, Json::parse(read_text(file("s/sheet.json"))));
  ASSERT_EQ(sheet.at("groups").size(), 1u);
  ASSERT_EQ(sheet.at("groups")[0].at("rows").size(), 3u);
  for (const Json& row : sheet.at("groups")[0].at("rows")) {
    int mass = 0;
    for (const char* part : {"solved", "failed", "trivial", "unsupported", "not_run"})
      mass += row.at(part).get<int>();
    EXPECT_EQ(mass, 3);
  }
}

TEST_F(SheetVerb, OfPivotsNamesTheRowsThatHaveNone) {
  const Ran ran = run({"sheet", "r", "--measure", "pivots", "--out", "s"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("Left out, since their rows count no pivots: projected-gauss-seidel."),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("(c + 1) / (best + 1)"), std::string::npos) << ran.out;
  EXPECT_TRUE(exists("s/sheet-pivots-profile.svg"));
  EXPECT_FALSE(exists("s/sheet.txt"));
}

TEST_F(SheetVerb, ReadsARunThatIsPacked) {
  const Ran before = run({"sheet", "r"});
  ASSERT_EQ(std::system(("xz " + file("r/rows.jsonl")).c_str()), 0);
  ASSERT_FALSE(exists("r/rows.jsonl"));
  const Ran packed = run({"sheet", "r"});
  EXPECT_EQ(packed.status, 0) << packed.err;
  EXPECT_EQ(packed.out, before.out);
  EXPECT_EQ(run({"table", "r"}).out, read_text(file("r/table.txt")));
  write_text(file("r/rows.jsonl.xz"), "no archive");
  expect_complaint({"sheet", "r"}, 3, "r/rows.jsonl.xz: xz: ");
}

TEST_F(SheetVerb, RefusesWhatItDoesNotKnow) {
  expect_complaint({"sheet", "nowhere"}, 3, "nowhere/rows.jsonl: cannot be read");
  expect_complaint({"sheet", "r", "--measure", "joy"}, 2, "time,pivots,nodes,factorisations");
  expect_complaint({"sheet", "r", "--corpus", "squat"}, 2, "the run has: published");
  expect_complaint({"sheet", "r", "--tolerance", "-1"}, 2, "--tolerance");
  write_text(file("f"), "");
  const Ran ran = run({"sheet", "r", "--out", "f/s"});
  EXPECT_EQ(ran.status, 4) << ran.err;
  EXPECT_NE(ran.err.find("f/s"), std::string::npos) << ran.err;
}

TEST_F(SheetVerb, ASweepOfAPatternSaysWhatHasNoLadder) {
  expect_complaint(
      {"sweep", "--option", "delta", "--corpus", "p.json", "--out", "s", "--solver", "lemke*"}, 2,
      "no solver of lemke* has a ladder for delta");
  const Ran ran = run({"sweep", "--option", "delta", "--corpus", "p.json", "--limit", "1", "--out",
                       "s", "--solver", "le*"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.err.find("run as they are, without a ladder to climb: lemke, lemke-revised"),
            std::string::npos)
      << ran.err;
  EXPECT_NE(read_text(file("s/sheet.txt")).find("lexicographic delta (over"), std::string::npos);
  expect_complaint({"sweep", "--option", "delta", "--corpus", "p.json", "--solver", "lemke"}, 2,
                   "lemke cannot sweep 'delta', it can: pivot");
}

}  // namespace
}  // namespace lcp
