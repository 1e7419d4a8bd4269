#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/studies/loop/in_the_loop.h"

namespace lcp {

/// Vertical contact forces of one frame, N.
struct VerticalForces {
  /// Averages over the 20 ms around the frame.
  struct Mean {
    std::vector<double> handles;
    double sum = 0;
    /// Weight plus mass times the acceleration of the centre of mass, which the sum should be: from
    /// the change of the centre's velocity over the same 20 ms.
    double expected = 0;
  };

  double time = 0;  ///< s.
  std::vector<double> handles;
  double sum = 0;
  std::optional<Mean> mean;  ///< Not within 10 ms of the start and the end.
};

/// Of every frame. `mass` of the system in kg, `gravity` in m/s^2.
std::vector<VerticalForces> vertical_forces(const LoopRun& run, double mass,
                                            const Vector3d& gravity);

/// What the handles of a scene are called in figures: two of them are the left and the right foot.
std::vector<std::string> handle_names(std::size_t handles);

/// A line per frame, times in s and forces in N; averages are empty where there are none.
std::string forces_csv(const std::vector<VerticalForces>& forces);

/// Draws the vertical force of each handle, and below it their sum against weight + m a: 20 ms
/// averages as bold lines over the forces of single frames. Writes `svg` with .csv, .gp and .dat
/// beside it. Throws as draw_with_gnuplot does, and std::invalid_argument when the run is shorter
/// than 20 ms.
void write_force_figure(const LoopRun& run, double mass, const Vector3d& gravity,
                        const std::filesystem::path& svg);

}  // namespace lcp
