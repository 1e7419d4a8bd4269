#include "harness/present/scenes/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace lcp {

namespace {

// Facets around; more would not show in pictures of that size.
constexpr std::size_t kAroundSphere = 12, kAroundCapsule = 7, kAroundCylinder = 24, kAroundWire = 6;
constexpr double kBend = std::numbers::pi / 180 * 15;    // of a wire, less than which is not shown
constexpr double kLongestMitre = 2;                      // over the wire's radius
constexpr double kCrease = std::numbers::pi / 180 * 40;  // between triangles: an edge

/// Points once around a body, counterclockwise about the direction to the next loop.
using Loop = std::vector<Vector3d>;

/// Twice a polygon's area along its normal.
Vector3d area_vector(const std::vector<Vector3d>& corners) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k)
    sum += (corners[k] - corners[0]).cross(corners[(k + 1) % corners.size()] - corners[0]);
  return sum;
}

/// Leaves out what has no area.
void add_facet(Piece& piece, std::vector<Vector3d> corners, bool smooth) {
  const Vector3d normal = area_vector(corners).normalized();
  if (corners.size() < 3 || !normal.allFinite() || normal.isZero()) return;
  const std::size_t count = corners.size();
  piece.push_back({.corners = std::move(corners),
                   .edge = std::vector<bool>(count, !smooth),
                   .normal = normal,
                   .smooth = smooth});
}

/// The facets from one loop to another, of which point k faces point k + `shift`; a loop may shrink
/// to a point.
void add_band(Piece& piece, const Loop& lower, const Loop& upper, std::size_t shift = 0) {
  const std::size_t count = lower.size();
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<Vector3d> corners = {lower[k], lower[(k + 1) % count],
                                     upper[(k + 1 + shift) % count], upper[(k + shift) % count]};
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    add_facet(piece, std::move(corners), true);
  }
}

Vector3d on_circle(const Vector3d& u, const Vector3d& v, std::size_t k, std::size_t around) {
  const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(around);
  return std::cos(angle) * u + std::sin(angle) * v;
}

Loop circle(double radius, double z, std::size_t around) {
  Loop loop;
  for (std::size_t k = 0; k < around; ++k)
    loop.push_back(radius * on_circle(Vector3d::UnitX(), Vector3d::UnitY(), k, around) +
                   z * Vector3d::UnitZ());
  return loop;
}

/// Half spheres have `rings` of facets from their equators to their poles.
Piece capsule(double radius, double length, std::size_t around, int rings) {
  std::vector<Loop> loops;
  for (const double side : {-1.0, 1.0}) {
    const double end = side * length / 2;
    std::vector<Loop> half = {circle(radius, end, around)};
    for (int i = 1; i < rings; ++i) {
      const double latitude = std::numbers::pi / 2 * i / rings;
      half.push_back(
          circle(radius * std::cos(latitude), end + side * radius * std::sin(latitude), around));
    }
    half.push_back(Loop(around, Vector3d(0, 0, end + side * radius)));
    if (side < 0) std::reverse(half.begin(), half.end());
    loops.insert(loops.end(), half.begin(), half.end());
  }
  Piece piece;
  for (std::size_t i = 0; i + 1 < loops.size(); ++i) add_band(piece, loops[i], loops[i + 1]);
  return piece;
}

Piece cylinder(double radius, double length) {
  const Loop lower = circle(radius, -length / 2, kAroundCylinder);
  const Loop upper = circle(radius, length / 2, kAroundCylinder);
  Piece piece;
  add_band(piece, lower, upper);
  add_facet(piece, upper, false);
  add_facet(piece, {lower.rbegin(), lower.rend()}, false);
  return piece;
}

Piece box(const Vector3d& edges) {
  const Vector3d high = edges / 2;
  Piece piece;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      std::vector<Vector3d> corners;
      for (int k = 0; k < 4; ++k) {
        Vector3d corner = upper ? high : Vector3d(-high);
        const int u = (axis + (upper ? 1 : 2)) % 3, v = 3 - axis - u;
        corner(u) = k == 1 || k == 2 ? high(u) : -high(u);
        corner(v) = k >= 2 ? high(v) : -high(v);
        corners.push_back(corner);
      }
      add_facet(piece, std::move(corners), false);
    }
  return piece;
}

/// Tubes from corner to corner that meet in mitres.
class Wire {
 public:
  explicit Wire(const collision::Ring& ring) : ring_(ring), count_(ring.corners.size()) {
    Vector3d u = along(0).unitOrthogonal();
    const Vector3d first = u, across = along(0).cross(u);
    for (std::size_t i = 0; i < count_; ++i) {
      loops_.push_back(mitre(i, u));
      u = Eigen::Quaterniond::FromTwoVectors(along(i), along(i + 1)) * u;
    }
    // Carried round once, u comes back turned.
    const double turn = std::atan2(u.dot(across), u.dot(first)) / (2 * std::numbers::pi);
    const Index around = kAroundWire;
    shift_ = static_cast<std::size_t>(std::lround(turn * static_cast<double>(around)) + around) %
             kAroundWire;
  }

  std::vector<Piece> pieces() const {
    std::vector<Piece> pieces(count_);
    for (std::size_t i = 0; i < count_; ++i)
      add_band(pieces[i], loops_[i], loops_[(i + 1) % count_], i + 1 == count_ ? shift_ : 0);
    return pieces;
  }

 private:
  Vector3d segment(std::size_t i) const {
    return ring_.corners[(i + 1) % count_] - ring_.corners[i % count_];
  }
  Vector3d along(std::size_t i) const { return segment(i).normalized(); }

  /// Where the tube of segment i is cut at its beginning; `u` is normal to the segment. Sharp turns
  /// and short segments end the mitre early.
  Loop mitre(std::size_t i, const Vector3d& u) const {
    const std::size_t before = (i + count_ - 1) % count_;
    const Vector3d e = along(i), across = e.cross(u), middle = e + along(before);
    const double longest =
        std::min({kLongestMitre * ring_.radius, segment(i).norm() / 2, segment(before).norm() / 2});
    Loop loop;
    for (std::size_t k = 0; k < kAroundWire; ++k) {
      const Vector3d out = ring_.radius * on_circle(u, across, k, kAroundWire);
      const double shift = -out.dot(middle) / std::max(1e-9, e.dot(middle));
      loop.push_back(ring_.corners[i] + out + std::clamp(shift, -longest, longest) * e);
    }
    return loop;
  }

  const collision::Ring& ring_;
  std::size_t count_;
  std::vector<Loop> loops_;
  std::size_t shift_ = 0;  ///< Between the last loop and the first, points.
};

std::vector<Piece> triangles(const collision::Mesh& mesh) {
  std::vector<Piece> pieces;
  std::map<std::array<int, 2>, Vector3d> normal;  // of the triangle beside each side
  const auto side = [&](std::size_t i, int k) -> std::array<int, 2> {
    return {mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]};
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    Piece piece;
    add_facet(piece, {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, true);
    for (int k = 0; k < 3 && !piece.empty(); ++k) normal[side(i, k)] = piece.front().normal;
    pieces.push_back(std::move(piece));
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (int k = 0; k < 3 && !pieces[i].empty(); ++k) {
      const auto other = normal.find({side(i, k)[1], side(i, k)[0]});
      pieces[i].front().edge[k] =
          other != normal.end() && other->second.dot(pieces[i].front().normal) < std::cos(kCrease);
    }
  return pieces;
}

/// A round wire with fewer corners: those at which it has turned by kBend since the one before.
collision::Ring coarser(const collision::Ring& ring) {
  const std::size_t count = ring.corners.size();
  const auto corner = [&](std::size_t i) { return ring.corners[i % count]; };
  collision::Ring coarse{.corners = {}, .radius = ring.radius};
  double turned = kBend;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d before = corner(i) - corner(i + count - 1), after = corner(i + 1) - corner(i);
    turned += std::atan2(before.cross(after).norm(), before.dot(after));
    if (turned < kBend) continue;
    coarse.corners.push_back(corner(i));
    turned = 0;
  }
  return coarse.corners.size() < 3 ? ring : coarse;
}

struct PiecesOf {
  std::vector<Piece> operator()(const collision::HalfSpace&) const { return {}; }
  std::vector<Piece> operator()(const collision::Sphere& sphere) const {
    return {capsule(sphere.radius, 0, kAroundSphere, 3)};
  }
  std::vector<Piece> operator()(const collision::Capsule& it) const {
    return {capsule(it.radius, it.length, kAroundCapsule, 2)};
  }
  std::vector<Piece> operator()(const collision::Ring& ring) const {
    const collision::Ring shown = coarser(ring);
    return Wire(shown).pieces();
  }
  std::vector<Piece> operator()(const collision::Box& it) const { return {box(it.edges)}; }
  std::vector<Piece> operator()(const collision::Cylinder& it) const {
    return {cylinder(it.radius, it.length)};
  }
  std::vector<Piece> operator()(const collision::Mesh& mesh) const { return triangles(mesh); }
};

using Side = std::array<double, 6>;

Side side_between(const Vector3d& a, const Vector3d& b) {
  return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}

/// Facets share corners to the last bit, in the body's frame and therefore in the world.
void mark_outline(std::vector<Piece>& pieces) {
  std::set<Side> sides;
  const auto for_each_side = [&](const auto& what) {
    for (Piece& piece : pieces)
      for (Facet& facet : piece)
        for (std::size_t k = 0; k < facet.corners.size(); ++k)
          what(facet, k, facet.corners[k], facet.corners[(k + 1) % facet.corners.size()]);
  };
  for_each_side([&](Facet&, std::size_t, const Vector3d& a, const Vector3d& b) {
    sides.insert(side_between(a, b));
  });
  for_each_side([&](Facet& facet, std::size_t k, const Vector3d& a, const Vector3d& b) {
    if (!sides.contains(side_between(b, a))) facet.edge[k] = true;
  });
}

}  // namespace

std::vector<Piece> pieces_of(const collision::Geometry& geometry) {
  return std::visit(PiecesOf{}, geometry);
}

std::vector<Piece> seen_from(const Vector3d& towards_viewer, const std::vector<Piece>& pieces,
                             const Pose& pose, std::size_t body) {
  std::vector<Piece> seen;
  for (const Piece& piece : pieces) {
    Piece fronts;
    for (const Facet& facet : piece) {
      const Vector3d normal = pose.R * facet.normal;
      if (normal.dot(towards_viewer) <= 0) continue;
      Facet& front = fronts.emplace_back(facet);
      front.normal = normal;
      front.body = body;
      for (Vector3d& corner : front.corners) corner = pose * corner;
    }
    if (!fronts.empty()) seen.push_back(std::move(fronts));
  }
  mark_outline(seen);
  return seen;
}

}  // namespace lcp
