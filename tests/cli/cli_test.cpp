// The program as its user meets it: status, the one line on stderr, files left behind.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

using Json = nlohmann::json;

class Cli : public ProgramTest {
 protected:
  Json table(const std::string& run_directory) {
    return Json::parse(run({"table", run_directory, "--format", "json"}).out).at("rows");
  }
  std::ptrdiff_t solvers_of_small() {
    const Json listed = Json::parse(run({"list", "suites", "--json"}).out);
    for (const Json& suite : listed.at("suites"))
      if (suite.at("name") == "small")
        return static_cast<std::ptrdiff_t>(suite.at("solvers").size());
    return 0;
  }
};

const std::vector<std::string> verbs = {
    "list",    "generate",    "solve",   "run",       "table",     "sweep",  "merge",
    "compare", "info",        "convert", "simulate",  "paper",     "replay", "shrink",
    "sheet",   "test-solver", "report",  "stability", "sufficient"};

TEST_F(Cli, HelpOfEveryVerbHasAnExampleOfIt) {
  for (const std::string& verb : verbs) {
    const Ran ran = run({verb, "--help"});
    EXPECT_EQ(ran.status, 0) << verb;
    EXPECT_NE(ran.out.find("Example:\n  lcpbench " + verb), std::string::npos) << ran.out;
  }
}

TEST_F(Cli, WithoutAVerbNamesThemAll) {
  const Ran ran = run({});
  for (const std::string& verb : verbs) expect_complaint(ran, 2, verb);
}

TEST_F(Cli, AnUnknownVerbIsAnsweredWithTheList) {
  expect_complaint({"slove"}, 2, "lcpbench: unknown verb 'slove'", "solve");
}

TEST_F(Cli, AnUnknownOptionIsAnsweredWithTheList) {
  expect_complaint({"run", "--sweet", "small"}, 2, "lcpbench run: ", "--sweet", "--suite");
}

TEST_F(Cli, UnknownNamesAreAnsweredWithTheList) {
  expect_complaint({"run", "--suite", "nosuch"}, 2, "lcpbench run: ", "'nosuch'", "default");
  expect_complaint({"run", "--suite", "small", "--solver", "nosuch"}, 2, "'nosuch'", "lemke");
  expect_complaint({"run", "--suite", "small", "--solver", "lemke:nosuch=1"}, 2, "'nosuch'",
                   "pivot");
  expect_complaint({"run", "--suite", "small", "--solver", "lemke:pivot=-1"}, 2, "pivot=-1",
                   "a real in");
  expect_complaint({"generate", "nosuch", "--out", "x.hdf5"}, 2, "'nosuch'", "published");
  expect_complaint({"sweep", "--solver", "best-first", "--option", "ties", "--suite", "small"}, 2,
                   "'ties'", "epsilon");
  expect_complaint({"test-solver", "nosuch"}, 2, "'nosuch'", "lemke");
  expect_complaint({"list", "nosuch"}, 2, "nosuch", "solvers", "families", "suites");
  expect_complaint({"table", ".", "--format", "nosuch"}, 2, "nosuch", "latex");
}

TEST_F(Cli, QuantitiesNeedTheirUnits) {
  expect_complaint({"run", "--suite", "small", "--timeout", "10"}, 2, "--timeout 10", "ms, s");
  expect_complaint({"run", "--suite", "small", "--memory", "2GB"}, 2, "--memory 2GB", "GiB");
  expect_complaint({"run", "--suite", "small", "--timeout", "-1s"}, 2, "--timeout -1s");
  expect_complaint({"run", "--suite", "small", "--timeout", "nans"}, 2, "--timeout nans");
}

TEST_F(Cli, MissingInputIsStatusThree) {
  expect_complaint({"solve", "nosuch.hdf5"}, 3, "lcpbench solve: ", "nosuch.hdf5");
  expect_complaint({"info", "nosuch.hdf5"}, 3, "lcpbench info: ", "nosuch.hdf5");
  expect_complaint({"convert", "nosuch.hdf5", "x.hdf5"}, 3, "nosuch.hdf5");
  expect_complaint({"run", "--corpus", "nosuch.hdf5"}, 3, "nosuch.hdf5");
  expect_complaint({"table", "nosuch"}, 3, "lcpbench table: ", "nosuch");
}

TEST_F(Cli, ATruncatedCorpusIsStatusThree) {
  ASSERT_EQ(run({"generate", "published", "--count", "1", "--out", "whole.hdf5"}).status, 0);
  const std::string bytes = read_text(file("whole.hdf5"));
  write_text(file("half.hdf5"), bytes.substr(0, bytes.size() / 2));
  expect_complaint({"info", "half.hdf5"}, 3, "half.hdf5");
}

TEST_F(Cli, EveryKindOfBadFileIsStatusThreeAndALineThatNamesIt) {
  for (const std::string name : {"x.hdf5", "x.json", "x.dat", "x.M.mtx"}) {
    write_text(file(name), "");
    expect_complaint({"info", name}, 3, name);
    write_text(file(name), std::string("\x7f\0\n junk", 8));
    expect_complaint({"info", name}, 3, name);
    std::filesystem::remove(file(name));
    std::filesystem::create_directory(file(name));
    expect_complaint({"info", name}, 3, name, "no readable instance");
    std::filesystem::remove(file(name));
  }
  write_text(file("nan.dat"), "2 0 2 2 2 2  1 nan 0 1  -1 -1\n");
  expect_complaint({"info", "nan.dat"}, 3, "nan.dat");
  write_text(file("wide.json"), R"({"M": [[1, 2, 3], [4, 5, 6]], "q": [1, 2]})");
  expect_complaint({"info", "wide.json"}, 3, "wide.json", "/M/0", "has 3 entries, expected 2");
  write_text(file("wide.M.mtx"), "%%MatrixMarket matrix array real general\n1 2\n1\n2\n");
  write_text(file("wide.q.mtx"), "%%MatrixMarket matrix array real general\n1 1\n1\n");
  expect_complaint({"info", "wide.M.mtx"}, 3, "wide.M.mtx", "1 x 2, expected a square matrix");
  write_text(file("noise.txt"), "");
  expect_complaint({"info", "noise.txt"}, 3, "unknown ending", ".hdf5", ".json", ".dat");
}

TEST_F(Cli, TheGoodFilesOfADirectoryAreReadAndTheBadOnesNamed) {
  write_text(file("good.json"), R"({"M": [[1]], "q": [-1]})");
  write_text(file("bad.json"), "{");
  const Ran ran = run({"info", ".", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(Json::parse(ran.out).at("instances").size(), 1u);
  EXPECT_EQ(ran.err.rfind("left out: ./bad.json: ", 0), 0u) << ran.err;
}

TEST_F(Cli, MalformedRowsAreStatusThreeWithTheirLine) {
  std::filesystem::create_directory(file("run"));
  write_text(file("run/rows.jsonl"), "{\"schema\": 1}\n{}\n");
  expect_complaint({"table", "run"}, 3, "rows.jsonl", "1");
}

TEST_F(Cli, OutputThatCannotBeWrittenIsStatusFour) {
  expect_complaint({"generate", "published", "--out", "no/such/place.hdf5"}, 4,
                   "lcpbench generate: ", "no/such/place.hdf5");
  write_text(file("in-the-way"), "");
  expect_complaint({"run", "--suite", "small", "--limit", "1", "--out", "in-the-way/run"}, 4,
                   "in-the-way/run");
}

TEST_F(Cli, AFullDiskUnderTheResultsIsStatusFour) {
  const Ran ran = run_program("/bin/sh", {"-c", LCPBENCH " list solvers >/dev/full"}, file("."));
  EXPECT_EQ(ran.status, 4);
  EXPECT_EQ(ran.err.rfind("lcpbench list: standard output: cannot write: ", 0), 0u) << ran.err;
}

TEST_F(Cli, WithoutGnuplotTheTableStillComesAndTheChartIsStatusFour) {
  const Ran ran = run_program(
      "/bin/sh",
      {"-c", "PATH=/nowhere " LCPBENCH " run --suite small --limit 1 --solver lemke --out r"},
      file("."));
  EXPECT_EQ(ran.status, 4);
  EXPECT_EQ(ran.out, read_text(file("r/table.txt")));
  EXPECT_NE(ran.out, "");
  EXPECT_NE(ran.err.find("gnuplot-nox"), std::string::npos) << ran.err;
}

TEST_F(Cli, ListsTellWhatThereIs) {
  const Json solvers = Json::parse(run({"list", "solvers", "--json"}).out).at("solvers");
  const auto named = [](const Json& list, const std::string& name) {
    return *std::find_if(list.begin(), list.end(),
                         [&](const Json& each) { return each.at("name") == name; });
  };
  const Json epsilon = named(named(solvers, "best-first").at("options"), "epsilon");
  EXPECT_EQ(epsilon.at("default"), "1e-09");
  EXPECT_GE(epsilon.at("accuracy_ladder").size(), 3u);
  const Json suites = Json::parse(run({"list", "suites", "--json"}).out).at("suites");
  EXPECT_GT(named(suites, "small").at("instances"), 20);
  const Json families = Json::parse(run({"list", "families", "--json"}).out).at("families");
  EXPECT_EQ(named(families, "squat-like").at("default_count"), 200);
  EXPECT_NE(run({"list", "solvers"}).out.find("speed against accuracy: "), std::string::npos);
}

TEST_F(Cli, ARunLeavesRowsTablesAndChartAndPrintsTheTable) {
  ASSERT_EQ(run({"generate", "published", "--count", "3", "--out", "small.json"}).status, 0);
  const Ran ran =
      run({"run", "--corpus", "small.json", "--solver", "lemke", "--solver", "best-first"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (const char* name : {"run.json", "rows.jsonl", "env.json", "table.txt", "table.csv",
                           "table.json", "chart.svg", "chart.gp", "chart.dat"})
    EXPECT_TRUE(exists(std::string("runs/small/") + name)) << name;
  EXPECT_EQ(ran.out, read_text(file("runs/small/table.txt")));
  EXPECT_EQ(ran.out, run({"table", "runs/small"}).out);
  const std::string rows = read_text(file("runs/small/rows.jsonl"));
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 3 * 2);
  EXPECT_EQ(ran.err.find('\r'), std::string::npos) << "a progress bar in a file";
  ASSERT_EQ(table("runs/small").size(), 2u);
  for (const Json& row : table("runs/small")) EXPECT_EQ(row.at("instances"), 3);
}

TEST_F(Cli, AnExistingDirectoryIsRefusedAndKept) {
  std::filesystem::create_directories(file("runs/small"));
  write_text(file("runs/small/rows.jsonl"), "precious\n");
  expect_complaint({"run", "--suite", "small"}, 2, "runs/small exists");
  EXPECT_EQ(read_text(file("runs/small/rows.jsonl")), "precious\n");
}

TEST_F(Cli, ADryRunPrintsThePairsAndWritesNothing) {
  const Ran ran = run({"run", "--suite", "small", "--limit", "1", "--dry-run"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 13 * solvers_of_small());
  EXPECT_NE(ran.out.find("lexicographic-pivot:delta=0\n"), std::string::npos);
  EXPECT_FALSE(exists("runs"));
}

TEST_F(Cli, AnAddedSolverStandsBesideThoseOfTheSuite) {
  const std::vector<std::string> words = {"run",   "--suite",   "small", "--limit",
                                          "1",     "--dry-run", "--add", "lexicographic:delta=1e-5",
                                          "--add", "lemke"};
  const Ran ran = run(words);
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 13 * (solvers_of_small() + 1));
  EXPECT_NE(ran.out.find("lexicographic:delta=1e-05\n"), std::string::npos);
}

TEST_F(Cli, TablesAreJudgedAnewAtAnotherTolerance) {
  ASSERT_EQ(run({"generate", "published", "--count", "8", "--out", "p.json"}).status, 0);
  ASSERT_EQ(run({"run", "--corpus", "p.json", "--solver", "lexicographic", "--out", "r"}).status,
            0);
  const Json as_run = table("r")[0];
  const Json anew =
      Json::parse(run({"table", "r", "--tolerance", "1e-300", "--format", "json"}).out)["rows"][0];
  EXPECT_EQ(as_run.at("tolerance"), 1e-6);
  EXPECT_EQ(anew.at("tolerance"), 1e-300);
  EXPECT_GT(as_run.at("success"), anew.at("success"));
  EXPECT_EQ(anew.at("verdicts").at("inaccurate"),
            as_run.at("success").get<int>() - anew.at("success").get<int>());
}

TEST_F(Cli, ASweepHasARowPerStepOfTheLadder) {
  ASSERT_EQ(run({"generate", "published", "--count", "1", "--out", "p.json"}).status, 0);
  const Ran ran = run(
      {"sweep", "--solver", "best-first", "--option", "e_max", "--corpus", "p.json", "--out", "s"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("best-first:e_max=0.001"), std::string::npos) << ran.out;
  EXPECT_EQ(table("s").size(), 4u);
  EXPECT_TRUE(exists("s/chart.svg"));
}

TEST_F(Cli, SolveTellsVerdictAndPivots) {
  ASSERT_EQ(run({"generate", "published", "--out", "p.hdf5"}).status, 0);
  const Ran ran = run({"solve", "p.hdf5#published/kostreva-1", "--solver", "lemke", "--solver",
                       "lexicographic:delta=1e-10,pivot=1e-12", "--trace", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json results = Json::parse(ran.out).at("results");
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].at("verdict"), "cycle");
  EXPECT_EQ(results[1].at("verdict"), "solved");
  EXPECT_EQ(results[1].at("trace").size(), 4u);  // Kostreva 1979: z = (1, 1, 1) / 3 in 4 pivots
  EXPECT_EQ(results[1].at("trace")[0].at("entering"), "z0");
  EXPECT_NEAR(results[1].at("z")[2].get<double>(), 1.0 / 3, 1e-15);
}

TEST_F(Cli, InfoDescribesAndConvertKeepsAnInstance) {
  ASSERT_EQ(run({"generate", "published", "--count", "2", "--out", "p.hdf5"}).status, 0);
  const auto described = [&](const std::string& where) {
    return Json::parse(run({"info", where, "--json"}).out).at("instances");
  };
  const std::string text = run({"info", "p.hdf5"}).out;
  // kostreva-1: q = (-1, -1, -1), and three pivots after Step 0. In the first, z_3 meets w_1 at 0 and
  // z0 at 1, so that one row is left; in the second, two rows meet at 0.
  EXPECT_NE(text.find("tied in q              3\ntied at first pivots   1 2 1\n"),
            std::string::npos)
      << text;
  const Json before = described("p.hdf5");
  EXPECT_EQ(before[0].at("tied at first pivots"), (Json{1, 2, 1}));
  ASSERT_EQ(before.size(), 2u);
  EXPECT_EQ(before[0].at("n"), 3);
  const std::string one = "p.hdf5#" + before[0].at("name").get<std::string>();
  ASSERT_EQ(run({"convert", one, "one.hdf5"}).status, 0);
  EXPECT_EQ(described("one.hdf5")[0].at("sha256"), before[0].at("sha256"));
}

TEST_F(Cli, ForeignContactsTakeTheirDirectionsFromTheCommandLine) {
  write_text(file("one.dat"), "3 1  0 3 3 3 3  15 -1 -2 -1 14 1 -2 1 16  -1 2 3  0.1\n");
  const auto rows = [&](const std::vector<std::string>& arguments) {
    return Json::parse(run(arguments).out).at("instances")[0].at("n");
  };
  EXPECT_EQ(rows({"info", "one.dat", "--json"}), 10);
  EXPECT_EQ(rows({"info", "one.dat", "--directions", "4", "--json"}), 6);
  ASSERT_EQ(run({"convert", "one.dat", "one.json", "--directions", "6"}).status, 0);
  ASSERT_EQ(run({"convert", "one.json", "one.hdf5"}).status, 0);
  EXPECT_EQ(rows({"info", "one.hdf5", "--json"}), 8);
  EXPECT_NE(run({"solve", "one.dat", "--directions", "4", "--solver", "best-first"})
                .out.find("one (n = 6), best-first: solved"),
            std::string::npos);
  EXPECT_EQ(run({"run", "--corpus", "one.dat", "--directions", "2", "--dry-run"}).status, 0);
  expect_complaint({"info", "one.dat", "--directions", "3"}, 2, "--directions is 3", "even");
  expect_complaint({"convert", "one.dat", "two.dat"}, 2, "two.dat", ".hdf5");
  expect_complaint({"convert", "one.dat", "one.M.mtx"}, 4, "one.M.mtx", "friction blocks");
}

TEST_F(Cli, TestSolverTellsEveryLaw) {
  const Ran ran = run({"test-solver", "best-first"});
  EXPECT_EQ(ran.status, 0) << ran.out;
  EXPECT_NE(ran.out.find("permutation"), std::string::npos);
  EXPECT_EQ(ran.out.find("FAIL"), std::string::npos);
}

}  // namespace
}  // namespace lcp
