#include "harness/studies/paper/reproduce.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "harness/studies/paper/table_pictures.h"
#include "problems/io/errors.h"
#include "solvers/registry.h"
#include "tests/harness/studies/paper/reproduction_test.h"

namespace lcp {
namespace {

namespace fs = std::filesystem;

/// Two columns of Table I on a few milliseconds of squat.
PaperPlan small_plan() {
  PaperPlan plan = paper_plan(1, false);
  plan.scenes = {{"in the loop", "squat:points=8"}};
  std::erase_if(plan.solvers, [](const PaperColumn& column) {
    return column.name != "lemke" && column.name != "best-first";
  });
  plan.duration = 0.005;
  return plan;
}

class Reproduce : public ReproductionTest {
 protected:
  Reproduce() : ReproductionTest(small_plan(), "table1") {}
};

TEST_F(Reproduce, SetsTheTableTogether) {
  const PaperTable table = run().value();
  ASSERT_EQ(table.layers.front().label, "in the loop");
  const std::vector<Cell>& in_loop = table.layers.front().rows;
  ASSERT_EQ(in_loop.size(), 2u);
  EXPECT_EQ(in_loop[1].at("solver"), "best-first");
  EXPECT_EQ(in_loop[1].at("total_frames"), 4) << "in the first frame nothing touches";
  EXPECT_EQ(in_loop[1].at("failure"), 0);
  EXPECT_TRUE(std::any_of(table.layers.begin(), table.layers.end(), [](const PaperLayer& layer) {
    return layer.section.empty() && layer.second_look &&
           layer.rows[1].at("corpus") == "squat:points=8" && layer.rows[1].at("success") == 4;
  }));
  const PaperPage page = page_of(table);
  for (const TableFormat format :
       {TableFormat::text, TableFormat::csv, TableFormat::json, TableFormat::latex})
    EXPECT_NE(render(page, format).find("lemke"), std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(page.json);
  bool found = false;
  for (const nlohmann::json& row : json.at("rows"))
    if (row.at("solver") == "lemke" && row.at("mode") == "in-loop") {
      found = true;
      EXPECT_EQ(row.at("published").at("success"), 506);
    }
  EXPECT_TRUE(found);
}

TEST_F(Reproduce, ThePictureShowsPublishedAndMeasuredOfEveryRow) {
  const PaperTable table = run().value();
  const DotPage page = picture_of(table);
  EXPECT_EQ(page.panels.size(), table.plan.rows.size());
  std::vector<std::string> legend;
  for (const LegendEntry& each : page.legend) legend.push_back(each.name);
  ASSERT_EQ(legend, (std::vector<std::string>{"published", "in the loop", "on corpus", "at 1e-6"}));
  for (const DotPanel& panel : page.panels) {
    if (panel.title != "success") continue;
    ASSERT_EQ(panel.series.size(), 4u);
    EXPECT_EQ(panel.series[0].values[0], 506) << "of lemke";
    EXPECT_TRUE(std::isnan(panel.series[0].values[1])) << "best-first has no published value";
    EXPECT_EQ(panel.series[1].values[1], 4) << "of best-first, in the loop";
  }
}

TEST_F(Reproduce, ComputesOnlyWhatIsMissing) {
  EXPECT_EQ(missing().size(), 4u) << "two simulations, the corpus, rows on it";
  run();
  EXPECT_TRUE(missing().empty());
  const auto before = written();
  ASSERT_EQ(before.size(), 2u);
  run();
  EXPECT_EQ(written(), before);
  fs::remove(before.begin()->first);
  run();
  const auto after = written();
  ASSERT_EQ(after.size(), 2u);
  EXPECT_NE(after.begin()->second, before.begin()->second);
  EXPECT_EQ(after.rbegin()->second, before.rbegin()->second);
}

TEST_F(Reproduce, DoesNotUseACorpusThatIsNotComplete) {
  run();
  fs::remove(path() / "corpus.json");
  const std::vector<std::string> work = missing();
  ASSERT_FALSE(work.empty());
  EXPECT_NE(work.front().find("corpus"), std::string::npos) << work.front();
  EXPECT_TRUE(run().has_value());
}

TEST_F(Reproduce, RefusesWhatAnotherCommitBegan) {
  run();
  for (const fs::directory_entry& entry : fs::directory_iterator(path())) {
    if (!entry.path().filename().string().starts_with("env-")) continue;
    nlohmann::json environment = nlohmann::json::parse(read_text(entry.path()));
    environment["commit"] = "0123abc";
    write_text(entry.path(), environment.dump());
  }
  try {
    run();
    FAIL() << "expected a refusal";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("0123abc"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("--out"), std::string::npos) << error.what();
  }
}

TEST_F(Reproduce, InterruptedHandsBackNothing) {
  interrupted_ = true;
  EXPECT_FALSE(run().has_value());
  interrupted_ = false;
  EXPECT_TRUE(run().has_value());
}

TEST_F(Reproduce, DamagedFilesAreOneClearError) {
  run();
  write_text(written().begin()->first, "{");
  EXPECT_THROW(run(), UnreadableInput);
}

}  // namespace
}  // namespace lcp
