#include "harness/pictures/scene_picture.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <stdexcept>

#include "harness/pictures/scene_boxes.h"
#include "harness/pictures/scene_panels.h"
#include "problems/io/errors.h"
#include "tests/harness/pictures/pictured_run.h"
#include "tests/harness/pictures/xml.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

using Rows = std::vector<std::vector<double>>;

/// gnuplot's data sets: two blank lines lie between them.
std::vector<Rows> data_sets(const std::string& text) {
  std::vector<Rows> sets(1);
  std::istringstream lines(text);
  int blank = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    blank = line.empty() ? blank + 1 : 0;
    if (blank == 2) sets.emplace_back();
    if (line.empty()) continue;
    std::istringstream columns(line);
    std::vector<double> row;
    for (std::string word; columns >> word;) row.push_back(std::stod(word));
    sets.back().push_back(row);
  }
  sets.pop_back();  // what follows the last end
  return sets;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(ScenePicture, HasAPanelPerTimeWithEveryBoxAndEveryArrow) {
  const PicturedRun squat = pictured("squat:swing=1", 0.06, {0, 0.03, 0.06});
  ASSERT_EQ(squat.snapshots.size(), 3u);
  const std::vector<Rows> sets = data_sets(ScenePanels(squat.scene, squat.snapshots, {}).data());
  ASSERT_EQ(sets.size(), 3 * ScenePanels::sets_per_panel);
  const std::size_t boxes = scene_boxes(squat.scene.setup).size();
  std::size_t arrows = 0;
  for (std::size_t panel = 0; panel < 3; ++panel) {
    const std::size_t set = ScenePanels::sets_per_panel * panel;
    std::set<double> shadows, surfaces;
    for (const auto& row : sets[set]) shadows.insert(row[3]);
    for (const auto& row : sets[set + 2]) surfaces.insert(row[3]);
    EXPECT_EQ(shadows.size(), boxes);
    EXPECT_EQ(surfaces.size(), boxes);
    const std::vector<Snapshot::Touch>& touches = squat.snapshots[panel].touches;
    if (touches.empty()) continue;  // the first frame touches nothing yet
    ASSERT_EQ(sets[set + 3].size(), touches.size());
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const auto& row = sets[set + 3][i];
      if (row[4] == 0) continue;
      EXPECT_NEAR(row[4], touches[i].force.norm(), 1e-4 * row[4]);
      EXPECT_GT(row[3], 0) << "the floor pushes up";
      ++arrows;
    }
  }
  EXPECT_GE(arrows, 4u);
}

TEST(ScenePicture, IsWellFormedAndDrawnWithScriptAndDataBesideIt) {
  const TemporaryDirectory directory;
  const PicturedRun squat = pictured("squat", 0.06, {0, 0.03, 0.06});
  draw_picture(squat.scene, squat.snapshots, directory.file("squat.svg"));
  const std::string svg = read_text(directory.file("squat.svg"));
  EXPECT_EQ(complaint_about_xml(svg), "");
  for (const char* words : {"0.000 s", "0.030 s", "0.059 s", " N<", "grid: 0.1 m"})
    EXPECT_EQ(count(svg, words), 1u) << words;
  const std::size_t polygons = count(read_text(directory.file("squat.dat")), "\n\n");
  EXPECT_GT(polygons, 1000u);
  EXPECT_GT(count(svg, "<polygon fill"), polygons * 9 / 10);
  EXPECT_NE(read_text(directory.file("squat.gp")).find("DATA = 'squat.dat'"), std::string::npos);
}

TEST(ScenePicture, EveryPanelHasTheSameScale) {
  const PicturedRun squat = pictured("squat", 0.06, {0, 0.03, 0.06});
  const std::string script = ScenePanels(squat.scene, squat.snapshots, {}).script(900, 400);
  EXPECT_EQ(count(script, "set xrange"), 2u) << "one for the panels, one for the legend";
}

TEST(ScenePicture, LinksWithoutABoxAreBones) {
  NamedScene scene = make_scene("squat");
  scene.setup.boxes.clear();
  EXPECT_EQ(scene_boxes(scene.setup).size(), 24u) << "20 to the children's joints, 4 at the ends";
}

TEST(ScenePicture, WhatIsFixedInTheWorldStaysWhereItIs) {
  NamedScene scene = make_scene("squat");
  scene.setup.boxes = {{Link::world, {0, 0, 1}, {1, 2, 3}}};
  const auto corners = scene_boxes(scene.setup).front().corners(Snapshot{});
  EXPECT_EQ(corners.front(), Vector3d(0, 0, 1));
  EXPECT_EQ(corners.back(), Vector3d(1, 2, 3));
}

TEST(ScenePicture, NothingHalfWrittenRemainsWithoutGnuplot) {
  const TemporaryDirectory directory;
  const PicturedRun squat = pictured("squat", 0.03, {0.02});
  write_text(directory.file("squat.svg"), "older");
  const WithoutGnuplot hidden("/nowhere");
  EXPECT_THROW(draw_picture(squat.scene, squat.snapshots, directory.file("squat.svg")),
               UnwritableOutput);
  EXPECT_EQ(read_text(directory.file("squat.svg")), "older");
  for (const auto& entry : std::filesystem::directory_iterator(directory.path()))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST(ScenePicture, RefusesToDrawNothing) {
  EXPECT_THROW(draw_picture(make_scene("squat"), {}, "nothing.svg"), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
