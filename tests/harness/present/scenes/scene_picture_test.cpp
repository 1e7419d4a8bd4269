#include "harness/present/scenes/scene_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "harness/present/scenes/scene_bodies.h"
#include "problems/io/errors.h"
#include "problems/rigid/kinematics.h"
#include "tests/harness/present/scenes/xml.h"
#include "tests/harness/studies/paper/pictured_run.h"
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

/// Four corners each.
std::vector<Rows> floors(const std::vector<Rows>& sets) {
  std::vector<Rows> all;
  for (std::size_t k = 0; k + 3 < sets[0].size(); k += 4)
    all.emplace_back(sets[0].begin() + k, sets[0].begin() + k + 4);
  return all;
}

TEST(ScenePicture, HasAPanelPerTimeWithEveryArrow) {
  const PicturedRun squat = pictured("squat:swing=1", 0.06, {0, 0.03, 0.06});
  ASSERT_EQ(squat.snapshots.size(), 3u);
  const GnuplotPage page = scene_page("", {{&squat.scene, squat.snapshots}});
  for (const char* time : {"'0.000 s'", "'0.030 s'", "'0.059 s'"})
    EXPECT_EQ(count(page.commands, time), 1u) << time;
  const std::vector<Rows> sets = data_sets(page.data);
  ASSERT_EQ(sets.size(), scene_page_sets);
  EXPECT_EQ(floors(sets).size(), 3u);
  std::size_t row = 0, arrows = 0;
  for (const Snapshot& snapshot : squat.snapshots)
    for (const Snapshot::Touch& touch : snapshot.touches) {
      ASSERT_LT(row, sets[2].size());
      const std::vector<double>& contact = sets[2][row++];
      if (contact[4] == 0) continue;
      EXPECT_NEAR(contact[4], touch.force.norm(), 1e-4 * contact[4]);
      EXPECT_GT(contact[3], 0) << "the floor pushes up";
      ++arrows;
    }
  EXPECT_EQ(row, sets[2].size());
  EXPECT_GE(arrows, 4u);
}

TEST(ScenePicture, IsWellFormedAndDrawnWithScriptDataAndImageBesideIt) {
  const TemporaryDirectory directory;
  const PicturedRun squat = pictured("squat", 0.06, {0, 0.03, 0.06});
  draw_picture(squat.scene, squat.snapshots, directory.file("squat.svg"));
  const std::string svg = read_text(directory.file("squat.svg"));
  EXPECT_EQ(complaint_about_xml(svg), "");
  for (const char* words : {"0.000 s", "0.030 s", "0.059 s", " N<", "grid: 0.1 m", "<image "})
    EXPECT_EQ(count(svg, words), 1u) << words;
  EXPECT_EQ(count(svg, "xlink:href='data:image/png;base64,"), 1u) << "the bodies are in the file";
  const std::string script = read_text(directory.file("squat.gp"));
  EXPECT_NE(script.find("DATA = 'squat.dat'"), std::string::npos);
  EXPECT_NE(script.find("IMAGE = 'squat.png'"), std::string::npos);
  EXPECT_TRUE(read_text(directory.file("squat.png")).starts_with("\x89PNG"));
}

TEST(ScenePicture, EveryPanelHasTheSameScale) {
  const PicturedRun squat = pictured("squat", 0.06, {0, 0.03, 0.06});
  const std::vector<Rows> sets = data_sets(scene_page("", {{&squat.scene, squat.snapshots}}).data);
  const std::vector<Rows> panels = floors(sets);
  ASSERT_EQ(panels.size(), 3u);
  for (const Rows& floor : panels)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t axis = 0; axis < 2; ++axis)
        EXPECT_NEAR(floor[k][axis] - floor[0][axis], panels[0][k][axis] - panels[0][0][axis], 0.02);
  EXPECT_GT(panels[1][0][0], panels[0][1][0]) << "side by side";
  EXPECT_NEAR(panels[1][0][1], panels[0][0][1], 1e-9);
  const auto drawn = [](const std::vector<double>& row) { return std::hypot(row[2], row[3]); };
  double least = 1e9, most = 0;
  for (const auto& row : sets[2]) {
    if (row[4] == 0) continue;
    least = std::min(least, drawn(row) / row[4]);
    most = std::max(most, drawn(row) / row[4]);
  }
  EXPECT_LT(most / least, 1.5) << "arrows lean, but no more than friction lets them";
}

TEST(ScenePicture, NamesThatGnuplotWouldRunAreHarmless) {
  const TemporaryDirectory directory;
  PicturedRun squat = pictured("squat", 0.03, {0.02});
  squat.scene.spelling = "squat`touch run`'\nexit\n'";
  const SceneMoments moments{
      .scene = &squat.scene, .snapshots = squat.snapshots, .name = "`touch run`'"};
  draw_with_gnuplot(directory.file("squat.svg"), scene_page("`touch run`\nexit", {moments}));
  EXPECT_FALSE(std::filesystem::exists(directory.file("run")));
  const std::string svg = read_text(directory.file("squat.svg"));
  EXPECT_EQ(complaint_about_xml(svg), "");
  EXPECT_NE(svg.find("squat?touch run??"), std::string::npos);
}

TEST(ScenePicture, ScenesLieBelowOneAnotherAndLeaveWhatIsAskedForAtTheFoot) {
  const PicturedRun squat = pictured("squat", 0.03, {0.01, 0.02});
  SceneMoments moments{&squat.scene, squat.snapshots};
  const GnuplotPage one = scene_page("", {moments}), two = scene_page("", {moments, moments}, 100);
  EXPECT_GT(two.height, 2 * one.height + 100);
  EXPECT_EQ(two.width, one.width);
  const std::vector<Rows> panels = floors(data_sets(two.data));
  ASSERT_EQ(panels.size(), 4u);
  EXPECT_GT(panels[0][0][1], panels[2][0][1] + 100) << "y is up";
  for (const auto& row : panels[3]) EXPECT_GT(row[1], 100);
  moments.contacts = false;
  const GnuplotPage plain = scene_page("", {moments});
  EXPECT_LT(plain.height, one.height) << "no legend";
  EXPECT_TRUE(std::isnan(data_sets(plain.data)[2].front()[0])) << "no contacts";
}

/// A chain of three capsules that hangs from the origin below a beam, without a floor.
NamedScene hanging_chain() {
  std::vector<Link> links;
  std::vector<collision::Shape> shapes = {{collision::Cylinder{0.05, 100}, Link::world, {}}};
  shapes.front().in_link.R = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX()).matrix();
  for (Index i = 0; i < 3; ++i) {
    links.push_back({.name = std::to_string(i),
                     .parent = i - 1,
                     .joint = JointKind::ball,
                     .in_parent = {Matrix3d::Identity(), {0, 0, i == 0 ? -0.1 : -0.5}},
                     .mass = 1,
                     .centre = {0, 0, -0.25},
                     .inertia = Matrix3d::Identity()});
    shapes.push_back({collision::Capsule{0.04, 0.5}, i, {Matrix3d::Identity(), {0, 0, -0.25}}});
  }
  const Model model(std::move(links));
  return {.spelling = "chain",
          .info = {},
          .setup = {.system = {.model = model, .start = state_at_zero(model), .handles = {0, 1, 2}},
                    .stepping = {},
                    .shapes = shapes}};
}

Snapshot at_rest(const NamedScene& scene) {
  const Model& model = scene.setup.system.model;
  return {.time = 0, .links = kinematics(model, state_at_zero(model)).pose, .touches = {}};
}

TEST(ScenePicture, WithoutAFloorShowsWhatHangsAndOfALongRodWhatIsNear) {
  const NamedScene scene = hanging_chain();
  const GnuplotPage page = scene_page("", {{&scene, {at_rest(scene)}}});
  const std::vector<Rows> sets = data_sets(page.data);
  EXPECT_TRUE(std::isnan(sets[0].front()[0])) << "a floor";
  EXPECT_TRUE(std::isnan(sets[1].front()[0])) << "a grid";
  // 1.5 m of chain fill the height of a panel, which 100 m of rod would be too wide for.
  const SceneMoments narrow{.scene = &scene, .snapshots = {at_rest(scene)}, .most_width = 300};
  EXPECT_GT(scene_page("", {narrow}).height, 300);
}

TEST(ScenePicture, NeighboursInAChainDifferInColour) {
  const std::vector<SceneBody> bodies = scene_bodies(hanging_chain().setup);
  ASSERT_EQ(bodies.size(), 4u);
  EXPECT_NE(bodies[1].colour, bodies[2].colour);
  EXPECT_EQ(bodies[1].colour, bodies[3].colour);
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
