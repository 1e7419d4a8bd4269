#include "harness/present/scenes/painting.h"

#include <algorithm>
#include <limits>

#include "harness/present/scenes/polygons.h"

namespace lcp {

namespace {

constexpr double kTouch = 0.02;       // over a piece's size: overlaps that no picture shows
constexpr double kLeastShare = 1e-6;  // of the smaller piece's area: no overlap in the picture

/// A piece in the picture plane.
class Sketch {
 public:
  Sketch(const Piece& piece, const Camera& camera) {
    Polygon corners;
    for (const Facet& facet : piece) {
      for (const Vector3d& corner : facet.corners) corners.push_back(camera.flat(corner));
      const double slope = facet.normal.dot(camera.towards_viewer);
      planes_.push_back(
          {facet.normal.dot(facet.corners.front()) / slope, -camera.flat(facet.normal) / slope});
      smooth_ |= facet.smooth;
    }
    outline_ = convex_hull(std::move(corners));
    for (const Vector2d& corner : outline_) bounds_.extend(corner);
  }

  /// Of its surface, towards the viewer, m; `at` is a point within.
  double height(const Vector2d& at) const {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes_)
      lowest = std::min(lowest, plane.height + plane.slope.dot(at));
    return lowest;
  }
  const Polygon& outline() const { return outline_; }
  const Eigen::AlignedBox2d& bounds() const { return bounds_; }
  double size() const { return bounds_.diagonal().norm(); }
  bool smooth() const { return smooth_; }

 private:
  struct Plane {
    double height;  ///< Over the picture plane's origin, and what it gains per m.
    Vector2d slope;
  };

  std::vector<Plane> planes_;
  Polygon outline_;
  Eigen::AlignedBox2d bounds_;
  bool smooth_ = false;
};

enum class Relation { none, in_front, behind, crossed };

/// Where `a` is, seen from `b`.
Relation relation(const Sketch& a, const Sketch& b) {
  if (!a.bounds().intersects(b.bounds())) return Relation::none;
  const Polygon common = common_part(a.outline(), b.outline());
  if (area(common) <= kLeastShare * std::min(area(a.outline()), area(b.outline())))
    return Relation::none;
  double most = 0, least = 0;
  Vector2d middle(0, 0);
  for (const Vector2d& corner : common) {
    const double ahead = a.height(corner) - b.height(corner);
    most = std::max(most, ahead);
    least = std::min(least, ahead);
    middle += corner / static_cast<double>(common.size());
  }
  const double touch = kTouch * std::min(a.size(), b.size());
  if (most > touch && least < -touch && !(a.smooth() && b.smooth())) return Relation::crossed;
  // Where heights differ by less than touching allows, or both ways at a round joint.
  const double ahead =
      (most > touch) == (least < -touch) ? a.height(middle) - b.height(middle) : most + least;
  return ahead > 0 ? Relation::in_front : Relation::behind;
}

/// Sets of nodes that lie in a circle, each after what its nodes lead to.
///
/// Source: R. Tarjan, "Depth-First Search and Linear Graph Algorithms", SIAM J. Comput. 1 (1972).
class Components {
 public:
  explicit Components(const std::vector<std::vector<std::size_t>>& leads_to)
      : leads_to_(leads_to), number_(leads_to.size(), kUnseen), low_(leads_to.size()) {
    for (std::size_t i = 0; i < leads_to.size(); ++i)
      if (number_[i] == kUnseen) visit(i);
  }
  const std::vector<std::vector<std::size_t>>& found() const { return found_; }

 private:
  static constexpr std::size_t kUnseen = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t kDone = kUnseen - 1;

  void visit(std::size_t node) {
    low_[node] = number_[node] = next_++;
    open_.push_back(node);
    for (const std::size_t to : leads_to_[node]) {
      if (number_[to] == kUnseen) visit(to);
      if (number_[to] != kDone) low_[node] = std::min(low_[node], low_[to]);
    }
    if (low_[node] != number_[node]) return;
    const auto first = std::find(open_.begin(), open_.end(), node);
    found_.emplace_back(first, open_.end());
    open_.erase(first, open_.end());
    for (const std::size_t member : found_.back()) number_[member] = kDone;
  }

  const std::vector<std::vector<std::size_t>>& leads_to_;
  std::vector<std::size_t> number_, low_, open_;
  std::vector<std::vector<std::size_t>> found_;
  std::size_t next_ = 0;
};

/// For each piece, those behind it.
std::vector<std::vector<std::size_t>> behind_each(const std::vector<Piece>& pieces,
                                                  const Camera& camera) {
  std::vector<Sketch> sketches;
  for (const Piece& piece : pieces) sketches.emplace_back(piece, camera);
  std::vector<std::vector<std::size_t>> behind(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Relation at = relation(sketches[i], sketches[j]);
      if (at == Relation::in_front || at == Relation::crossed) behind[i].push_back(j);
      if (at == Relation::behind || at == Relation::crossed) behind[j].push_back(i);
    }
  return behind;
}

Coat cut_coat(std::vector<Piece> pieces, const Vector3d& towards_viewer) {
  Piece facets;
  for (Piece& piece : pieces) std::move(piece.begin(), piece.end(), std::back_inserter(facets));
  return {.facets = back_to_front(std::move(facets), towards_viewer)};
}

}  // namespace

std::vector<Coat> painting_order(std::vector<Piece> pieces, const Camera& camera) {
  const bool any_smooth = std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) {
    return std::any_of(piece.begin(), piece.end(), [](const Facet& f) { return f.smooth; });
  });
  if (!any_smooth) return {cut_coat(std::move(pieces), camera.towards_viewer)};
  std::vector<Coat> coats;
  const std::vector<std::vector<std::size_t>> behind = behind_each(pieces, camera);
  const Components circles(behind);
  for (const std::vector<std::size_t>& circle : circles.found()) {
    std::vector<Piece> members;
    for (const std::size_t i : circle) members.push_back(std::move(pieces[i]));
    if (members.size() == 1)
      coats.push_back({.facets = std::move(members.front()), .whole = true});
    else
      coats.push_back(cut_coat(std::move(members), camera.towards_viewer));
  }
  return coats;
}

}  // namespace lcp
