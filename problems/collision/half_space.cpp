#include <cmath>

#include "problems/collision/colliders.h"

namespace lcp::collision {

namespace {

/// Sine of the angle under which a disc lies flat, so that it has no lowest point.
constexpr double kFlat = 1e-9;

/// The points of a solid that may be below the plane.
class Below {
 public:
  Below(const Placed& half_space, const Placed& solid, std::vector<Touch>& touches)
      : origin_(half_space.pose.p),
        up_(half_space.pose.R.col(2)),
        solid_(solid),
        touches_(touches) {}

  void operator()(const HalfSpace&) const {}
  void operator()(const Sphere& sphere) const { add(solid_.pose.p, 0, sphere.radius); }
  void operator()(const Capsule& capsule) const {
    const Vector3d half = solid_.pose.R.col(2) * capsule.length / 2;
    add(solid_.pose.p - half, 0, capsule.radius);
    if (capsule.length > 0) add(solid_.pose.p + half, 1, capsule.radius);
  }
  void operator()(const Ring& ring) const {
    for (std::size_t i = 0; i < solid_.corners.size(); ++i)
      add(solid_.corners[i], static_cast<Index>(i), ring.radius);
  }
  void operator()(const Box& box) const {
    constexpr Index corners = 8;
    for (Index i = 0; i < corners; ++i) {
      const Vector3d signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      add(solid_.pose * Vector3d(signs.cwiseProduct(box.edges) / 2), i, 0);
    }
  }
  void operator()(const Cylinder& cylinder) const {
    const Vector3d axis = solid_.pose.R.col(2);
    const Vector3d half = axis * cylinder.length / 2;
    Vector3d down = axis * axis.dot(up_) - up_;
    if (down.norm() < kFlat) down = solid_.pose.R.col(0);
    down = cylinder.radius * down.normalized();
    const Vector3d aside = axis.cross(down);
    const bool first_is_lower = axis.dot(up_) >= 0;
    for (const bool first : {true, false}) {
      const Vector3d centre =
          first ? Vector3d(solid_.pose.p - half) : Vector3d(solid_.pose.p + half);
      const Index feature = first ? 0 : kPointsOfRim;
      add(centre + down, feature, 0);
      if (first != first_is_lower) continue;
      add(centre + aside, feature + 1, 0);
      add(centre - down, feature + 2, 0);
      add(centre - aside, feature + 3, 0);
    }
  }
  void operator()(const Mesh& mesh) const {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      add(solid_.pose * mesh.vertices[i], static_cast<Index>(i), 0);
  }

 private:
  static constexpr Index kPointsOfRim = 4;

  void add(const Vector3d& centre, Index feature, double radius) const {
    const double depth = radius - up_.dot(centre - origin_);
    if (depth >= 0) touches_.push_back({centre + (depth / 2 - radius) * up_, -up_, depth, feature});
  }

  Vector3d origin_, up_;
  const Placed& solid_;
  std::vector<Touch>& touches_;
};

}  // namespace

void half_space_on_solid(const Placed& half_space, const Placed& solid,
                         std::vector<Touch>& touches) {
  std::visit(Below(half_space, solid, touches), *solid.geometry);
}

}  // namespace lcp::collision
