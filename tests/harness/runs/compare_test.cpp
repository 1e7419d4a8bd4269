#include "harness/runs/compare.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/harness/made_up_records.h"

namespace lcp {
namespace {

/// Solved with so many pivots and these times in ms.
Record measured(const std::string& instance, Index pivots, const std::vector<double>& ms) {
  Record record = solved(instance, "lemke", 0);
  record.work.pivots = pivots;
  record.times_ns.clear();
  for (const double time : ms) record.times_ns.push_back(static_cast<std::int64_t>(time * 1e6));
  return record;
}

std::vector<std::string> summary(const Comparison& comparison) {
  std::vector<std::string> lines;
  for (const Regression& each : comparison.regressions)
    lines.push_back(std::string(to_string(each.kind)) + " " + each.pair.instance);
  return lines;
}

using Lines = std::vector<std::string>;

TEST(Compare, FindsNothingBetweenARunAndItself) {
  const std::vector<Record> rows = {measured("a", 10, {1, 2, 3}),
                                    ended("b", "lemke", Verdict::timeout)};
  const Comparison same = compare(rows, rows);
  EXPECT_TRUE(same.regressions.empty());
  EXPECT_EQ(same.compared, 2u);
}

TEST(Compare, APairThatIsNoLongerSolvedIsLost) {
  const std::vector<Record> before = {solved("a", "lemke", 0),
                                      ended("b", "lemke", Verdict::timeout)};
  const std::vector<Record> after = {ended("a", "lemke", Verdict::crash), solved("b", "lemke", 0)};
  const Comparison found = compare(before, after);
  EXPECT_EQ(summary(found), Lines{"lost a"});
  EXPECT_EQ(found.regressions[0].before, "solved");
  EXPECT_EQ(found.regressions[0].after, "crash");
  EXPECT_EQ(found.gained, 1u);
}

TEST(Compare, FivePercentMorePivotsAreAllowed) {
  EXPECT_EQ(summary(compare({measured("a", 100, {1})}, {measured("a", 105, {1})})), Lines{});
  EXPECT_EQ(summary(compare({measured("a", 100, {1})}, {measured("a", 106, {1})})),
            Lines{"pivots a"});
  EXPECT_EQ(summary(compare({measured("a", 0, {1})}, {measured("a", 1, {1})})), Lines{"pivots a"});
}

TEST(Compare, TimesCountWhenDisjointAndAQuarterLonger) {
  const auto times = [](const std::vector<double>& before, const std::vector<double>& after) {
    return summary(compare({measured("a", 1, before)}, {measured("a", 1, after)}));
  };
  EXPECT_EQ(times({1, 1.1, 1.2}, {1.3, 1.3, 1.3}), Lines{}) << "ratio 1.18";
  EXPECT_EQ(times({1, 1.1, 1.2}, {1.15, 2, 2}), Lines{}) << "the ranges overlap";
  EXPECT_EQ(times({1, 1.1, 1.2}, {1.5, 1.6, 1.7}), Lines{"time a"});
  EXPECT_EQ(times({1.5, 1.6, 1.7}, {1, 1.1, 1.2}), Lines{}) << "faster";
}

TEST(Compare, ListsTheWorstFirst) {
  const std::vector<Record> before = {measured("slower", 10, {1}), measured("slowest", 10, {1}),
                                      measured("pivots", 10, {1}), solved("lost", "lemke", 0)};
  const std::vector<Record> after = {measured("slower", 10, {2}), measured("slowest", 10, {3}),
                                     measured("pivots", 11, {1}),
                                     ended("lost", "lemke", Verdict::crash)};
  EXPECT_EQ(summary(compare(before, after)),
            (Lines{"lost lost", "pivots pivots", "time slowest", "time slower"}));
}

TEST(Compare, CountsPairsThatOneRunLacks) {
  Record changed = solved("a", "lemke", 0);
  changed.sha256 = std::string(64, '1');
  const Comparison found = compare({solved("a", "lemke", 0), solved("b", "lemke", 0)},
                                   {changed, solved("b", "lemke", 0)});
  EXPECT_EQ(found.compared, 1u);
  EXPECT_EQ(found.only_old, 1u);
  EXPECT_EQ(found.only_new, 1u);
}

TEST(Compare, RefusesDifferentTolerances) {
  Record strict = solved("a", "lemke", 0);
  strict.tolerance = 1e-12;
  EXPECT_THROW(compare({solved("a", "lemke", 0)}, {strict}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
