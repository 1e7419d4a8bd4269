#include "harness/studies/sheet/sheet_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/studies/sheet/sheet_files.h"
#include "tests/harness/made_up_records.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

TEST(SheetPictures, NameTheShareThatIsNeverReached) {
  const Figure figure = profile_figure(
      make_sheet({solved("c/0", "a", 0), solved("c/0", "b", 0), solved("c/1", "a", 0),
                  made_up("c/1", "b", Verdict::ray, Claim::ray, 1)}));
  ASSERT_EQ(figure.legend.size(), 2u);
  EXPECT_EQ(figure.legend[0].name, "a  (0 % never)");
  EXPECT_EQ(figure.legend[1].name, "b  (50 % never)");
  EXPECT_NE(figure.caption.find("among these 2 settings"), std::string::npos) << figure.caption;
}

TEST(SheetPictures, ShowAtMostTenSettingsInColour) {
  std::vector<Record> records;
  for (int i = 0; i < 14; ++i) records.push_back(solved("c/0", "s" + std::to_string(i), 1e-9));
  const Sheet sheet = make_sheet(records);
  for (const Figure& figure :
       {profile_figure(sheet), cumulative_figure(sheet), accuracy_figure(sheet)}) {
    EXPECT_EQ(figure.legend.size(), 10u);
    for (const Panel& panel : figure.panels) {
      const auto grey = std::count_if(
          panel.series.begin(), panel.series.end(),
          [](const Series& series) { return series.marks.front().look.colour == 0xcccccc; });
      EXPECT_EQ(panel.series.size() - static_cast<std::size_t>(grey), 10u);
      EXPECT_EQ(grey, &panel == &figure.panels.front() ? 4 : 0) << "in the large panel alone";
    }
    EXPECT_EQ(figure.caption.rfind("Grey: 4 other settings. ", 0), 0u) << figure.caption;
  }
}

TEST(SheetPictures, ShowSettingsOfOneRowInItsColourWithDashesOfTheirOwn) {
  const Figure figure = profile_figure(
      make_sheet({solved("c/0", "a", 0), solved("c/0", "a:x=1", 0), solved("c/0", "a:x=2", 0)}));
  ASSERT_EQ(figure.legend.size(), 3u);
  for (const LegendEntry& entry : figure.legend)
    EXPECT_EQ(entry.look.colour, look_of_solver("a").colour);
  EXPECT_NE(figure.legend[0].look.dash, figure.legend[1].look.dash);
  EXPECT_NE(figure.legend[1].look.dash, figure.legend[2].look.dash);
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
