// `lcpbench report`, and that the commands on its page do what they say.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

using Json = nlohmann::json;

class Report : public ProgramTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(file("build/release"));
    std::filesystem::create_symlink(LCPBENCH, file("build/release/lcpbench"));
  }
  Ran shell(const std::string& command) {
    return run_program("/bin/sh", {"-c", command}, directory());
  }
  Json data(const std::string& page) {
    const std::string text = read_text(file(page));
    const std::string mark = "id=\"data\">";
    const std::size_t begin = text.find(mark) + mark.size();
    return Json::parse(text.substr(begin, text.find("</script>", begin) - begin));
  }
};

/// What a row's column holds: of a list, or of one that is stored once.
Json column(const Json& data, const char* name, std::size_t row) {
  const Json& list = data.at("rows").at(name);
  return list.is_object() ? list.at("all") : list.at(row);
}

/// What a row names by its place in one of the lists.
const Json& of_row(const Json& data, const char* list, const char* name, std::size_t row) {
  return data.at(list).at(column(data, name, row).get<std::size_t>());
}

/// What the page shows as the command that follows the pivots of a row.
std::string trace_command(const Json& data, std::size_t row, const Json& command) {
  const Json& variant = of_row(data, "variants", "variant", row);
  const auto text = [](const Json& value) { return value.get<std::string>(); };
  return text(command.at("before")) + text(data.at("program")) + " solve " +
         text(command.at("where")) + text(variant.at("arguments")) + " --trace" +
         text(command.at("after"));
}

/// How `solve` begins what it prints of a row.
std::string first_line(const Json& data, std::size_t row) {
  const Json& instance = of_row(data, "instances", "instance", row);
  const std::string size = std::to_string(instance.at("n").get<long>());
  return instance.at("name").get<std::string>() + " (n = " + size + "), " +
         of_row(data, "variants", "variant", row).at("solver").get<std::string>() + ": " +
         of_row(data, "verdicts", "verdict", row).at("name").get<std::string>();
}

TEST_F(Report, CommandsOfASuiteDrawTheInstanceAgainAndEndAsTheRowDid) {
  ASSERT_EQ(
      run({"run", "--suite", "small", "--every", "7", "--solver", "lemke", "--out", "r"}).status,
      0);
  const Ran ran = run({"report", "r"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json page = data("r/report.html");
  std::map<std::string, std::size_t> last_of_corpus;
  for (std::size_t row = 0; row < page["rows"]["count"]; ++row)
    last_of_corpus[of_row(page, "instances", "instance", row)["corpus"]] = row;
  EXPECT_GT(last_of_corpus.size(), 10u);
  for (const auto& [corpus, row] : last_of_corpus) {
    const Json& instance = of_row(page, "instances", "instance", row);
    const Ran traced = shell(trace_command(page, row, instance["command"]));
    EXPECT_EQ(traced.status, 0) << traced.err;
    EXPECT_EQ(traced.out.find(first_line(page, row)), 0u) << first_line(page, row) << "\n"
                                                          << traced.out.substr(0, 200);
  }
}

TEST_F(Report, CommandsOfCorporaFindTheInstanceAmongThem) {
  ASSERT_EQ(run({"generate", "stack:bodies=2", "--count", "2", "--out", "a file.hdf5"}).status, 0);
  std::filesystem::create_directory(file("more"));
  ASSERT_EQ(run({"generate", "murty", "--count", "2", "--out", "more/b.hdf5"}).status, 0);
  ASSERT_EQ(run({"run", "--corpus", "a file.hdf5", "--corpus", "more", "--solver", "best-first",
                 "--solver", "lemke", "--start", "two-step", "--out", "r"})
                .status,
            0);
  ASSERT_EQ(run({"report", "r", "--out", "page.html"}).status, 0);
  const Json page = data("page.html");
  ASSERT_EQ(page["rows"]["count"], 8);
  for (const std::size_t row : {0, 7}) {
    const Json& instance = of_row(page, "instances", "instance", row);
    const Ran traced = shell(trace_command(page, row, instance["command"]));
    EXPECT_EQ(traced.status, 0) << traced.err;
    EXPECT_NE(traced.out.find(instance["name"].get<std::string>() + " (n = "), std::string::npos)
        << traced.out.substr(0, 200);
    EXPECT_NE(traced.out.find("[two-step]"), std::string::npos) << traced.out.substr(0, 200);
  }
}

TEST_F(Report, CommandsOfADumpSimulateTheSceneAgain) {
  ASSERT_EQ(
      run({"simulate", "squat", "--duration", "30ms", "--every", "10", "--dump", "dump"}).status,
      0);
  ASSERT_EQ(run({"run", "--corpus", "dump", "--solver", "lemke", "--out", "r"}).status, 0);
  ASSERT_EQ(run({"report", "r"}).status, 0);
  const Json page = data("r/report.html");
  const std::size_t row = page["rows"]["count"].get<std::size_t>() - 1;
  const Json& instance = of_row(page, "instances", "instance", row);
  ASSERT_TRUE(instance.contains("simulated")) << instance;
  for (int time = 0; time < 2; ++time) {  // The second finds what the first simulated.
    const Ran traced = shell(trace_command(page, row, instance["simulated"]));
    EXPECT_EQ(traced.status, 0) << traced.err;
    EXPECT_NE(traced.out.find(first_line(page, row)), std::string::npos)
        << first_line(page, row) << "\n"
        << traced.out.substr(0, 600);
  }
}

TEST_F(Report, ShowsPicturesAndTextsOfOtherResults) {
  ASSERT_EQ(run({"generate", "murty", "--count", "1", "--out", "m.hdf5"}).status, 0);
  ASSERT_EQ(run({"run", "--corpus", "m.hdf5", "--solver", "lemke", "--out", "r"}).status, 0);
  std::filesystem::create_directory(file("r/pictures"));
  std::filesystem::create_directory(file("more"));
  write_text(file("r/pictures/squat.svg"), "<svg/>");
  write_text(file("more/table.txt"), "a < b\n");
  ASSERT_EQ(run({"report", "r", "--attach", "more"}).status, 0);
  const std::string page = read_text(file("r/report.html"));
  EXPECT_NE(page.find("data:image/svg+xml;base64,PHN2Zy8+"), std::string::npos);
  EXPECT_NE(page.find("<figcaption>squat.svg</figcaption>"), std::string::npos);
  EXPECT_NE(page.find("a &lt; b"), std::string::npos);
}

TEST_F(Report, RefusesWhatItCannotReadOrWrite) {
  expect_complaint(run({"report"}), 2, "DIR is required");
  expect_complaint(run({"report", "none"}), 3, "none/rows.jsonl: cannot be read");
  std::filesystem::create_directory(file("packed"));
  write_text(file("packed/rows.jsonl.xz"), "");
  expect_complaint(run({"report", "packed"}), 3, "packed/rows.jsonl.xz: ");
  std::filesystem::create_directory(file("empty"));
  write_text(file("empty/rows.jsonl"), "");
  expect_complaint(run({"report", "empty"}), 3, "holds no finished row");
  ASSERT_EQ(run({"generate", "murty", "--count", "1", "--out", "m.hdf5"}).status, 0);
  ASSERT_EQ(run({"run", "--corpus", "m.hdf5", "--solver", "lemke", "--out", "r"}).status, 0);
  expect_complaint(run({"report", "r", "--out", "nowhere/page.html"}), 4, "nowhere/page.html");
  expect_complaint(run({"report", "r", "--attach", "empty"}), 3, "holds no picture");
  expect_complaint(run({"report", "r", "--attach", "none"}), 3, "none: no such directory");
  expect_complaint(run({"report", "r", "--frobnicate"}), 2, "allowed are: DIR, --out, --attach");
  EXPECT_FALSE(std::filesystem::exists(file("r/report.html")));
}

}  // namespace
}  // namespace lcp
