#include "harness/studies/sheet/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/runs/run_directory.h"
#include "harness/studies/table/table.h"
#include "tests/harness/made_up_records.h"

namespace lcp {
namespace {

Record timed(Record record, double ms) {
  record.times_ns = {static_cast<std::int64_t>(1e6 * ms)};
  return record;
}

Record solved_in(const std::string& instance, const std::string& solver, double ms,
                 double residual) {
  return timed(solved(instance, solver, residual), ms);
}

/// Times in ms:        c/0   c/1   c/2   c/3
///                 a     1     2     4   ray
///                 b     2     1     8   ray
///                 d     4     -     2   timeout     (-: unsupported)
/// Least                 1     1     2   none
std::vector<Record> three_solvers_on_four_instances() {
  return {solved_in("c/0", "a", 1, 1e-14),
          solved_in("c/0", "b", 2, 1e-12),
          solved_in("c/0", "d", 4, 1e-9),
          solved_in("c/1", "a", 2, 1e-8),
          solved_in("c/1", "b", 1, 1e-12),
          ended("c/1", "d", Verdict::unsupported),
          solved_in("c/2", "a", 4, 1e-7),
          solved_in("c/2", "b", 8, 0),
          solved_in("c/2", "d", 2, 1e-9),
          made_up("c/3", "a", Verdict::ray, Claim::ray, 1),
          made_up("c/3", "b", Verdict::ray, Claim::ray, 1),
          ended("c/3", "d", Verdict::timeout)};
}

const Group& only_group(const Sheet& sheet) {
  EXPECT_EQ(sheet.groups.size(), 1u);
  return sheet.groups.front();
}

TEST(Sheet, ProfilesAreSharesWithinARatioOfTheBest) {
  const Sheet sheet = make_sheet(three_solvers_on_four_instances());
  const Group& group = only_group(sheet);
  ASSERT_EQ(group.rows.size(), 3u);
  const Curve &a = group.rows[0].profile, &b = group.rows[1].profile, &d = group.rows[2].profile;
  EXPECT_EQ(a.reached, (std::vector<double>{1, 2, 2}));
  EXPECT_DOUBLE_EQ(a.share(1), 0.25);
  EXPECT_DOUBLE_EQ(a.share(1.99), 0.25);
  EXPECT_DOUBLE_EQ(a.share(2), 0.75);
  EXPECT_EQ(b.reached, (std::vector<double>{1, 2, 4}));
  EXPECT_EQ(d.reached, (std::vector<double>{1, 4}));
  EXPECT_EQ(group.rows[0].best, 1);
  EXPECT_EQ(group.rows[2].best, 1);
}

TEST(Sheet, WhatIsUnsupportedLeavesTheDenominatorAndWhatNobodySolvesStays) {
  const Sheet sheet = make_sheet(three_solvers_on_four_instances());
  const Group& group = only_group(sheet);
  EXPECT_EQ(group.rows[0].profile.counted, 4);
  EXPECT_EQ(group.rows[2].profile.counted, 3);
  EXPECT_DOUBLE_EQ(group.rows[2].profile.share(1), 1.0 / 3);
  EXPECT_DOUBLE_EQ(group.rows[0].profile.unreached(), 0.25);
  EXPECT_DOUBLE_EQ(group.rows[0].profile.share(1e300), 0.75);
  EXPECT_EQ(group.unsolved_by_all, 1);
  EXPECT_EQ(group.instances, 4);
}

TEST(Sheet, ProfilesDependOnTheSetOfSolvers) {
  std::vector<Record> records = three_solvers_on_four_instances();
  std::erase_if(records, [](const Record& record) { return record.solver == "d"; });
  const Sheet sheet = make_sheet(records);
  EXPECT_EQ(only_group(sheet).rows[0].profile.reached, (std::vector<double>{1, 1, 2}));
}

TEST(Sheet, TheShiftIsTheMedianOfTheBestTimes) {
  const Sheet sheet = make_sheet(three_solvers_on_four_instances());
  const Group& group = only_group(sheet);
  EXPECT_DOUBLE_EQ(group.shift, 1);  // of 1, 1, 2
  const SheetRow& a = group.rows[0];
  const double mean = std::cbrt(2.0 * 3 * 5) - 1, best = std::cbrt(2.0 * 2 * 3) - 1;
  EXPECT_NEAR(a.shifted_mean.value(), mean, 1e-14);
  EXPECT_NEAR(a.slowdown.value(), mean / best, 1e-14);
  const SheetRow& d = group.rows[2];  // on c/0 and c/2 alone
  EXPECT_NEAR(d.slowdown.value(), (std::sqrt(5.0 * 3) - 1) / (std::sqrt(2.0 * 3) - 1), 1e-14);
}

TEST(Sheet, CumulativeCurvesAreJudgedAnewAtEachAccuracy) {
  SheetOptions options;
  options.accuracies = {1e-3, 1e-9, 1e-13};
  std::vector<Record> records = three_solvers_on_four_instances();
  records[9] = timed(made_up("c/3", "a", Verdict::wrong, Claim::solved, 1e-4), 16);
  const Sheet sheet = make_sheet(records, options);
  const SheetRow& a = only_group(sheet).rows[0];
  EXPECT_EQ(a.within[0].reached, (std::vector<double>{1, 2, 4, 16}));
  EXPECT_EQ(a.within[1].reached, (std::vector<double>{1}));
  EXPECT_EQ(a.within[1].counted, 4);
  EXPECT_EQ(only_group(sheet).rows[1].within[2].reached, (std::vector<double>{8}));
}

TEST(Sheet, WhatZSolvesByBeingZeroLeavesTheCurveOfThatAccuracy) {
  SheetOptions options;
  options.accuracies = {1e-3, 1e-6};
  std::vector<Record> records = three_solvers_on_four_instances();
  records[0].accuracy->zero_residual = 1e-4;
  const Sheet sheet = make_sheet(records, options);
  const SheetRow& a = only_group(sheet).rows[0];
  EXPECT_EQ(a.mass.trivial, 0);
  EXPECT_EQ(a.within[0].counted, 3);
  EXPECT_EQ(a.within[1].counted, 4);
}

TEST(Sheet, AccuracyInTimeIsOfAnswersWithinTheBudget) {
  SheetOptions options;
  options.budgets_ms = {2, 100};
  std::vector<Record> records = three_solvers_on_four_instances();
  records[9] = timed(made_up("c/3", "a", Verdict::wrong, Claim::solved, 1e-2), 2);
  const Sheet sheet = make_sheet(records, options);
  const SheetRow& a = only_group(sheet).rows[0];
  EXPECT_EQ(a.accuracy_in_time[0].reached, (std::vector<double>{1e-14, 1e-8, 1e-2}));
  EXPECT_DOUBLE_EQ(a.accuracy_in_time[0].share(1e-10), 0.25);
  EXPECT_EQ(a.accuracy_in_time[1].reached.size(), 4u);
  EXPECT_EQ(only_group(sheet).rows[1].accuracy_in_time[1].reached.size(), 3u)
      << "a claim of failure is no answer";
}

TEST(Sheet, RatiosOfCountsHaveAnOffsetAndRowsWithoutSuchWorkLeave) {
  std::vector<Record> records = {solved("c/0", "a", 0), solved("c/0", "b", 0),
                                 solved("c/0", "sweeper", 0),
                                 ended("c/0", "killed", Verdict::timeout)};
  records[0].work.pivots = 0;
  records[1].work.pivots = 5;
  records[2].work.pivots = 0;
  records.push_back(solved("c/1", "a", 0));
  records.back().work.pivots = 3;
  SheetOptions options;
  options.measure = Measure::pivots;
  const Sheet sheet = make_sheet(records, options);
  EXPECT_EQ(sheet.without_work, (std::vector<std::string>{"sweeper"}));
  const Group& group = only_group(sheet);
  ASSERT_EQ(group.rows.size(), 3u);
  EXPECT_EQ(group.rows[0].profile.reached, (std::vector<double>{1, 1}));
  EXPECT_EQ(group.rows[1].profile.reached, (std::vector<double>{6}));  // (5 + 1) / (0 + 1)
  EXPECT_EQ(group.rows[2].mass.failed, 1) << "what was killed says nothing of its work";
  options.count_offset = 10;
  EXPECT_EQ(only_group(make_sheet(records, options)).rows[1].profile.reached,
            (std::vector<double>{1.5}));
}

/// Which of its settings are in the front, in their order.
std::vector<bool> front_of(const std::vector<Record>& records) {
  const Sheet sheet = make_sheet(records);
  std::vector<bool> front;
  for (const SheetRow& row : only_group(sheet).rows) front.push_back(row.front);
  return front;
}

TEST(Sheet, TheFrontPrefersTheLargerShareSolvedAtEqualCostAndResidual) {
  std::vector<Record> records = {solved_in("c/0", "all", 1, 1e-9),
                                 solved_in("c/0", "half", 1, 1e-9),
                                 solved_in("c/0", "same", 1, 1e-9),
                                 solved_in("c/1", "all", 1, 1e-9),
                                 made_up("c/1", "half", Verdict::ray, Claim::ray, 1),
                                 solved_in("c/1", "same", 1, 1e-9)};
  EXPECT_EQ(front_of(records), (std::vector<bool>{true, false, true}));
}

TEST(Sheet, TheFrontHoldsWhatNothingElseDominates) {
  // exact is slower and more accurate than quick; worse is dominated by quick; partial is fastest but
  // solves half.
  std::vector<Record> records;
  for (const char* instance : {"c/0", "c/1"}) {
    records.push_back(solved_in(instance, "quick", 2, 1e-8));
    records.push_back(solved_in(instance, "exact", 4, 1e-15));
    records.push_back(solved_in(instance, "worse", 2, 1e-7));
    records.push_back(instance == std::string("c/0")
                          ? solved_in(instance, "partial", 1, 1e-8)
                          : made_up(instance, "partial", Verdict::ray, Claim::ray, 1));
  }
  const Sheet sheet = make_sheet(records);
  std::vector<bool> front;
  for (const SheetRow& row : only_group(sheet).rows) front.push_back(row.front);
  EXPECT_EQ(front, (std::vector<bool>{true, true, false, true}));
  std::string text = render(sheet, SheetFormat::text);
  for (std::size_t at; (at = text.find("\n  ")) != std::string::npos;) text.replace(at, 3, " ");
  EXPECT_NE(
      text.find(
          "Of the settings that solve the largest share (2 of 2), quick costs least: 2.00 ms at "
          "a residual of 1.0e-08; exact is the most accurate: 1.0e-15 at 4.00 ms."),
      std::string::npos)
      << text;
}

TEST(Sheet, LaddersAreSettingsThatDifferInOneNumber) {
  std::vector<Record> records;
  const auto add = [&](const char* solver, const char* eps, const char* other, double ms,
                       double residual) {
    Record record = solved_in("c/0", solver, ms, residual);
    record.options = {{"eps", eps}, {"other", other}, {"polish", "off"}};
    records.push_back(record);
  };
  add("a:eps=1e-3", "1e-3", "1", 1, 1e-7);
  add("a", "1e-9", "1", 4, 1e-13);
  add("a:other=2", "1e-9", "2", 8, 1e-13);
  add("a:eps=1e-12", "1e-12", "1", 6, 0);
  const Sheet sheet = make_sheet(records);
  const std::vector<Ladder>& ladders = only_group(sheet).ladders;
  ASSERT_EQ(ladders.size(), 2u);
  EXPECT_EQ(ladders[0].name, "a");
  EXPECT_EQ(ladders[0].option, "eps");
  ASSERT_EQ(ladders[0].steps.size(), 3u);
  EXPECT_EQ(ladders[0].steps[0].value, "1e-3");
  EXPECT_EQ(ladders[0].steps[ladders[0].base].value, "1e-9") << "the value of most settings";
  EXPECT_DOUBLE_EQ(ladders[0].steps[0].cost_ratio.value(), 0.25);
  EXPECT_NEAR(ladders[0].steps[0].residual_ratio.value(), 1e6, 1e-3);
  EXPECT_NEAR(ladders[0].steps[2].residual_ratio.value(), residual_floor / 1e-13, 1e-12);
  EXPECT_EQ(ladders[1].option, "other");
  EXPECT_EQ(ladders[1].steps.size(), 2u);
}

TEST(Sheet, StartsAreSettingsOfTheirOwn) {
  std::vector<Record> records = {solved_in("c/0", "a", 4, 0), solved_in("c/0", "a", 1, 0)};
  records[1].start = "previous";
  records[1].sha256 = std::string(64, '1');
  const Sheet sheet = make_sheet(records);
  ASSERT_EQ(sheet.settings.size(), 2u);
  EXPECT_EQ(sheet.settings[1].label, "a [previous]");
  EXPECT_EQ(only_group(sheet).instances, 1);
  EXPECT_EQ(only_group(sheet).rows[0].profile.reached, (std::vector<double>{4}));
}

TEST(Sheet, CorporaStandTogetherAndAlone) {
  const std::vector<Record> records = {solved_in("c/0", "a", 1, 0), solved_in("c/0", "b", 2, 0),
                                       solved_in("d/0", "a", 8, 0), solved_in("d/0", "b", 2, 0)};
  const Sheet sheet = make_sheet(records);
  ASSERT_EQ(sheet.groups.size(), 3u);
  EXPECT_EQ(sheet.groups[0].name, all_corpora);
  EXPECT_EQ(sheet.groups[0].instances, 2);
  EXPECT_EQ(sheet.groups[0].rows[0].profile.reached, (std::vector<double>{1, 4}));
  EXPECT_EQ(sheet.groups[2].rows[0].profile.reached, (std::vector<double>{4}));
  SheetOptions options;
  options.corpora = {"d*"};
  EXPECT_EQ(only_group(make_sheet(records, options)).name, "d");
  options.corpora = {"e"};
  try {
    make_sheet(records, options);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("the run has: c, d"), std::string::npos)
        << error.what();
  }
}

TEST(Sheet, HighlightsTakeTheBestOfEachRowFirst) {
  std::vector<Record> records;
  for (const char* solver : {"a:x=1", "a:x=2", "b", "d"})
    records.push_back(solved_in("c/0", solver, 1.0 + static_cast<double>(records.size()), 0));
  records.push_back(made_up("c/0", "e", Verdict::ray, Claim::ray, 1));
  const Sheet sheet = make_sheet(records);
  const Group& group = only_group(sheet);
  EXPECT_EQ(highlights(sheet, group, 3), (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(highlights(sheet, group, 10), (std::vector<std::size_t>{0, 2, 3, 4, 1}));
}

TEST(Sheet, RefusesRowsJudgedDifferentlyUnlessToldATolerance) {
  std::vector<Record> records = {solved("c/0", "a", 0), solved("c/1", "a", 1e-8)};
  records[1].tolerance = 1e-9;
  EXPECT_THROW(make_sheet(records), std::invalid_argument);
  SheetOptions options;
  options.tolerance = 1e-10;
  EXPECT_EQ(only_group(make_sheet(records, options)).rows[0].mass.failed, 1);
}

TEST(Sheet, WithoutRowsHasNothingToSay) {
  EXPECT_EQ(render(make_sheet({}), SheetFormat::text), "no rows\n");
}

/// Every row of a run lies on the sheet once: solved in the plane, or failed at its edge, or left out
/// by name; and where the table counts it.
void expect_whole(const std::vector<Record>& records) {
  const Sheet sheet = make_sheet(records);
  const Table table = make_table(records);
  for (const Group& group : sheet.groups) {
    for (const SheetRow& row : group.rows) {
      const Mass& mass = row.mass;
      EXPECT_EQ(mass.solved + mass.failed + mass.trivial + mass.unsupported + mass.not_run,
                mass.instances);
      EXPECT_EQ(static_cast<Index>(row.profile.reached.size()), mass.solved);
      EXPECT_EQ(row.cost.has_value(), mass.solved > 0);
      EXPECT_EQ(row.profile.counted, mass.counted());
      EXPECT_NEAR(row.profile.unreached() * double(mass.counted()), double(mass.failed), 1e-9);
    }
    if (group.name == all_corpora) continue;
    for (const SheetRow& row : group.rows) {
      const Setting& setting = sheet.settings[row.setting];
      const auto counted =
          std::find_if(table.rows.begin(), table.rows.end(), [&](const TableRow& each) {
            return each.corpus == group.name && each.solver == setting.solver &&
                   each.start == setting.start;
          });
      ASSERT_NE(counted, table.rows.end());
      EXPECT_EQ(counted->instances, row.mass.instances);
      EXPECT_EQ(counted->success, row.mass.solved);
      EXPECT_EQ(counted->failure, row.mass.failed);
      EXPECT_EQ(counted->trivial, row.mass.trivial);
      EXPECT_EQ(counted->unsupported, row.mass.unsupported);
      EXPECT_EQ(counted->not_run, row.mass.not_run);
      EXPECT_EQ(counted->time_median_ms.value_or(0), row.cost ? row.cost->median : 0);
    }
  }
  Index rows = 0;
  for (const Group& group : sheet.groups)
    for (const SheetRow& row : group.rows)
      if (sheet.groups.size() == 1 || group.name != all_corpora) rows += row.mass.instances;
  EXPECT_EQ(rows, static_cast<Index>(records.size()));
}

TEST(Sheet, LosesNoRowOfMadeUpOnes) {
  std::vector<Record> records;
  for (const Verdict verdict : all_values<Verdict>())
    if (verdict != Verdict::inaccurate)
      records.push_back(decided_by_runner(verdict)
                            ? ended("c/" + to_string(verdict), "a", verdict)
                            : made_up("c/" + to_string(verdict), "a", verdict,
                                      verdict == Verdict::solved || verdict == Verdict::wrong
                                          ? Claim::solved
                                          : Claim::ray,
                                      verdict == Verdict::solved ? 1e-12 : 1));
  records.push_back(solved("d/0", "a", 0));
  records.back().trivial = true;
  records.back().accuracy->zero_residual = 0;
  expect_whole(records);
}

TEST(Sheet, LosesNoRowOfACommittedRun) {
  const std::vector<Record> records = read_run(RESULTS "/default");
  EXPECT_GT(records.size(), 100u);
  expect_whole(records);
}

TEST(Sheet, DataHoldTheCurves) {
  const Sheet sheet = make_sheet(three_solvers_on_four_instances());
  const nlohmann::json written = nlohmann::json::parse(render(sheet, SheetFormat::json));
  const nlohmann::json& a = written.at("groups")[0].at("rows")[0];
  EXPECT_EQ(written.at("ratio"), "c / best");
  EXPECT_EQ(a.at("profile").at("reached"), (nlohmann::json{1, 2, 2}));
  EXPECT_EQ(a.at("profile").at("counted"), 4);
  EXPECT_EQ(a.at("within").size(), 10u);
  const std::string csv = render(sheet, SheetFormat::csv);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  const std::string head = csv.substr(0, csv.find('\n'));
  const std::string line = csv.substr(head.size() + 1, csv.find('\n', head.size() + 1));
  EXPECT_EQ(line.rfind("c,a,a,a,cold,time,1e-06,4,3,1,0,0,0,1,2,4,", 0), 0u) << line;
  for (const std::string& each : {head, line.substr(0, line.find('\n'))})
    EXPECT_EQ(std::count(each.begin(), each.end(), ','), 23 + 5 + 1 + 10 + 3) << each;
}

}  // namespace
}  // namespace lcp
