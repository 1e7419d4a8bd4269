#include "harness/studies/loop/drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lcp {

namespace {

/// Of the length of a step: by how much times that are the same may differ by rounding.
constexpr double kSameTime = 1e-6;

/// Reads off what a track held at any time, linearly between frames.
class Reader {
 public:
  explicit Reader(const Track& track) : track_(track) {}

  bool reaches(double time) const {
    return track_.frames() > 0 && time <= track_.time(track_.frames() - 1) + kSameTime * track_.dt;
  }
  /// As it was at the first frame before that.
  VectorXd column(const MatrixXd& values, double time) const {
    const Place at = place(time);
    if (at.share == 0) return values.col(at.frame);
    return (1 - at.share) * values.col(at.frame) + at.share * values.col(at.frame + 1);
  }
  double value(const VectorXd& values, double time) const {
    const Place at = place(time);
    if (at.share == 0) return values(at.frame);
    return (1 - at.share) * values(at.frame) + at.share * values(at.frame + 1);
  }

 private:
  struct Place {
    Index frame;
    double share;  ///< Of the step after it.
  };

  Place place(double time) const {
    const double last = static_cast<double>(track_.frames() - 1);
    const double steps = std::clamp((time - track_.time(0)) / track_.dt, 0.0, last);
    const double nearest = std::round(steps);
    if (std::abs(steps - nearest) < kSameTime) return {static_cast<Index>(nearest), 0};
    return {static_cast<Index>(steps), steps - std::floor(steps)};
  }

  const Track& track_;
};

/// Largest length of the 3-vectors that are stacked in `stacked`.
double largest_of_three(const VectorXd& stacked) {
  double most = 0;
  for (Index i = 0; i + 2 < stacked.size(); i += 3)
    most = std::max(most, stacked.segment<3>(i).norm());
  return most;
}

double mean_of_three(const VectorXd& stacked) {
  double sum = 0;
  for (Index i = 0; i + 2 < stacked.size(); i += 3) sum += stacked.segment<3>(i).norm();
  return stacked.size() > 0 ? 3 * sum / static_cast<double>(stacked.size()) : 0;
}

void require_same_bodies(const Track& track, const Track& reference) {
  if (track.frames() == 0 || reference.frames() == 0) return;
  for (const auto& [what, rows, expected] :
       {std::tuple("centres", track.centres.rows(), reference.centres.rows()),
        {"impulses", track.impulse.rows(), reference.impulse.rows()},
        {"travels", track.travel.rows(), reference.travel.rows()}})
    if (rows != expected)
      throw std::invalid_argument(fmt::format("drift: {} has {} rows of {}, {} has {}", track.scene,
                                              rows, what, reference.scene, expected));
}

}  // namespace

std::vector<Drift> drift(const Track& track, const Track& reference, double window) {
  require_same_bodies(track, reference);
  const Reader here(track), there(reference);
  const Track& coarse = track.dt >= reference.dt ? track : reference;
  const auto given = [window](const Reader& reader, const Track& of, double time) -> VectorXd {
    return reader.column(of.impulse, time) - reader.column(of.impulse, time - window);
  };
  std::vector<Drift> drifts;
  for (const double time : coarse.time) {
    if (!here.reaches(time) || !there.reaches(time)) break;
    const VectorXd apart = here.column(track.centres, time) - there.column(reference.centres, time);
    const VectorXd force = given(here, track, time) - given(there, reference, time);
    const VectorXd slipped = here.column(track.travel, time) - there.column(reference.travel, time);
    const auto differ = [&](const VectorXd& mine, const VectorXd& theirs) {
      return std::abs(here.value(mine, time) - there.value(theirs, time));
    };
    drifts.push_back({.time = time,
                      .distance = largest_of_three(apart),
                      .mean_distance = mean_of_three(apart),
                      .force = largest_of_three(force) / (window * reference.weight),
                      .depth = differ(track.depth, reference.depth),
                      .slip = slipped.size() > 0 ? slipped.cwiseAbs().maxCoeff() : 0,
                      .energy = differ(track.energy, reference.energy)});
  }
  return drifts;
}

Drift largest(const std::vector<Drift>& drifts, double until) {
  Drift most;
  for (const Drift& each : drifts) {
    if (each.time > until) break;
    most.time = each.time;
    for (double Drift::*field : {&Drift::distance, &Drift::mean_distance, &Drift::force,
                                 &Drift::depth, &Drift::slip, &Drift::energy})
      most.*field = std::max(most.*field, each.*field);
  }
  return most;
}

}  // namespace lcp
