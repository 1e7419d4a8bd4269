#include "harness/present/tag_placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lcp {

namespace {

constexpr double marker_size = 9;
constexpr double first_radius = 13, radius_step = 8;
constexpr int directions = 16;

bool overlap(const TagBox& a, const TagBox& b) {
  return std::abs(a.centre.x - b.centre.x) < (a.size.x + b.size.x) / 2 &&
         std::abs(a.centre.y - b.centre.y) < (a.size.y + b.size.y) / 2;
}

bool inside(const TagBox& box, Pixels area) {
  return box.centre.x >= box.size.x / 2 && box.centre.x <= area.x - box.size.x / 2 &&
         box.centre.y >= box.size.y / 2 && box.centre.y <= area.y - box.size.y / 2;
}

/// The k-th place on a circle, from the upper right on.
Pixels around(Pixels marker, double radius, int k) {
  const double angle = std::numbers::pi * (0.25 + 2.0 * k / directions);
  return {marker.x + radius * std::cos(angle), marker.y + radius * std::sin(angle)};
}

}  // namespace

double nearest_tag_distance() { return first_radius; }

std::vector<Pixels> place_tags(const std::vector<Pixels>& markers,
                               const std::vector<TagBox>& obstacles, Pixels area, Pixels tag) {
  std::vector<TagBox> taken = obstacles;
  for (const Pixels& marker : markers) taken.push_back({marker, {marker_size, marker_size}});
  const auto free = [&](const TagBox& box) {
    return inside(box, area) && std::none_of(taken.begin(), taken.end(), [&](const TagBox& other) {
             return overlap(box, other);
           });
  };
  const auto place = [&](Pixels marker) {
    for (double radius = first_radius; radius < std::hypot(area.x, area.y); radius += radius_step)
      for (int k = 0; k < directions; ++k)
        if (const Pixels centre = around(marker, radius, k); free({centre, tag})) return centre;
    return around(marker, first_radius, 0);
  };
  std::vector<Pixels> tags;
  for (const Pixels& marker : markers) {
    tags.push_back(place(marker));
    taken.push_back({tags.back(), tag});
  }
  return tags;
}

}  // namespace lcp
