#include "harness/present/scenes/polygons.h"

#include <algorithm>

namespace lcp {

namespace {

constexpr double kLongestMitre = 2;  // over half the width

double turn(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Vector2d left_of(const Vector2d& direction) { return {-direction.y(), direction.x()}; }

bool same(const Line& one, const Line& other) {
  return (one.a == other.a && one.b == other.b) || (one.a == other.b && one.b == other.a);
}

/// Takes a walk along lines, from an end where there is one; removes them.
Polygon taken_path(std::vector<Line>& lines) {
  const auto ends_at = [&](const Vector2d& point) {
    return std::count_if(lines.begin(), lines.end(),
                         [&](const Line& line) { return line.a == point || line.b == point; });
  };
  Polygon path = {lines.front().a};
  for (const Line& line : lines)
    for (const Vector2d& point : {line.a, line.b})
      if (ends_at(point) % 2 == 1) path.front() = point;
  while (true) {
    const auto next = std::find_if(lines.begin(), lines.end(), [&](const Line& line) {
      return line.a == path.back() || line.b == path.back();
    });
    if (next == lines.end()) return path;
    path.push_back(next->a == path.back() ? next->b : next->a);
    lines.erase(next);
  }
}

/// Half the width to the left of a corner between two directions, mitred.
Vector2d mitre(const Vector2d& before, const Vector2d& after, double half) {
  const Vector2d middle = left_of(before) + left_of(after);
  const double length = middle.norm();
  if (length < 1e-9) return half * left_of(before);
  return middle / length * half * std::min(kLongestMitre, 2 / length);
}

Polygon band(const Polygon& path, double width) {
  const std::size_t count = path.size();
  const bool closed = count > 2 && path.front() == path.back();
  const auto direction = [&](std::size_t k) -> Vector2d {
    return (path[k + 1] - path[k]).normalized();
  };
  Polygon left, right;
  for (std::size_t k = 0; k < count; ++k) {
    const bool first = k == 0, last = k + 1 == count;
    const Vector2d before = first ? direction(closed ? count - 2 : 0) : direction(k - 1);
    const Vector2d after = last ? direction(closed ? 0 : k - 1) : direction(k);
    const Vector2d out = mitre(before, after, width / 2);
    const Vector2d longer = closed || !(first || last)
                                ? Vector2d(0, 0)
                                : Vector2d((first ? -0.5 : 0.5) * width * (first ? after : before));
    left.push_back(path[k] + longer + out);
    right.push_back(path[k] + longer - out);
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  return left;
}

}  // namespace

Polygon convex_hull(Polygon points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  // Lower chain from left to right, then the upper one back (A. Andrew, 1979).
  Polygon hull;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t start = hull.size();
    for (const Vector2d& point : points) {
      while (hull.size() >= start + 2 &&
             turn(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    sum += turn(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]) / 2;
  return sum;
}

double thickness(const Polygon& points) {
  const Polygon hull = convex_hull(points);
  double longest = 0;
  for (const Vector2d& a : hull)
    for (const Vector2d& b : hull) longest = std::max(longest, (a - b).norm());
  return longest > 0 ? area(hull) / longest : 0;
}

Polygon common_part(const Polygon& a, const Polygon& b) {
  Polygon common = a;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const Vector2d& from = b[i];
    const Vector2d inwards = left_of(b[(i + 1) % b.size()] - from);
    const Polygon whole = std::move(common);
    common = {};
    for (std::size_t k = 0; k < whole.size(); ++k) {
      const Vector2d &here = whole[k], &next = whole[(k + 1) % whole.size()];
      const double x = inwards.dot(here - from), y = inwards.dot(next - from);
      if (x >= 0) common.push_back(here);
      if ((x > 0 && y < 0) || (x < 0 && y > 0))
        common.push_back(here + x / (x - y) * (next - here));
    }
  }
  return common;
}

Polygon stroke(const Vector2d& a, const Vector2d& b, double width, double longer) {
  const Vector2d direction = (b - a).normalized();
  const Vector2d along = longer * direction;
  const Vector2d across = width / 2 * left_of(direction);
  return {a - along - across, b + along - across, b + along + across, a - along + across};
}

std::vector<Polygon> strokes(std::vector<Line> lines, double width) {
  std::erase_if(lines, [](const Line& line) { return line.a == line.b; });
  for (std::size_t i = 0; i < lines.size(); ++i)
    lines.erase(std::remove_if(lines.begin() + static_cast<std::ptrdiff_t>(i) + 1, lines.end(),
                               [&](const Line& other) { return same(lines[i], other); }),
                lines.end());
  std::vector<Polygon> all;
  while (!lines.empty()) all.push_back(band(taken_path(lines), width));
  return all;
}

Polygon widened(const Polygon& polygon, double by) {
  const std::size_t count = polygon.size();
  Polygon wide;
  for (std::size_t k = 0; k < count; ++k) {
    const Vector2d before = (polygon[k] - polygon[(k + count - 1) % count]).normalized();
    const Vector2d after = (polygon[(k + 1) % count] - polygon[k]).normalized();
    wide.push_back(polygon[k] - mitre(before, after, by));
  }
  return wide;
}

}  // namespace lcp
