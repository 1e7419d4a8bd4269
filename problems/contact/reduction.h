#pragma once

#include <vector>

#include "problems/contact/contact_problem.h"

namespace lcp {

/// One point at which two bodies touch, as a collision test describes it.
struct ContactPoint {
  Eigen::Vector3d position;    ///< m, world axes.
  Eigen::Vector3d normal;      ///< Unit, from body 2 to body 1, world axes.
  double depth = 0;            ///< m: overlap, negative where there is a gap.
  double normal_velocity = 0;  ///< m/s: of body 1 relative to body 2, positive where they separate.
  ContactId id = {};
};

/// Which contact points are superfluous.
struct ReductionOptions {
  enum class Method {
    none,       ///< Every point is kept.
    paper,      ///< Points near another and points inside the contact polygon are dropped.
    deepest_4,  ///< The `per_pair` deepest points of each pair of bodies are kept.
  };
  enum class Grouping {
    partner,  ///< One polygon for all bodies that rest on one body 2: both feet of a robot.
    pair,     ///< A polygon for each pair of bodies.
  };
  enum class Separating {
    keep,       ///< A separating point is never dropped.
    as_others,  ///< Its velocity plays no part: dropped if near another or inside.
    drop,       ///< Dropped always, which lets bodies sink; there to be measured.
  };

  Method method = Method::paper;
  Grouping grouping = Grouping::partner;
  Separating separating = Separating::keep;
  double merge_distance = 1e-3;    ///< m: delta of IV-C; points nearer than this are one.
  double inside_distance = 1e-4;   ///< m: how far inside the polygon's boundary points are dropped.
  double normal_angle = 0.1;       ///< rad: normals at a smaller angle are the same.
  double separating_speed = 1e-6;  ///< m/s: a point with a larger normal velocity separates.
  Index per_pair = 4;              ///< Points that `deepest_4` keeps of each pair.
};

/// Indices of the points to keep, in the order of (body 1, body 2), then deepest first, then
/// ascending x, y, z (then normal, velocity, feature). The order of `points` has no influence: the
/// points kept and their sequence stay the same.
///
/// `paper` goes through the points in that order and drops
///   1. a point at a distance of at most `merge_distance` from one already kept of the same pair and
///      normal, so that the deepest of a cluster stays;
///   2. of the others, a point inside its contact polygon by more than `inside_distance`. Polygon:
///      the convex hull of the points of one group, projected along the group's normal, that of its
///      first point. Points on the boundary stay, corners or not; so do collinear ones, which have
///      no inside. Height along the normal plays no part: it does not change the moment of a normal
///      force.
/// Separating points that are kept still count as others' neighbours and as corners of the polygon.
///
/// A group is the points of one body 2 (`partner`) or pair whose normals are the same. Dropping
/// points inside a common polygon changes nothing where its bodies move as one, as under
/// high-gain joint control; two boxes side by side on a floor lose support that they need, and want
/// `pair`.
///
/// `deepest_4` knows no polygon: on a face at even depth the four are those of least x, and may lie
/// at one side.
///
/// Throws std::invalid_argument when a number is not finite or a normal not of unit length. Cost:
/// N^2 distances at worst. Source: K. Yamane, Y. Nakamura, "A Numerically Robust LCP Solver for
/// Simulating Articulated Rigid Bodies in Contact", RSS 2008, IV-C, which leaves order, groups and
/// boundary open and says that separating points must not be removed for separating.
std::vector<Index> reduce_contacts(const std::vector<ContactPoint>& points,
                                   const ReductionOptions& options = {});

}  // namespace lcp
