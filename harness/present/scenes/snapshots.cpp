#include "harness/present/scenes/snapshots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lcp {

Snapshots::Snapshots(const std::vector<double>& times, double dt, double duration) {
  const Index last = std::max<Index>(0, std::lround(duration / dt) - 1);
  for (const double time : times) {
    if (!(time >= 0 && time <= duration))
      throw std::invalid_argument(
          fmt::format("a picture at {} s: the simulation goes from 0 to {} s", time, duration));
    wanted_.push_back(std::min<Index>(last, std::lround(time / dt)));
  }
  std::sort(wanted_.begin(), wanted_.end());
  wanted_.erase(std::unique(wanted_.begin(), wanted_.end()), wanted_.end());
}

void Snapshots::look(const Frame& frame) {
  if (!std::binary_search(wanted_.begin(), wanted_.end(), frame.number)) return;
  Snapshot snapshot{.time = frame.state.time, .links = frame.kinematics.pose, .touches = {}};
  for (Index i = 0; i < frame.contacts.size(); ++i)
    snapshot.touches.push_back({frame.points[i].position, frame.force(i)});
  taken_.push_back(std::move(snapshot));
}

std::vector<double> evenly_spread(double duration, Index count) {
  std::vector<double> times;
  for (Index i = 0; i < count; ++i)
    times.push_back(duration * static_cast<double>(i) /
                    static_cast<double>(std::max<Index>(1, count - 1)));
  return times;
}

}  // namespace lcp
