#include "harness/studies/paper/paper_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "problems/io/errors.h"
#include "tests/harness/present/scenes/xml.h"
#include "tests/harness/studies/paper/pictured_run.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

NamedScene short_squat() {
  NamedScene scene = make_scene("squat:swing=1");
  scene.setup.duration = 0.06;
  return scene;
}

TEST(PaperFigures, AreWrittenWithTheirNumbersIntoANewDirectory) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  for (const int figure : {2, 3}) {
    Index looked = 0;
    const LoopRun run = write_figure(
        figure, directory.file("figures"), short_squat(), make_solver("best-first"), {},
        [&](const Simulation&, const Frame&, const FrameRecord&) { ++looked; }, interrupted);
    EXPECT_EQ(looked, 60);
    EXPECT_EQ(run.broken, "");
    const std::string stem = directory.file("figures/fig") + std::to_string(figure);
    EXPECT_EQ(complaint_about_xml(read_text(stem + ".svg")), "");
    const std::string csv = read_text(stem + ".csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 61);
    EXPECT_TRUE(std::filesystem::exists(stem + ".gp"));
    EXPECT_TRUE(std::filesystem::exists(stem + ".dat"));
  }
  const std::string svg = read_text(directory.file("figures/fig3.svg"));
  for (const char* words :
       {"(a) 0.000 s", "(h) 0.059 s", "turn (degrees)", "left foot", "right foot"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
}

TEST(PaperFigures, InterruptedNothingIsWritten) {
  const TemporaryDirectory directory;
  std::atomic<bool> interrupted = false;
  for (const int figure : {2, 3}) {
    interrupted = false;
    const LoopRun run = write_figure(
        figure, directory.file("figures"), short_squat(), make_solver("best-first"), {},
        [&](const Simulation&, const Frame&, const FrameRecord& record) {
          if (record.frame == 30) interrupted = true;
        },
        interrupted);
    EXPECT_EQ(run.broken, "interrupted") << figure;
    EXPECT_TRUE(std::filesystem::is_empty(directory.file("figures"))) << figure;
  }
}

TEST(PaperFigures, RefuseASceneWithoutTwoFeetAndAPlaceThatIsNone) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  for (const int figure : {2, 3}) {
    NamedScene lame = short_squat();
    lame.setup.system.handles.pop_back();
    EXPECT_THROW(write_figure(figure, directory.path(), lame, make_solver("best-first"), {}, {},
                              interrupted),
                 std::invalid_argument);
    write_text(directory.file("in-the-way"), "");
    EXPECT_THROW(write_figure(figure, directory.file("in-the-way/figures"), short_squat(),
                              make_solver("best-first"), {}, {}, interrupted),
                 UnwritableOutput);
  }
}

TEST(PaperFigures, TheFourthShowsThreeMomentsOfHoistRingAndNet) {
  const std::vector<FilmedScene> filmed = figure_4_scenes();
  ASSERT_EQ(filmed.size(), 3u);
  const char* names[] = {"hoist", "ring", "net"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(filmed[i].scene.spelling, names[i]);
    EXPECT_EQ(filmed[i].times.size(), 3u);
    EXPECT_LE(filmed[i].times.back(), filmed[i].scene.setup.duration);
  }
}

TEST(PaperFigures, ARowOfMomentsPerScene) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = false;
  const NamedScene squat = short_squat();
  Index looked = 0;
  const std::vector<LoopRun> runs = write_figure_4(
      directory.file("figures"), {{squat, {0, 0.01, 0.02}, -52}, {squat, {0.03}, 20}},
      make_solver("best-first"), {},
      [&](const Simulation&, const Frame&, const FrameRecord&) { ++looked; }, interrupted);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(looked, 21 + 31) << "each until its last moment";
  const std::string svg = read_text(directory.file("figures/fig4.svg"));
  EXPECT_EQ(complaint_about_xml(svg), "");
  for (const char* words : {"squat, 0.000 s", "squat, 0.010 s", "squat, 0.020 s", "squat, 0.030 s"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  for (const char* other : {"figures/fig4.gp", "figures/fig4.dat", "figures/fig4.png"})
    EXPECT_TRUE(std::filesystem::exists(directory.file(other))) << other;
  const std::string csv = read_text(directory.file("figures/fig4.csv"));
  const auto lines = std::count(csv.begin(), csv.end(), '\n');
  EXPECT_EQ(lines, 1 + 4 * squat.setup.system.model.size()) << "a line per moment and link";
}

TEST(PaperFigures, RowsOfMomentsRefuseTimesBeyondTheSceneAndStopWhenInterrupted) {
  const TemporaryDirectory directory;
  std::atomic<bool> interrupted = false;
  const NamedSolver solver = make_solver("best-first");
  const NamedScene squat = short_squat();
  EXPECT_THROW(write_figure_4(directory.path(), {{squat, {0.07}, 0}}, solver, {}, {}, interrupted),
               std::invalid_argument);
  EXPECT_THROW(write_figure_4(directory.path(), {}, solver, {}, {}, interrupted),
               std::invalid_argument);
  const std::vector<LoopRun> runs = write_figure_4(
      directory.file("figures"), {{squat, {0.02}, 0}, {squat, {0.02}, 0}}, solver, {},
      [&](const Simulation&, const Frame&, const FrameRecord&) { interrupted = true; },
      interrupted);
  EXPECT_EQ(runs.size(), 1u);
  EXPECT_TRUE(std::filesystem::is_empty(directory.file("figures")));
}

}  // namespace
}  // namespace lcp
