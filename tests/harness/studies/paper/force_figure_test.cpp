#include "harness/studies/paper/force_figure.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "problems/io/errors.h"
#include "tests/harness/present/scenes/xml.h"
#include "tests/harness/studies/paper/pictured_run.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

/// Lines of numbers under a head; what is empty is NaN.
std::vector<std::vector<double>> csv_rows(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line + ",");
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(cell.empty() ? NAN : std::stod(cell));
    rows.push_back(row);
  }
  return rows;
}

void expect_newton(const NamedScene& scene, const std::string& csv, std::size_t frames) {
  ASSERT_TRUE(csv.starts_with(
      "time_s,left_foot_N,right_foot_N,sum_N,left_foot_20ms_N,right_foot_20ms_N,sum_20ms_N,"
      "weight_plus_ma_20ms_N\n"));
  const double weight = scene.setup.system.model.mass() * scene.setup.system.gravity.norm();
  const auto rows = csv_rows(csv);
  ASSERT_EQ(rows.size(), frames);
  std::size_t averaged = 0;
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 8u);
    EXPECT_NEAR(row[1] + row[2], row[3], 1e-6 + 3e-8 * row[3]);  // nine digits
    if (std::isnan(row[6])) continue;
    ++averaged;
    EXPECT_NEAR(row[4] + row[5], row[6], 1e-6 + 3e-8 * row[6]);
    EXPECT_NEAR(row[6], row[7], 0.02 * weight) << "at " << row[0] << " s";
  }
  EXPECT_EQ(averaged, frames - 20);
}

TEST(ForceFigure, FeetAddUpToTheSumAndTheSumToWeightAndAccelerationWithinTwoPercent) {
  const TemporaryDirectory directory;
  const PicturedRun squat = pictured("squat:period=0.3", 0.12, {});
  write_force_figure(squat.run, squat.scene.setup.system.model.mass(),
                     squat.scene.setup.system.gravity, directory.file("forces.svg"));
  expect_newton(squat.scene, read_text(directory.file("forces.csv")), 120);
  const std::string svg = read_text(directory.file("forces.svg"));
  EXPECT_EQ(complaint_about_xml(svg), "");
  for (const char* words : {"left foot", "right foot", "sum", "weight + m a", "time (s)", "(N)"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
}

TEST(ForceFigure, AveragesBelongToTheMiddleOfTheirTwentyMilliseconds) {
  LoopRun run;
  run.dt = 1e-3;
  for (Index i = 0; i < 50; ++i) {
    FrameRecord frame;
    frame.time = 1e-3 * static_cast<double>(i);
    frame.handle_forces = {{0, 0, static_cast<double>(i)}, {0, 0, 1}};
    frame.com_velocity = {0, 0, 2 * frame.time};
    run.frames.push_back(frame);
  }
  const Eigen::MatrixXd forces = vertical_forces(run, 3, {0, 0, -10});
  ASSERT_EQ(forces.cols(), 8) << "time, 2 forces, their sum, 4 averages";
  EXPECT_EQ(forces(12, 1), 12);
  EXPECT_EQ(forces(12, 3), 13);
  const auto averaged = [&](Index frame) { return !forces.row(frame).hasNaN(); };
  EXPECT_FALSE(averaged(9));
  ASSERT_TRUE(averaged(10));
  EXPECT_NEAR(forces(10, 4), 9.5, 1e-12);  // frames 0 to 19
  EXPECT_NEAR(forces(10, 6), 10.5, 1e-12) << "and 1 N";
  EXPECT_NEAR(forces(10, 7), 3 * (2 + 10), 1e-9);
  EXPECT_TRUE(averaged(39));
  EXPECT_FALSE(averaged(40));
}

TEST(ForceFigure, RefusesARunTooShortToAverage) {
  const TemporaryDirectory directory;
  const PicturedRun squat = pictured("squat", 0.01, {});
  EXPECT_THROW(write_force_figure(squat.run, 1, {0, 0, -10}, directory.file("f.svg")),
               std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

}  // namespace
}  // namespace lcp
