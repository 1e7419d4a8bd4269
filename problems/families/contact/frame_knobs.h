#pragma once

#include <fmt/format.h>

#include <string>

#include "problems/contact/frame_series.h"
#include "problems/drawing/random.h"
#include "problems/registry.h"

namespace lcp {

/// The knobs that every contact family has.
struct FrameKnobs {
  double mu = 0.5;
  Index directions = 8;
  FrictionModel::Axes axes = FrictionModel::Axes::fixed;
  double dt = 1e-3;  ///< s.
  /// In its first form, so that corpora stay the same bit for bit while the search changes.
  std::string driver = "best-first:order=row,cost_grid=1e-9,refactor_every=1";

  FrictionModel friction_model() const { return {.directions = directions, .axes = axes}; }
};

/// Appends them to a family's own. `first_direction` says where fixed axes begin, `driver` what the
/// driver is for.
inline OptionTable with_frame_knobs(OptionTable table, FrameKnobs& knobs,
                                    const char* first_direction, const char* driver) {
  table.push_back(real("mu", knobs.mu, 0, 10, "friction coefficient"));
  table.push_back(
      count("directions", knobs.directions, 2, 64, "friction directions per contact, even"));
  table.push_back(choice("axes", knobs.axes,
                         fmt::format("the first direction is {}, or along the slip velocity of a "
                                     "sliding contact",
                                     first_direction)));
  table.push_back(real("dt", knobs.dt, 1e-5, 0.1, "time step, s"));
  table.push_back(text("driver", knobs.driver, driver));
  return table;
}

/// `draw.count` frames that stand alone, from one generator: `frame(random, provenance)` draws one and adds
/// to what is known of it.
inline std::vector<Instance> lone_frames(
    const FrameKnobs& knobs, const Draw& draw,
    const std::function<ContactProblem(Random&, std::map<std::string, std::string>&)>& frame) {
  const NamedSolver driver = make_solver(knobs.driver);
  Random random(draw.seed);
  std::vector<Instance> instances;
  for (Index number = 0; number < draw.count; ++number) {
    std::map<std::string, std::string> provenance;
    const ContactProblem problem = frame(random, provenance);
    instances.push_back(lone_frame(draw.corpus, number, problem, knobs.friction_model(), driver,
                                   std::move(provenance)));
  }
  return instances;
}

/// Components uniform in [-largest, largest).
inline Eigen::Vector3d random_vector(double largest, Random& random) {
  const double x = random.between(-1, 1), y = random.between(-1, 1);
  return largest * Eigen::Vector3d(x, y, random.between(-1, 1));
}

/// What the driver of a series of frames, and of frames on their own, is for.
inline constexpr const char* driver_of_a_series = "solver whose forces lead from frame to frame";
inline constexpr const char* driver_of_lone_frames = "solver that tells which contacts are active";

}  // namespace lcp
