#include "harness/present/curve.h"

#include <algorithm>
#include <cmath>

namespace lcp {

double LogRange::pixels(double value, double length) const {
  return length * std::log(value / low) / std::log(high / low);
}

double LogRange::value(double at, double length) const {
  return low * std::pow(high / low, at / length);
}

double Curve::share(double x) const {
  if (counted == 0) return 0;
  const auto risen = std::upper_bound(reached.begin(), reached.end(), x) - reached.begin();
  return static_cast<double>(risen) / static_cast<double>(counted);
}

double Curve::unreached() const {
  if (counted == 0) return 1;
  return 1 - static_cast<double>(reached.size()) / static_cast<double>(counted);
}

std::vector<Pixels> step_corners(const Curve& curve, const LogRange& x, int columns) {
  std::vector<Pixels> corners = {{x.low, curve.share(x.low)}};
  for (int column = 1; column <= columns; ++column) {
    const double at = column == columns ? x.high : x.value(column, columns);
    const double share = curve.share(at);
    if (share == corners.back().y) continue;
    corners.push_back({at, corners.back().y});
    corners.push_back({at, share});
  }
  corners.push_back({x.high, corners.back().y});
  return corners;
}

}  // namespace lcp
