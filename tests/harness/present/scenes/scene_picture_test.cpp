#include "harness/present/scenes/scene_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include "harness/present/scenes/scene_bodies.h"
#include "harness/present/scenes/scene_panels.h"
#include "problems/io/errors.h"
#include "problems/rigid/kinematics.h"
#include "tests/harness/studies/paper/pictured_run.h"
#include "tests/harness/present/scenes/xml.h"
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

TEST(ScenePicture, HasAPanelPerTimeWithEveryBodyAndEveryArrow) {
  const PicturedRun squat = pictured("squat:swing=1", 0.06, {0, 0.03, 0.06});
  ASSERT_EQ(squat.snapshots.size(), 3u);
  const std::vector<Rows> sets = data_sets(ScenePanels(squat.scene, squat.snapshots, {}).data());
  ASSERT_EQ(sets.size(), 3 * ScenePanels::sets_per_panel);
  const std::size_t bodies = scene_bodies(squat.scene.setup).size();
  std::size_t arrows = 0;
  for (std::size_t panel = 0; panel < 3; ++panel) {
    const std::size_t set = ScenePanels::sets_per_panel * panel;
    std::set<double> shadows, surfaces;
    for (const auto& row : sets[set]) shadows.insert(row[3]);
    for (const auto& row : sets[set + 2]) surfaces.insert(row[3]);
    EXPECT_EQ(shadows.size(), bodies);
    EXPECT_EQ(surfaces.size(), bodies);
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

TEST(ScenePicture, LinksWithoutAShapeAreBones) {
  NamedScene scene = make_scene("squat");
  scene.setup.shapes.clear();
  EXPECT_EQ(scene_bodies(scene.setup).size(), 24u) << "20 to the children's joints, 4 at the ends";
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
  const ScenePanels panels(scene, {at_rest(scene)}, {});
  const std::vector<Rows> sets = data_sets(panels.data());
  EXPECT_TRUE(std::isnan(sets[0].front()[0])) << "a floor";
  EXPECT_TRUE(std::isnan(sets[1].front()[0])) << "a grid";
  Eigen::AlignedBox2d seen;
  std::set<double> bodies;
  for (const auto& row : sets[2]) {
    seen.extend(Vector2d(row[0], row[1]));
    bodies.insert(row[3]);
  }
  EXPECT_EQ(bodies.size(), 4u);
  EXPECT_LT(seen.min().y(), -1.5) << "the end of the chain";
  EXPECT_LT(seen.sizes().x(), 2) << "of 100 m of rod";
  EXPECT_GT(seen.sizes().x(), 0.5);
}

TEST(ScenePicture, NeighboursInAChainDifferInColour) {
  const std::vector<SceneBody> bodies = scene_bodies(hanging_chain().setup);
  ASSERT_EQ(bodies.size(), 4u);
  EXPECT_NE(bodies[1].colour, bodies[2].colour);
  EXPECT_EQ(bodies[1].colour, bodies[3].colour);
}

TEST(ScenePicture, AFloorIsTheHalfSpaceBelowZeroAndNoOther) {
  SceneSetup setup = make_scene("squat").setup;
  EXPECT_TRUE(has_floor(setup));
  setup.shapes = {{.geometry = collision::HalfSpace{}}};
  setup.shapes.front().in_link.p.z() = -1;
  EXPECT_FALSE(has_floor(setup));
  setup.shapes.front().in_link = {Eigen::AngleAxisd(0.1, Vector3d::UnitX()).matrix(), {0, 0, 0}};
  EXPECT_FALSE(has_floor(setup));
  EXPECT_EQ(scene_bodies(setup).size(), 24u) << "a slope is not drawn";
}

TEST(ScenePicture, WhatIsFixedInTheWorldStaysWhereItIs) {
  NamedScene scene = make_scene("squat");
  const Pose pose{Matrix3d::Identity(), {1, 2, 3}};
  scene.setup.shapes = {{collision::Box{{1, 1, 1}}, Link::world, pose}};
  EXPECT_EQ(scene_bodies(scene.setup).front().in_world(Snapshot{}).p, pose.p);
}

TEST(ScenePicture, OfABeamWhatIsNearARegionStaysInPlace) {
  const collision::Shape beam{collision::Box{{100, 1, 1}}, Link::world, {Matrix3d::Identity(), {}}};
  const collision::Shape near = near_part(beam, {Vector3d(10, -1, -1), Vector3d(14, 1, 1)});
  EXPECT_NEAR((near.in_link.p - Vector3d(12, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(std::get<collision::Box>(near.geometry).edges.x(), 6, 1e-12) << "4 m, and 1 m around";
  EXPECT_EQ(std::get<collision::Box>(near.geometry).edges.y(), 1);
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
