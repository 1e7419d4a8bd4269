#include "harness/studies/paper/written_forms.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

LoopSummary squat_summary() {
  LoopSummary summary;
  summary.scene = "squat";
  summary.solver = "best-first:e_max=0.001";
  summary.total_frames = 999;
  summary.success = 998;
  return summary;
}

TEST(WrittenForms, AFigureNamesItsFilesAndWhatRan) {
  const nlohmann::json json =
      nlohmann::json::parse(render_figure(2, {squat_summary()}, TableFormat::json));
  EXPECT_EQ(json.at("picture"), "fig2.svg");
  EXPECT_EQ(json.at("data"), "fig2.csv");
  EXPECT_EQ(json.at("runs").at(0).at("success"), 998);
  const std::string latex = render_figure(2, {squat_summary()}, TableFormat::latex);
  EXPECT_NE(latex.find("{fig2}"), std::string::npos) << latex;
  EXPECT_NE(latex.find("e\\_max"), std::string::npos) << latex;
  EXPECT_NE(latex.find("998 of 999 frames"), std::string::npos) << latex;
}

TEST(WrittenForms, TheDataOfAFigureAreNotItsSummary) {
  EXPECT_THROW(render_figure(3, {}, TableFormat::csv), std::invalid_argument);
}

TEST(WrittenForms, EachFormatHasAFileOfItsOwn) {
  const TemporaryDirectory directory;
  write_each_format(directory.file("table"),
                    [](TableFormat format) { return std::to_string(static_cast<int>(format)); });
  EXPECT_EQ(read_text(directory.file("table.txt")), std::to_string(int(TableFormat::text)));
  EXPECT_EQ(read_text(directory.file("table.csv")), std::to_string(int(TableFormat::csv)));
  EXPECT_EQ(read_text(directory.file("table.json")), std::to_string(int(TableFormat::json)));
  EXPECT_EQ(read_text(directory.file("table.tex")), std::to_string(int(TableFormat::latex)));
}

}  // namespace
}  // namespace lcp
