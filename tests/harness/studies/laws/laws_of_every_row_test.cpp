#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>

#include "harness/studies/laws/laws.h"

namespace lcp {

void PrintTo(const Law& law, std::ostream* out) { *out << law.name; }
void PrintTo(const Row& row, std::ostream* out) { *out << row.info.name; }

namespace {

using Case = std::tuple<Row, Law>;

class EveryRow : public testing::TestWithParam<Case> {};

TEST_P(EveryRow, ObeysTheLaw) {
  const auto& [row, law] = GetParam();
  const LawOutcome outcome = check(law, make_solver(row.info.name));
  if (outcome.status == LawOutcome::Status::not_applicable)
    GTEST_SKIP() << row.info.name << ", " << law.name << ": " << outcome.detail;
  if (outcome.status == LawOutcome::Status::broken && row.info.peer() && law.of_answers)
    GTEST_SKIP() << row.info.name << ", " << law.name << ": broken by " << row.info.outside_library
                 << ", whose answers are not repaired: " << outcome.detail;
  EXPECT_EQ(outcome.status, LawOutcome::Status::holds) << law.statement << ": " << outcome.detail;
}

std::string test_name(const testing::TestParamInfo<Case>& info) {
  std::string name = std::get<0>(info.param).info.name + "_" + std::get<1>(info.param).name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryRow,
                         testing::Combine(testing::ValuesIn(registry()), testing::ValuesIn(laws())),
                         test_name);

}  // namespace
}  // namespace lcp
