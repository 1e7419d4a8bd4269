#pragma once

#include <memory>

#include "problems/collision/colliders.h"

namespace lcp::collision {

/// A geometry in the Open Dynamics Engine (ODE): made once, posed at each instant. Not to be used
/// by two threads at a time; copies may.
class OdeGeom {
 public:
  /// A sphere, box or mesh; a capsule or cylinder as a mesh, because half the points that ODE finds
  /// of a mesh on those themselves lie millimetres away from both.
  explicit OdeGeom(const Geometry& geometry);
  OdeGeom(const OdeGeom& other);
  OdeGeom& operator=(const OdeGeom& other);
  OdeGeom(OdeGeom&&) noexcept;
  OdeGeom& operator=(OdeGeom&&) noexcept;
  ~OdeGeom();

  void place(const Pose& pose);

  /// Appends ODE's contact points of two geometries, deepest first, then by x, y, z; features in
  /// that order.
  static void collide(const OdeGeom& first, const OdeGeom& second, std::vector<Touch>& touches);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace lcp::collision
