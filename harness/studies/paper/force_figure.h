#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/studies/loop/in_the_loop.h"

namespace lcp {

/// Vertical contact forces, a row per frame: its time (s), the force on each handle and their sum
/// (N), and, with n handles from column n + 2 on, the averages of these over the 20 ms around the
/// frame, and last what the average sum should be: weight plus mass times the acceleration of the
/// centre of mass, from the change of the centre's velocity over the same 20 ms. Averages are NaN
/// within 10 ms of the start and the end. `mass` of the system in kg, `gravity` in m/s^2.
Eigen::MatrixXd vertical_forces(const LoopRun& run, double mass, const Vector3d& gravity);

/// What the handles of a scene are called in figures: two of them are the left and the right foot.
std::vector<std::string> handle_names(std::size_t handles);

/// The same in heads of columns: no blanks.
std::vector<std::string> handle_columns(std::size_t handles);

/// The rows of vertical_forces under a head; averages are empty where there are none.
std::string forces_csv(const Eigen::MatrixXd& forces);

/// Draws the vertical force of each handle, and below it their sum against weight + m a: 20 ms
/// averages as bold lines over the forces of single frames. Writes `svg` with .csv, .gp and .dat
/// beside it. Throws as draw_with_gnuplot does, and std::invalid_argument when the run is shorter
/// than 20 ms.
void write_force_figure(const LoopRun& run, double mass, const Vector3d& gravity,
                        const std::filesystem::path& svg);

}  // namespace lcp
