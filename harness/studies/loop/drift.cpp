#include "harness/studies/loop/drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace lcp {

namespace {

/// Of the length of a step: by how much times that are the same may differ by rounding.
constexpr double kSameTime = 1e-6;

/// Reads off what a track held at any time, linearly between frames.
struct Reader {
  const Track& track;

  bool reaches(double time) const {
    return track.frames() > 0 && time <= track.time(track.frames() - 1) + kSameTime * track.dt;
  }
  /// A number, or a column; before the first frame as in that.
  template <class Values>
  auto at(Values Track::*values, double time) const {
    const auto in_frame = [&](Index frame) {
      if constexpr (std::is_same_v<Values, VectorXd>)
        return (track.*values)(frame);
      else
        return VectorXd((track.*values).col(frame));
    };
    const double last = static_cast<double>(track.frames() - 1);
    const double steps = std::clamp((time - track.time(0)) / track.dt, 0.0, last);
    const double nearest = std::round(steps), share = steps - std::floor(steps);
    if (std::abs(steps - nearest) < kSameTime) return in_frame(static_cast<Index>(nearest));
    const Index frame = static_cast<Index>(steps);
    return decltype(in_frame(0))((1 - share) * in_frame(frame) + share * in_frame(frame + 1));
  }
};

/// Lengths of the 3-vectors that are stacked in `stacked`.
VectorXd lengths_of_three(const VectorXd& stacked) {
  VectorXd lengths(stacked.size() / 3);
  for (Index i = 0; i < lengths.size(); ++i) lengths(i) = stacked.segment<3>(3 * i).norm();
  return lengths;
}

double largest_or_0(const VectorXd& values) { return values.size() > 0 ? values.maxCoeff() : 0; }

/// Of lengths of 3-vectors: 3 times their sum over the number of components, whose bits committed results
/// hold.
double mean_or_0(const VectorXd& values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return values.size() > 0 ? 3 * sum / static_cast<double>(3 * values.size()) : 0;
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
  const Reader here{track}, there{reference};
  const auto difference = [&](auto values, double time) -> decltype(here.at(values, time)) {
    return here.at(values, time) - there.at(values, time);
  };
  const auto given = [window](const Reader& reader, double time) -> VectorXd {
    return reader.at(&Track::impulse, time) - reader.at(&Track::impulse, time - window);
  };
  std::vector<Drift> drifts;
  for (const double time : (track.dt >= reference.dt ? track : reference).time) {
    if (!here.reaches(time) || !there.reaches(time)) break;
    const VectorXd apart = lengths_of_three(difference(&Track::centres, time));
    const VectorXd force = lengths_of_three(given(here, time) - given(there, time));
    const VectorXd slipped = difference(&Track::travel, time);
    drifts.push_back({.time = time,
                      .distance = largest_or_0(apart),
                      .mean_distance = mean_or_0(apart),
                      .force = largest_or_0(force) / (window * reference.weight),
                      .depth = std::abs(difference(&Track::depth, time)),
                      .slip = largest_or_0(slipped.cwiseAbs()),
                      .energy = std::abs(difference(&Track::energy, time))});
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
