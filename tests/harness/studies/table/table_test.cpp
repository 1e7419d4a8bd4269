#include "harness/studies/table/table.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "tests/harness/made_up_records.h"

namespace lcp {
namespace {

/// A record with a verdict that belongs to its claim, or that the runner decided.
Record with_verdict(const std::string& instance, Verdict verdict) {
  if (verdict == Verdict::solved) return solved(instance, "a", 1e-12);
  if (verdict == Verdict::wrong) return made_up(instance, "a", verdict, Claim::solved, 1);
  if (decided_by_runner(verdict)) return ended(instance, "a", verdict);
  const std::map<Verdict, Claim> claims = {{Verdict::ray, Claim::ray},
                                           {Verdict::exhausted, Claim::exhausted},
                                           {Verdict::infeasible, Claim::infeasible},
                                           {Verdict::false_infeasible, Claim::infeasible},
                                           {Verdict::cycle, Claim::cycle},
                                           {Verdict::limit, Claim::limit},
                                           {Verdict::singular, Claim::singular},
                                           {Verdict::unsupported, Claim::unsupported}};
  return made_up(instance, "a", verdict, claims.at(verdict), 1);
}

/// One record of every verdict a run may write, and a trivial success.
std::vector<Record> one_of_each() {
  std::vector<Record> records;
  for (const Verdict verdict : all_values<Verdict>())
    if (verdict != Verdict::inaccurate)
      records.push_back(with_verdict("c/" + to_string(verdict), verdict));
  records.push_back(solved("c/trivial", "a", 0));
  records.back().trivial = true;
  records.back().accuracy->zero_residual = 0;
  return records;
}

TEST(Table, PutsEveryVerdictIntoThePapersColumns) {
  const Table table = make_table(one_of_each());
  ASSERT_EQ(table.rows.size(), 1u);
  const TableRow& row = table.rows.front();
  EXPECT_EQ(row.success, 1);
  EXPECT_EQ(row.no_solution, 4);  // ray, exhausted, infeasible, false-infeasible
  EXPECT_EQ(row.cycle, 3);        // cycle, limit, timeout
  EXPECT_EQ(row.error, 4);        // wrong, singular, crash, memory
  EXPECT_EQ(row.wrong, 1);
  EXPECT_EQ(row.unsupported, 1);
  EXPECT_EQ(row.not_run, 1);
  EXPECT_EQ(row.trivial, 1);
  EXPECT_EQ(row.failure, row.no_solution + row.cycle + row.error);
  EXPECT_EQ(row.success + row.failure + row.unsupported + row.not_run + row.trivial, row.instances);
}

TEST(Table, KeepsItsSumsWhenJudgedAnew) {
  for (const double tolerance : {1e-15, 1e-9, 1e-3, 2.0}) {
    const TableRow row = make_table(one_of_each(), tolerance).rows.front();
    EXPECT_EQ(row.failure, row.no_solution + row.cycle + row.error);
    EXPECT_EQ(row.success + row.failure + row.unsupported + row.not_run + row.trivial,
              row.instances);
  }
}

TEST(Table, CountsAFailureOnATrivialInstanceAsFailure) {
  Record crash = ended("c/0", "a", Verdict::crash);
  crash.trivial = true;
  const TableRow row = make_table({crash}).rows.front();
  EXPECT_EQ(row.trivial, 0);
  EXPECT_EQ(row.failure, 1);
}

TEST(Table, TakesTimesAndResidualsOfTheSolvedAlone) {
  std::vector<Record> records = {solved("c/0", "a", 1e-14), solved("c/1", "a", 1e-12),
                                 solved("c/2", "a", 1e-10),
                                 made_up("c/3", "a", Verdict::ray, Claim::ray, 7)};
  records[0].times_ns = {3'000'000};
  records[1].times_ns = {1'000'000};
  records[2].times_ns = {2'000'000};
  records[3].times_ns = {900'000'000};
  const TableRow row = make_table(records).rows.front();
  EXPECT_DOUBLE_EQ(row.time_median_ms.value(), 2);
  EXPECT_DOUBLE_EQ(row.residual_median.value(), 1e-12);
  EXPECT_DOUBLE_EQ(row.residual_max.value(), 1e-10);
}

TEST(Table, TakesTheLargestResidualOfAll) {
  std::vector<Record> records;
  for (int i = 1; i <= 40; ++i) records.push_back(solved("c/" + std::to_string(i), "a", i * 1e-9));
  EXPECT_DOUBLE_EQ(make_table(records).rows.front().residual_max.value(), 40e-9);
}

TEST(Table, CountsInstancesThatWereRestartedHoweverOften) {
  std::vector<Record> records;
  for (const Index restarts : {0, 1, 2, 1, 7}) {
    records.push_back(solved("c/" + std::to_string(records.size()), "a", 0));
    records.back().work.restarts = restarts;
  }
  EXPECT_EQ(make_table(records).rows.front().restarted, 4);
}

TEST(Table, TellsTheMostJobsOfAnyOfItsRows) {
  std::vector<Record> records = {solved("c/0", "a", 0), solved("c/1", "a", 0),
                                 solved("c/2", "a", 0)};
  records[0].jobs = 2;
  records[1].jobs = 4;
  EXPECT_EQ(make_table(records).jobs, 4);
}

TEST(Table, TakesMeansOfWorkOverRunsThatReturned) {
  std::vector<Record> records = {solved("c/0", "a", 0),
                                 made_up("c/1", "a", Verdict::ray, Claim::ray, 1),
                                 ended("c/2", "a", Verdict::timeout)};
  records[1].work.pivots = 40;
  const TableRow row = make_table(records).rows.front();
  EXPECT_DOUBLE_EQ(row.pivots.value(), 25);
  EXPECT_DOUBLE_EQ(row.nodes.value(), 5);
}

TEST(Table, SaysHowItsSolvesStartedUnlessCold) {
  Record record = solved("c/0", "a", 0);
  EXPECT_EQ(render(make_table({record}), TableFormat::text).find("Start"), std::string::npos);
  record.start = "two-step";
  EXPECT_NE(render(make_table({record}), TableFormat::text)
                .find("Start: two-step; pivots before it are not counted."),
            std::string::npos);
  EXPECT_EQ(make_table({record, solved("c/0", "a", 0)}).start, "cold, two-step");
}

/// Row `start` of what solver a did on instance c/`number`, in `ms`.
Record started(const std::string& start, int number, Verdict verdict, int ms) {
  Record record = with_verdict("c/" + std::to_string(number), verdict);
  record.start = start;
  record.times_ns = {ms * 1'000'000};
  return record;
}

TEST(Table, HasARowPerStartWithWhatItGainsAndLosesAgainstCold) {
  const std::vector<Record> records = {
      started("cold", 0, Verdict::solved, 4),     started("previous", 0, Verdict::solved, 1),
      started("cold", 1, Verdict::ray, 1),        started("previous", 1, Verdict::solved, 9),
      started("cold", 2, Verdict::solved, 2),     started("previous", 2, Verdict::singular, 1),
      started("cold", 3, Verdict::solved, 2),     started("previous", 3, Verdict::solved, 1),
      started("cold", 4, Verdict::solved, 2),     started("previous", 4, Verdict::solved, 2),
      started("previous", 5, Verdict::solved, 7), started("two-step", 0, Verdict::unsupported, 1)};
  const Table table = make_table(records);
  EXPECT_TRUE(table.several_starts);
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].label, "a [cold]");
  EXPECT_EQ(table.rows[0].success, 4);
  EXPECT_FALSE(table.rows[0].gained || table.rows[0].lost || table.rows[0].time_ratio);
  const TableRow& previous = table.rows[1];
  EXPECT_EQ(previous.start, "previous");
  EXPECT_EQ(previous.label, "a [previous]");
  EXPECT_EQ(previous.success, 5);
  EXPECT_EQ(previous.gained, 1);
  EXPECT_EQ(previous.lost, 1);
  EXPECT_EQ(previous.time_ratio, 0.5) << "of 0.25, 0.5 and 1";
  EXPECT_EQ(table.rows[2].unsupported, 1);
  EXPECT_EQ(table.rows[2].lost, 0) << "what does not apply loses nothing";
}

TEST(Table, OfOneStartSaysNothingOfGains) {
  const Table table = make_table({started("previous", 0, Verdict::solved, 1)});
  EXPECT_FALSE(table.several_starts);
  EXPECT_EQ(table.rows.front().label, "a");
  EXPECT_EQ(render(table, TableFormat::text).find("gained"), std::string::npos);
  EXPECT_EQ(render(table, TableFormat::latex).find("gained"), std::string::npos);
}

TEST(Table, JudgesGainsAtItsOwnTolerance) {
  std::vector<Record> records = {started("cold", 0, Verdict::solved, 1),
                                 started("previous", 0, Verdict::solved, 1)};
  records[0].accuracy->residual = 1e-8;
  EXPECT_EQ(make_table(records).rows[1].gained, 0);
  EXPECT_EQ(make_table(records, 1e-10).rows[1].gained, 1);
}

TEST(Table, AveragesContactsOverInstancesWithContact) {
  std::vector<Record> records = {solved("c/0", "a", 0), solved("c/1", "a", 0),
                                 solved("c/2", "a", 0)};
  records[1].contacts = 6;
  records[1].active_contacts.reset();
  records[2].contacts = 0;
  records[2].active_contacts.reset();
  const TableRow row = make_table(records).rows.front();
  EXPECT_DOUBLE_EQ(row.contacts.value(), 4.5);
  EXPECT_DOUBLE_EQ(row.active.value(), 2);
}

TEST(Table, LeavesEmptyWhatWasNotMeasured) {
  Record record = ended("c/0", "a", Verdict::timeout);
  record.contacts = 0;
  record.active_contacts.reset();
  const TableRow row = make_table({record}).rows.front();
  EXPECT_FALSE(row.contacts || row.active || row.pivots || row.nodes || row.time_median_ms ||
               row.residual_median || row.residual_max);
}

TEST(Table, JudgedBelowTheRunsToleranceCallsAPassedAnswerInaccurate) {
  const Record record = solved("c/0", "a", 1e-8);
  EXPECT_EQ(judged(record, Acceptance{.tolerance = 1e-7}).verdict, Verdict::solved);
  EXPECT_EQ(judged(record, Acceptance{.tolerance = 1e-9}).verdict, Verdict::inaccurate);
  const TableRow row = make_table({record}, 1e-9).rows.front();
  EXPECT_EQ(row.error, 1);
  EXPECT_EQ(row.wrong, 0);
}

TEST(Table, JudgedAboveTheRunsToleranceAcceptsWhatWasWrong) {
  const Record record = made_up("c/0", "a", Verdict::wrong, Claim::solved, 1e-4);
  EXPECT_EQ(judged(record, Acceptance{.tolerance = 1e-5}).verdict, Verdict::wrong);
  EXPECT_EQ(judged(record, Acceptance{.tolerance = 1e-3}).verdict, Verdict::solved);
}

TEST(Table, JudgedAnewNeverTurnsAClaimOfFailureIntoSuccess) {
  const Record record = made_up("c/0", "a", Verdict::ray, Claim::ray, 1e-4);
  const TableRow row = make_table({record}, 1e-3).rows.front();
  EXPECT_EQ(row.no_solution, 1);
  EXPECT_EQ(row.unclaimed, 1);
}

TEST(Table, JudgedAnewFindsTheInstancesThatZeroSolves) {
  Record record = solved("c/0", "a", 1e-12);
  record.accuracy->zero_residual = 1e-4;
  EXPECT_EQ(make_table({record}).rows.front().trivial, 0);
  EXPECT_EQ(make_table({record}, 1e-3).rows.front().trivial, 1);
}

TEST(Table, ANanResidualIsNeverSolved) {
  EXPECT_EQ(judged(made_up("c/0", "a", Verdict::wrong, Claim::solved, NAN),
                   Acceptance{.tolerance = 1e300})
                .verdict,
            Verdict::wrong);
}

TEST(Table, RefusesRowsOfDifferentTolerances) {
  std::vector<Record> records = {solved("c/0", "a", 0), solved("c/1", "a", 0)};
  records[1].tolerance = 1e-9;
  EXPECT_THROW(make_table(records), std::invalid_argument);
  EXPECT_EQ(make_table(records, 1e-9).rows.front().success, 2);
}

TEST(Table, HasARowPerCorpusAndSolverInOrderOfAppearance) {
  const Table table = make_table(
      {solved("y/0", "b", 0), solved("y/0", "a", 0), solved("x/0", "b", 0), solved("y/1", "b", 0)});
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].corpus + table.rows[0].solver, "yb");
  EXPECT_EQ(table.rows[0].instances, 2);
  EXPECT_EQ(table.rows[1].corpus + table.rows[1].solver, "ya");
  EXPECT_EQ(table.rows[2].corpus + table.rows[2].solver, "xb");
}

TEST(Table, SpellsOutDefaultsInWhichSettingsOfOneRowDiffer) {
  std::vector<Record> records = {solved("c/0", "a", 0), solved("c/0", "a:delta=0", 0),
                                 solved("c/0", "b", 0)};
  records[0].options = {{"delta", "1e-08"}, {"scale", "off"}};
  records[1].options = {{"delta", "0"}, {"scale", "off"}};
  records[2].options = {{"delta", "1e-08"}};
  const std::map<std::string, std::string> names = labels(records);
  EXPECT_EQ(names.at("a"), "a:delta=1e-08");
  EXPECT_EQ(names.at("a:delta=0"), "a:delta=0");
  EXPECT_EQ(names.at("b"), "b");
}

TEST(TableRendering, JsonHasOneObjectPerRowWithTheListedKeys) {
  const nlohmann::json json =
      nlohmann::json::parse(render(make_table(one_of_each()), TableFormat::json));
  ASSERT_EQ(json.at("rows").size(), 1u);
  for (const char* key :
       {"solver",         "corpus",          "mode",        "instances", "success",   "failure",
        "no_solution",    "cycle",           "error",       "wrong",     "unclaimed", "unsupported",
        "not_run",        "contacts",        "active",      "pivots",    "nodes",     "trivial",
        "time_median_ms", "residual_median", "residual_max"})
    EXPECT_TRUE(json["rows"][0].contains(key)) << key;
  EXPECT_EQ(json["rows"][0]["mode"], "corpus");
  EXPECT_EQ(json["rows"][0]["success"], 1);
  EXPECT_EQ(json["rows"][0]["verdicts"]["ray"], 1);
}

TEST(TableRendering, JsonSaysNullForWhatWasNotMeasured) {
  const nlohmann::json json = nlohmann::json::parse(
      render(make_table({ended("c/0", "a", Verdict::crash)}), TableFormat::json));
  EXPECT_TRUE(json["rows"][0]["time_median_ms"].is_null());
  EXPECT_TRUE(json["rows"][0]["pivots"].is_null());
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(TableRendering, CsvQuotesASpellingWithCommas) {
  const std::string spelling = "a:x=1,y=2";
  const std::vector<std::string> csv =
      lines(render(make_table({solved("c/0", spelling, 0)}), TableFormat::csv));
  ASSERT_EQ(csv.size(), 2u);
  EXPECT_EQ(csv[1].substr(0, 14), "\"a:x=1,y=2\",c,");
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_EQ(commas(csv[1]) - 1, commas(csv[0]));
}

TEST(TableRendering, TextFitsATerminalAndExplainsItsColumns) {
  std::vector<Record> records;
  for (const char* solver : {"lexicographic-pivot:delta=0.0001", "best-first"})
    for (int i = 0; i < 3; ++i) records.push_back(solved("c/" + std::to_string(i), solver, 1e-15));
  const std::string text = render(make_table(records), TableFormat::text);
  for (const std::string& line : lines(text)) EXPECT_LE(line.size(), 100u) << line;
  for (const char* heading : {"solved", "failed", "no sol", "cycle", "error", "resid"})
    EXPECT_NE(text.find(std::string("\n  ") + heading), std::string::npos) << heading;
  EXPECT_NE(text.find("c: 3 instances, 3.0 contacts, 2.0 active"), std::string::npos);
}

TEST(TableRendering, TextTellsToleranceAndJobsThatDisturbTimes) {
  Record record = solved("c/0", "a", 0);
  EXPECT_EQ(render(make_table({record}), TableFormat::text).find("jobs"), std::string::npos);
  record.jobs = 4;
  const std::string text = render(make_table({record}, 1e-9), TableFormat::text);
  EXPECT_NE(text.find("at most 1e-09"), std::string::npos);
  EXPECT_NE(text.find("4 jobs"), std::string::npos);
}

TEST(TableRendering, EveryFormatTellsTheStart) {
  Record record = solved("c/0", "a", 0);
  record.start = "two-step";
  for (const TableFormat format :
       {TableFormat::text, TableFormat::csv, TableFormat::json, TableFormat::latex})
    EXPECT_NE(render(make_table({record}), format).find("two-step"), std::string::npos);
}

TEST(TableRendering, TextSaysWhereASolverLacksInstances) {
  const Table table =
      make_table({solved("c/0", "a", 0), solved("c/1", "a", 0), solved("c/0", "b", 0)});
  EXPECT_NE(render(table, TableFormat::text).find("only 1 with b"), std::string::npos);
}

TEST(TableRendering, LatexHasAColumnPerSolverAndEscapesNames) {
  const Table table = make_table({solved("c/0", "a:max_nodes=2", 0), solved("c/0", "b", 0)});
  const std::string latex = render(table, TableFormat::latex);
  EXPECT_NE(latex.find("\\begin{tabular}{l|rr}"), std::string::npos);
  EXPECT_NE(latex.find("max\\_nodes=2"), std::string::npos);
  EXPECT_NE(latex.find("\nsuccess & 1 & 1 \\\\\n"), std::string::npos);
  EXPECT_NE(latex.find("\n\\quad no solution & 0 & 0 \\\\\n"), std::string::npos);
}

}  // namespace
}  // namespace lcp
