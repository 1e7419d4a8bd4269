#include "problems/collision/collision.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "problems/collision/colliders.h"
#include "problems/rigid/contact_dynamics.h"
#include "solvers/errors.h"

namespace lcp::collision {

namespace {

constexpr std::size_t kNoGeom = std::numeric_limits<std::size_t>::max();

enum class Rule { own, ode, none };

template <class Kind>
bool is(const Geometry& geometry) {
  return std::holds_alternative<Kind>(geometry);
}

/// The rule for a pair of kinds, the first of which does not come after the second in Geometry.
std::pair<Rule, Collider> rule_for(const Geometry& first, const Geometry& second) {
  if (is<HalfSpace>(first))
    return {is<HalfSpace>(second) ? Rule::none : Rule::own, half_space_on_solid};
  if (is<Ring>(second)) {
    if (is<Ring>(first)) return {Rule::own, ring_on_ring};
    return {Rule::own, ring_on_solid};  // the ring comes first there: see add_pair
  }
  if (is<Mesh>(second)) return {is<Ring>(first) ? Rule::none : Rule::ode, nullptr};
  if (is<Ring>(first)) return {Rule::own, ring_on_solid};
  const bool round = is<Sphere>(first) || is<Capsule>(first);
  return {Rule::own, round ? capsule_on_solid : convex_on_convex};
}

/// Unordered.
LinkPair sorted(LinkPair pair) {
  return {std::min(pair.first, pair.second), std::max(pair.first, pair.second)};
}

}  // namespace

std::vector<LinkPair> neighbours(const Model& model) {
  std::vector<LinkPair> pairs;
  for (Index i = 0; i < model.size(); ++i) pairs.emplace_back(model.link(i).parent, i);
  return pairs;
}

World::World(std::vector<Shape> shapes, std::vector<LinkPair> excluded)
    : shapes_(std::move(shapes)),
      excluded_(std::move(excluded)),
      placed_(shapes_.size()),
      geom_of_(shapes_.size(), kNoGeom) {
  for (LinkPair& pair : excluded_) pair = sorted(pair);
  std::sort(excluded_.begin(), excluded_.end());
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    check(shapes_[i], fmt::format("collision: shape {}", i));
    radii_.push_back(bounding_radius(shapes_[i].geometry));
  }
  for (std::size_t i = 0; i < shapes_.size(); ++i)
    for (std::size_t j = i + 1; j < shapes_.size(); ++j) add_pair(i, j);

  std::map<LinkPair, Index> count;
  for (Pair& pair : pairs_)
    pair.id.feature = features_per_pair * count[{pair.id.body1, pair.id.body2}]++;
}

void World::add_pair(std::size_t i, std::size_t j) {
  const LinkPair links = sorted({shapes_[i].link, shapes_[j].link});
  if (links.first == links.second || std::binary_search(excluded_.begin(), excluded_.end(), links))
    return;
  // By kind; shapes of the same kind by link, whatever their order in the list.
  const auto key = [&](std::size_t k) {
    return std::pair(shapes_[k].geometry.index(), shapes_[k].link);
  };
  if (key(j) < key(i)) std::swap(i, j);
  const auto [rule, collider] = rule_for(shapes_[i].geometry, shapes_[j].geometry);
  if (rule == Rule::none)
    throw InvalidArgument(
        "collision: shapes {} and {}: no rule for {} on {}; exclude their links, or "
        "turn a ring into "
        "a mesh",
        i, j, name_of(shapes_[i].geometry), name_of(shapes_[j].geometry));
  if (collider == ring_on_solid && is<Ring>(shapes_[j].geometry)) std::swap(i, j);
  if (rule == Rule::ode) {
    for (const std::size_t k : {i, j}) {
      if (geom_of_[k] != kNoGeom) continue;
      geom_of_[k] = geoms_.size();
      geoms_.emplace_back(shapes_[k].geometry);
    }
  }
  pairs_.push_back({.first = i,
                    .second = j,
                    .collider = collider,
                    .flipped = shapes_[i].link < shapes_[j].link,
                    .id = {body_of(links.second), body_of(links.first), 0}});
}

void World::place(const Kinematics& kinematics) {
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Shape& shape = shapes_[i];
    if (shape.link >= static_cast<Index>(kinematics.pose.size()))
      throw InvalidArgument("collision: shape {}: link is {}, but there are {}", i, shape.link,
                            kinematics.pose.size());
    Placed& placed = placed_[i];
    placed.geometry = &shape.geometry;
    placed.pose =
        shape.link == Link::world ? shape.in_link : kinematics.pose[shape.link] * shape.in_link;
    if (const auto* ring = std::get_if<Ring>(&shape.geometry)) {
      placed.corners.resize(ring->corners.size());
      for (std::size_t k = 0; k < ring->corners.size(); ++k)
        placed.corners[k] = placed.pose * ring->corners[k];
    }
    if (geom_of_[i] != kNoGeom) geoms_[geom_of_[i]].place(placed.pose);
  }
}

/// By spheres around both.
bool World::near(const Pair& pair) const {
  const Pose &a = placed_[pair.first].pose, &b = placed_[pair.second].pose;
  if (is<HalfSpace>(shapes_[pair.first].geometry))
    return a.R.col(2).dot(b.p - a.p) <= radii_[pair.second];
  const double reach = radii_[pair.first] + radii_[pair.second];
  return (a.p - b.p).squaredNorm() <= reach * reach;
}

std::vector<ContactPoint> World::contacts(const Kinematics& kinematics) {
  place(kinematics);
  std::vector<ContactPoint> points;
  std::vector<Touch> touches;
  for (const Pair& pair : pairs_) {
    if (!near(pair)) continue;
    touches.clear();
    if (pair.collider != nullptr)
      pair.collider(placed_[pair.first], placed_[pair.second], touches);
    else
      OdeGeom::collide(geoms_[geom_of_[pair.first]], geoms_[geom_of_[pair.second]], touches);
    for (const Touch& touch : touches)
      points.push_back({.position = touch.position,
                        .normal = pair.flipped ? Vector3d(-touch.normal) : touch.normal,
                        .depth = touch.depth,
                        .id = {pair.id.body1, pair.id.body2, pair.id.feature + touch.feature}});
  }
  const auto key = [](const ContactPoint& point) {
    const Vector3d& p = point.position;
    return std::tuple(point.id.body1, point.id.body2, -point.depth, p.x(), p.y(), p.z(),
                      point.id.feature);
  };
  std::sort(points.begin(), points.end(),
            [&](const ContactPoint& a, const ContactPoint& b) { return key(a) < key(b); });
  return points;
}

}  // namespace lcp::collision
