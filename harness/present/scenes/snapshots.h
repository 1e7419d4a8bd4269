#pragma once

#include <vector>

#include "problems/rigid/simulation.h"

namespace lcp {

/// What a picture shows of one moment of a simulation.
struct Snapshot {
  struct Touch {
    Vector3d position;  ///< World, m.
    Vector3d force;     ///< On the first body of the contact, N, world axes.
  };

  double time = 0;          ///< s.
  std::vector<Pose> links;  ///< In the world.
  std::vector<Touch> touches;
};

/// Keeps the frames of a simulation that are nearest to given times.
class Snapshots {
 public:
  /// Throws std::invalid_argument naming the first of `times` (s) outside [0, duration]. The end
  /// stands for the last frame, at duration - dt.
  Snapshots(const std::vector<double>& times, double dt, double duration);

  /// To be shown every frame.
  void look(const Frame& frame);

  /// In the order of time; fewer than asked for where the simulation has not come that far, or where
  /// times share a frame.
  const std::vector<Snapshot>& taken() const { return taken_; }

 private:
  std::vector<Index> wanted_;  ///< Numbers of frames, ascending.
  std::vector<Snapshot> taken_;
};

/// `count` times at equal distances from start to end.
std::vector<double> evenly_spread(double duration, Index count);

}  // namespace lcp
