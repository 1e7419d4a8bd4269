#include "harness/present/step_curves.h"

#include <gtest/gtest.h>

#include "harness/studies/sheet/sheet_files.h"
#include "harness/studies/sheet/sheet_pictures.h"
#include "tests/harness/made_up_records.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

TEST(StepCurves, CornersGoFromEndToEndAndKeepEveryShare) {
  const Curve curve{4, {1, 10, 10}};
  const std::vector<Pixels> corners = step_corners(curve, {1, 100}, 10);
  EXPECT_DOUBLE_EQ(corners.front().x, 1);
  EXPECT_DOUBLE_EQ(corners.front().y, 0.25);
  EXPECT_DOUBLE_EQ(corners.back().x, 100);
  EXPECT_DOUBLE_EQ(corners.back().y, 0.75);
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_NEAR(corners[1].x, 10, 6) << "within a column of ten";
}

TEST(StepCurves, NoCurveHasMoreCornersThanColumnsNeed) {
  Curve curve;
  curve.counted = 10000;
  for (int i = 0; i < 10000; ++i) curve.reached.push_back(1 + i);
  EXPECT_LE(step_corners(curve, {1, 10000}, 50).size(), 102u);
}

TEST(SheetPictures, NameTheShareThatIsNeverReached) {
  const StepCurvePage page =
      profile_page(make_sheet({solved("c/0", "a", 0), solved("c/0", "b", 0), solved("c/1", "a", 0),
                               made_up("c/1", "b", Verdict::ray, Claim::ray, 1)}));
  ASSERT_EQ(page.legend.size(), 2u);
  EXPECT_EQ(page.legend[0], "a  (0 % never)");
  EXPECT_EQ(page.legend[1], "b  (50 % never)");
  EXPECT_NE(page.caption.find("among these 2 settings"), std::string::npos) << page.caption;
}

TEST(SheetPictures, ShowAtMostTenSettingsInColour) {
  std::vector<Record> records;
  for (int i = 0; i < 14; ++i) records.push_back(solved("c/0", "s" + std::to_string(i), 1e-9));
  const Sheet sheet = make_sheet(records);
  for (const StepCurvePage& page :
       {profile_page(sheet), cumulative_page(sheet), accuracy_page(sheet)}) {
    EXPECT_EQ(page.legend.size(), 10u);
    for (const StepPanel& panel : page.panels) EXPECT_EQ(panel.curves.size(), 14u);
    EXPECT_EQ(page.caption.rfind("Grey: 4 other settings. ", 0), 0u) << page.caption;
  }
}

TEST(SheetFiles, AreNumbersAndPicturesOfTheirMeasure) {
  const TemporaryDirectory directory;
  SheetOptions options;
  write_sheet(make_sheet({solved("c/0", "a_b", 1e-9)}, options), directory.path() + "/new");
  options.measure = Measure::pivots;
  write_sheet(make_sheet({solved("c/0", "a_b", 1e-9)}, options), directory.path() + "/new");
  for (const char* name : {"sheet.txt", "sheet.csv", "sheet.json", "sheet-pivots.txt"})
    EXPECT_FALSE(read_text(directory.file(std::string("new/") + name)).empty()) << name;
  for (const char* name :
       {"chart.svg", "sheet-profile.svg", "sheet-cumulative.svg", "sheet-accuracy.svg",
        "chart-pivots.svg", "sheet-pivots-profile.svg", "sheet-pivots-cumulative.svg"}) {
    const std::string svg = read_text(directory.file(std::string("new/") + name));
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << name;
    EXPECT_NE(svg.find("a_b"), std::string::npos) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(directory.file("new/sheet-pivots-accuracy.svg")));
}

TEST(SheetFiles, OfRowsThatAreNotCountedHaveNoPictures) {
  const TemporaryDirectory directory;
  write_sheet(make_sheet({ended("c/0", "a", Verdict::not_run)}), directory.path());
  EXPECT_NE(read_text(directory.file("sheet.txt")).find("Nothing is solved here."),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(directory.file("chart.svg")));
}

}  // namespace
}  // namespace lcp
