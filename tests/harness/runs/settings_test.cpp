#include "harness/runs/settings.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/harness/made_up_records.h"

namespace lcp {
namespace {

using nlohmann::json;

RunSettings example() {
  RunSettings settings;
  settings.origin = {"", {"a.hdf5", "b"}, 3, 0};
  settings.instances = 7;
  settings.shard = {1, 4};
  settings.tolerance = 1e-6;
  settings.timeout_s = 10;
  settings.memory_bytes = 1 << 30;
  settings.max_contacts = 60;
  settings.solvers = {"lemke", "best-first:epsilon=1e-3"};
  return settings;
}

TEST(RunSettings, ComeBackFromJsonAsTheyWere) {
  RunSettings settings = example();
  EXPECT_EQ(json(json(settings).get<RunSettings>()), json(settings));
  EXPECT_TRUE(json(settings).at("seconds").is_null());
  settings.seconds = 1.5;
  EXPECT_EQ(json(settings).get<RunSettings>().seconds, 1.5);
  EXPECT_EQ(json(settings).get<RunSettings>().shard, (Shard{1, 4}));
}

TEST(RunSettings, TakeTheStartFromThePlan) {
  RunPlan plan;
  EXPECT_EQ(settings_of(plan, {}).start, "cold");
  plan.starts = {StartKind::two_step};
  EXPECT_EQ(settings_of(plan, {}).start, "two-step");
  plan.starts = {StartKind::cold, StartKind::previous};
  EXPECT_EQ(settings_of(plan, {}).start, "cold, previous");
}

TEST(RunSettings, AMissingFieldOrAnotherSchemaIsNamed) {
  const json whole = example();
  for (const auto& [field, value] : whole.items()) {
    json object = whole;
    object.erase(field);
    try {
      object.get<RunSettings>();
      ADD_FAILURE() << "read without " << field;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
    }
  }
  json object = whole;
  object["schema"] = 2;
  EXPECT_THROW(object.get<RunSettings>(), std::invalid_argument);
}

TEST(RunSettings, ConflictWhereTheirRowsDoNotBelongIntoOneTable) {
  RunSettings other = example();
  other.solvers = {"lemke"};
  other.shard = {};
  other.seconds = 3;
  other.instances = 1;
  EXPECT_TRUE(conflicts(example(), other).empty());
  other.tolerance = 1e-9;
  other.origin.every = 1;
  EXPECT_EQ(conflicts(example(), other),
            (std::vector<std::string>{"instances --corpus a.hdf5 b --every 3, --corpus a.hdf5 b",
                                      "tolerance 1e-06, 1e-09"}));
}

TEST(Shard, IsWrittenFromOneOn) {
  EXPECT_EQ(parse_shard("2/4"), (Shard{1, 4}));
  EXPECT_EQ(to_string(Shard{1, 4}), "2/4");
  for (const char* wrong : {"", "2", "0/4", "5/4", "2/", "/4", "2/4x", "-1/4", "2 /4", "1/1/1"})
    EXPECT_THROW(parse_shard(wrong), std::invalid_argument) << wrong;
}

TEST(SortRows, GoesByPlaceThenBySolverAsListed) {
  std::vector<Record> rows;
  for (const Index place : {1, 0})
    for (const char* solver : {"b", "z", "a"}) {
      rows.push_back(solved("x", solver, 0));
      rows.back().place = place;
    }
  sort_rows(rows, {"a", "b"});
  std::string order;
  for (const Record& row : rows) order += std::to_string(row.place) + row.solver + " ";
  EXPECT_EQ(order, "0a 0b 0z 1a 1b 1z ");
}

TEST(SortRows, PutsTheStartsOfASolverInTheirOrder) {
  std::vector<Record> rows;
  for (const char* start : {"previous", "cold", "two-step"})
    for (const char* solver : {"b", "a"}) {
      rows.push_back(solved("x", solver, 0));
      rows.back().start = start;
    }
  sort_rows(rows, {"a", "b"});
  std::string order;
  for (const Record& row : rows) order += row.solver + "-" + row.start + " ";
  EXPECT_EQ(order, "a-cold a-two-step a-previous b-cold b-two-step b-previous ");
}

}  // namespace
}  // namespace lcp
