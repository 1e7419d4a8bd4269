#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "harness/present/scenes/camera.h"
#include "harness/present/scenes/facets.h"

namespace lcp {

/// How near to the viewer the facet is where the viewer sees `at`; nothing beside it.
inline std::optional<double> nearness(const Facet& facet, const Camera& camera,
                                      const Eigen::Vector2d& at) {
  const std::size_t count = facet.corners.size();
  bool left = true, right = true;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector2d a = camera.flat(facet.corners[k]);
    const Eigen::Vector2d b = camera.flat(facet.corners[(k + 1) % count]);
    const double turn = (b - a).x() * (at - a).y() - (b - a).y() * (at - a).x();
    left &= turn > 0;
    right &= turn < 0;
  }
  if (!left && !right) return std::nullopt;
  const Vector3d start = at.x() * camera.right + at.y() * camera.up;
  return facet.normal.dot(facet.corners.front() - start) / facet.normal.dot(camera.towards_viewer);
}

/// Looks at points `step` apart around the middle of the picture, as far as `reach`: where facets
/// of `all` are seen, the last of `painted` there must be the nearest. Returns the number of such
/// points.
inline int expect_nearest_on_top(const std::vector<Facet>& all, const std::vector<Facet>& painted,
                                 const Camera& camera, double reach, double step) {
  int seen = 0;
  for (double x = -reach; x < reach; x += step)
    for (double y = -reach; y < reach; y += step) {
      std::optional<double> nearest, last;
      for (const Facet& face : all) {
        const std::optional<double> here = nearness(face, camera, {x, y});
        if (here && (!nearest || *here > *nearest)) nearest = here;
      }
      for (const Facet& facet : painted)
        if (const std::optional<double> here = nearness(facet, camera, {x, y})) last = here;
      EXPECT_EQ(nearest.has_value(), last.has_value()) << x << ' ' << y;
      if (!nearest || !last) continue;
      EXPECT_NEAR(*last, *nearest, 1e-6) << x << ' ' << y;
      ++seen;
    }
  return seen;
}

}  // namespace lcp
