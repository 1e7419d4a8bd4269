#pragma once

#include <vector>

#include "harness/studies/loop/track.h"

namespace lcp {

/// How far a simulation is from another one of the same bodies at one instant.
struct Drift {
  double time = 0;           ///< s.
  double distance = 0;       ///< Largest between the two places of a link's centre of mass, m.
  double mean_distance = 0;  ///< Of links' centres of mass, mean over the links, m.
  /// Difference of the contact forces on a mechanism, averaged over the time window that ends here
  /// (nothing acts before the start), over the weight of all; of the mechanism where it is largest.
  double force = 0;
  double depth = 0;   ///< Of the largest overlap, absolute difference, m.
  double slip = 0;    ///< Of the way slipped so far, of the handle where it is largest, m.
  double energy = 0;  ///< Absolute difference, J.
};

/// At each frame of the one with longer steps, up to where both reach; the other's values are
/// interpolated linearly where it has no frame at that time. `window` is in s. Throws std::invalid_argument when the two
/// are not of the same links, mechanisms and handles.
std::vector<Drift> drift(const Track& track, const Track& reference, double window);

/// The largest of each, up to time `until` (s); its time is that of the last one looked at.
Drift largest(const std::vector<Drift>& drifts, double until);

}  // namespace lcp
