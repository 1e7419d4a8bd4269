#include "harness/present/scenes/hidden_facets.h"

#include <algorithm>
#include <cmath>

#include "problems/collision/signed_distance.h"

namespace lcp {

namespace {

constexpr double kShared = 1e-6;  // over a body's size: as far outside, a corner is on its surface
constexpr double kWithin = 0.02;  // likewise inside: it is within what is drawn of it

bool is_solid(const collision::Geometry& geometry) {
  return std::holds_alternative<collision::Sphere>(geometry) ||
         std::holds_alternative<collision::Capsule>(geometry) ||
         std::holds_alternative<collision::Box>(geometry) ||
         std::holds_alternative<collision::Cylinder>(geometry);
}

/// The solids are convex: what has its corners inside is inside.
bool hides(const PlacedGeometry& body, double margin, const Facet& facet) {
  return std::all_of(facet.corners.begin(), facet.corners.end(), [&](const Vector3d& corner) {
    const Vector3d inside = body.pose.R.transpose() * (corner - body.pose.p);
    return collision::signed_distance(*body.geometry, inside).distance <= margin;
  });
}

}  // namespace

void drop_hidden(std::vector<Piece>& pieces, const std::vector<PlacedGeometry>& bodies) {
  std::vector<double> radius;
  for (const PlacedGeometry& body : bodies)
    radius.push_back(is_solid(*body.geometry) ? collision::bounding_radius(*body.geometry) : 0);
  const auto hidden = [&](const Facet& facet) {
    if (!facet.smooth) return false;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (i == facet.body) continue;
      if ((facet.corners.front() - bodies[i].pose.p).norm() > (1 + kShared) * radius[i]) continue;
      if (hides(bodies[i], (i < facet.body ? kShared : -kWithin) * radius[i], facet)) return true;
    }
    return false;
  };
  for (Piece& piece : pieces) std::erase_if(piece, hidden);
  std::erase_if(pieces, [](const Piece& piece) { return piece.empty(); });
}

}  // namespace lcp
