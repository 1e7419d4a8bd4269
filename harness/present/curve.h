#pragma once

#include <vector>

#include "harness/present/tag_placement.h"
#include "solvers/problem.h"

namespace lcp {

/// A logarithmic axis.
struct LogRange {
  double low = 1;
  double high = 10;
  /// Position of `value` on an axis of `length` pixels, and back.
  double pixels(double value, double length) const;
  double value(double at, double length) const;
};

/// A share that grows in steps: at the k-th value of `reached` it rises to k / counted.
struct Curve {
  Index counted = 0;
  std::vector<double> reached;  ///< Ascending, finite.

  double share(double x) const;
  /// The part that never rises: 1 - the last step; 1 where nothing is counted.
  double unreached() const;
};

/// The corners of a curve's steps from one end of `x` to the other, no more than `columns` of them
/// apart: enough for a picture. Shares, not counts.
std::vector<Pixels> step_corners(const Curve& curve, const LogRange& x, int columns);

}  // namespace lcp
