#pragma once

#include <utility>
#include <vector>

#include "problems/collision/ode.h"
#include "problems/collision/shape.h"
#include "problems/contact/reduction.h"
#include "problems/rigid/kinematics.h"

namespace lcp::collision {

/// Two links, in any order; Link::world for what stands still.
using LinkPair = std::pair<Index, Index>;

/// Each link with its parent: neighbours whose shapes overlap at their joint.
std::vector<LinkPair> neighbours(const Model& model);

/// Shapes on links, and the points at which they touch. Shapes of different links may touch, other
/// than those of `excluded` pairs; shapes of one link, or of the world, never do.
///
/// | pair | rule |
/// |---|---|
/// | half-space on anything | its lowest points: exact |
/// | sphere, capsule on these, box, cylinder | distance along the axis; 2 points where parallel |
/// | box, cylinder on these | exact direction of least overlap; the points that faces share |
/// | ring on all but meshes | local minima of the distance over its segments |
/// | mesh on all but half-spaces and rings | ODE |
///
/// ODE's own rules for cylinders on boxes miss 3 % of shallow overlaps, those for cylinders on
/// capsules and cylinders are iterations, wrong by 1e-4 m and 1 rad at worst, its capsules have one
/// point however they lie, and of two boxes it prefers faces to edges that are deeper: hence ours.
///
/// Mesh on mesh gives many points with scattered normals, in the nature of triangles; ODE keeps
/// vertices in single precision.
///
/// One World, one thread; copies are independent. As a System's rule:
///
///     system.collide = [world](const Kinematics& k) mutable { return world.contacts(k); };
class World {
 public:
  /// Throws std::invalid_argument naming the shape on one that `check` refuses, and on pairs that
  /// have no rule and are not excluded: ring on mesh, half-space on half-space.
  explicit World(std::vector<Shape> shapes, std::vector<LinkPair> excluded = {});

  const std::vector<Shape>& shapes() const { return shapes_; }

  /// Overlaps of depth >= 0, positions in their middle, in the order of (body 1, body 2), then
  /// deepest first, then ascending x, y, z; the order of the shapes has no influence. Body 1 has
  /// the higher number. Features stay the same from frame to frame for corners, ends and segments;
  /// for polygons and what ODE finds they count the points of one pair. Where several pairs of
  /// shapes belong to the same links, those of the k-th pair begin at k features_per_pair.
  ///
  /// Throws std::invalid_argument when a shape's link does not exist.
  std::vector<ContactPoint> contacts(const Kinematics& kinematics);

 private:
  struct Pair {
    std::size_t first, second;  ///< Shapes, in the order that the collider takes them.
    Collider collider;          ///< None: ODE.
    bool flipped;               ///< The first shape is on body 2.
    ContactId id;               ///< With the first of its features.
  };

  void add_pair(std::size_t i, std::size_t j);
  void place(const Kinematics& kinematics);
  bool near(const Pair& pair) const;

  std::vector<Shape> shapes_;
  std::vector<LinkPair> excluded_;
  std::vector<double> radii_;  ///< Bounding radius of each shape.
  std::vector<Pair> pairs_;
  std::vector<Placed> placed_;
  std::vector<std::size_t> geom_of_;  ///< Of shapes that ODE collides, their place in geoms_.
  std::vector<OdeGeom> geoms_;
};

}  // namespace lcp::collision
