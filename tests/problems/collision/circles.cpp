#include "tests/problems/collision/circles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lcp::cases {

namespace {

constexpr int kSamples = 720;
constexpr int kGoldenSteps = 60;

NearestPoints at_angle(const Circle& first, const Circle& second, double angle) {
  const Vector3d p =
      first.pose * Vector3d(first.radius * std::cos(angle), first.radius * std::sin(angle), 0);
  Vector3d in_second = second.pose.R.transpose() * (p - second.pose.p);
  in_second.z() = 0;
  const Vector3d q = second.pose * Vector3d(second.radius * in_second.normalized());
  return {(p - q).norm(), p, q};
}

}  // namespace

std::vector<NearestPoints> nearest_points(const Circle& first, const Circle& second) {
  constexpr double step = 2 * std::numbers::pi / kSamples;
  const auto distance = [&](double angle) { return at_angle(first, second, angle).distance; };
  std::vector<double> samples;
  for (int k = 0; k < kSamples; ++k) samples.push_back(distance(k * step));
  std::vector<NearestPoints> found;
  for (int k = 0; k < kSamples; ++k) {
    if (samples[k] >= samples[(k + 1) % kSamples] ||
        samples[k] > samples[(k + kSamples - 1) % kSamples])
      continue;
    double low = (k - 1) * step, high = (k + 1) * step;
    for (int i = 0; i < kGoldenSteps; ++i) {
      constexpr double share = 0.3819660112501051;
      const double a = low + share * (high - low), b = high - share * (high - low);
      (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
    }
    found.push_back(at_angle(first, second, (low + high) / 2));
  }
  std::sort(found.begin(), found.end(),
            [](const NearestPoints& a, const NearestPoints& b) { return a.distance < b.distance; });
  return found;
}

}  // namespace lcp::cases
