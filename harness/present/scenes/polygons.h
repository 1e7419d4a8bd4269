#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace lcp {

using Eigen::Vector2d;

/// Corners in the picture plane, m.
using Polygon = std::vector<Vector2d>;

/// The corners of the convex hull, counterclockwise.
Polygon convex_hull(Polygon points);

double area(const Polygon& polygon);

/// The area of the points' convex hull over its length.
double thickness(const Polygon& points);

/// What two convex polygons, counterclockwise, share; empty where nothing.
Polygon common_part(const Polygon& a, const Polygon& b);

/// The line from a to b; its ends stand out by `longer`.
Polygon stroke(const Vector2d& a, const Vector2d& b, double width, double longer);

struct Line {
  Vector2d a, b;
};

/// Lines as few polygons of that width; they join where ends are equal, and count once.
std::vector<Polygon> strokes(std::vector<Line> lines, double width);

/// A convex polygon, counterclockwise, with its corners farther out by about `by`.
Polygon widened(const Polygon& polygon, double by);

}  // namespace lcp
