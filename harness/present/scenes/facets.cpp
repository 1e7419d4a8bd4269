#include "harness/present/scenes/facets.h"

#include <algorithm>

namespace lcp {

namespace {

constexpr double kInPlane = 1e-7;        // m: nearer than this to a plane is in it
constexpr std::size_t kCandidates = 12;  // planes tried for the one that cuts least

struct Plane {
  explicit Plane(const Facet& facet)
      : normal(facet.normal), offset(facet.normal.dot(facet.corners.front())) {}
  double height(const Vector3d& point) const { return normal.dot(point) - offset; }

  Vector3d normal;
  double offset;
};

struct Side {
  bool front = false, back = false;  ///< Has corners there; neither: lies in the plane.
};

Side side_of(const Plane& plane, const Facet& facet) {
  Side side;
  for (const Vector3d& corner : facet.corners) {
    side.front |= plane.height(corner) > kInPlane;
    side.back |= plane.height(corner) < -kInPlane;
  }
  return side;
}

/// The part of a facet that crosses the plane on the plane's side `sign`.
Facet cut(const Facet& facet, const Plane& plane, double sign) {
  Facet part{.corners = {},
             .edge = {},
             .normal = facet.normal,
             .body = facet.body,
             .smooth = facet.smooth};
  const std::size_t count = facet.corners.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d &here = facet.corners[k], &next = facet.corners[(k + 1) % count];
    const double a = sign * plane.height(here), b = sign * plane.height(next);
    if (a >= -kInPlane) {
      part.corners.push_back(here);
      part.edge.push_back(a > kInPlane || b > -kInPlane ? facet.edge[k] : false);
    }
    if ((a > kInPlane && b < -kInPlane) || (a < -kInPlane && b > kInPlane)) {
      part.corners.push_back(here + a / (a - b) * (next - here));
      part.edge.push_back(b > 0 ? facet.edge[k] : false);
    }
  }
  return part;
}

std::size_t least_cutting(const std::vector<Facet>& facets) {
  const std::size_t stride = std::max<std::size_t>(1, facets.size() / kCandidates);
  std::size_t best = 0, fewest = facets.size() + 1;
  for (std::size_t i = 0; i < facets.size() && fewest > 0; i += stride) {
    const Plane plane(facets[i]);
    const std::size_t cuts = std::count_if(facets.begin(), facets.end(), [&](const Facet& facet) {
      const Side side = side_of(plane, facet);
      return side.front && side.back;
    });
    if (cuts < fewest) {
      fewest = cuts;
      best = i;
    }
  }
  return best;
}

void append(std::vector<Facet>& to, std::vector<Facet> from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

}  // namespace

std::vector<Facet> back_to_front(std::vector<Facet> facets, const Vector3d& towards_viewer) {
  if (facets.size() < 2) return facets;
  const Plane plane(facets[least_cutting(facets)]);
  std::vector<Facet> front, in_plane, back;
  for (Facet& facet : facets) {
    const Side side = side_of(plane, facet);
    if (side.front && side.back) {
      front.push_back(cut(facet, plane, 1));
      back.push_back(cut(facet, plane, -1));
    } else {
      (side.front ? front : side.back ? back : in_plane).push_back(std::move(facet));
    }
  }
  if (plane.normal.dot(towards_viewer) < 0) std::swap(front, back);
  std::vector<Facet> ordered = back_to_front(std::move(back), towards_viewer);
  append(ordered, std::move(in_plane));
  append(ordered, back_to_front(std::move(front), towards_viewer));
  return ordered;
}

}  // namespace lcp
