#include "problems/scenes/solid_bodies.h"

#include "solvers/errors.h"

namespace lcp {

namespace {

using namespace collision;

/// Of a body of that mass spread along a straight line of length `length` in direction d (unit).
Matrix3d rod_inertia(const Vector3d& d, double length, double mass) {
  return mass * length * length / 12 * (Matrix3d::Identity() - d * d.transpose());
}

/// What moving a body's centre to c adds.
Matrix3d offset_inertia(const Vector3d& c, double mass) {
  return mass * (c.squaredNorm() * Matrix3d::Identity() - c * c.transpose());
}

Matrix3d about_z(double across, double along) {
  return Vector3d(across, across, along).asDiagonal();
}

struct SolidInertia {
  double mass;

  Matrix3d operator()(const Sphere& sphere) const {
    return 0.4 * mass * sphere.radius * sphere.radius * Matrix3d::Identity();
  }
  Matrix3d operator()(const Capsule& capsule) const {
    const double r = capsule.radius, l = capsule.length;
    const double ends = mass / (1 + 0.75 * l / r), middle = mass - ends;
    return about_z(
        middle * (l * l / 12 + r * r / 4) + ends * (0.4 * r * r + l * l / 4 + 0.375 * l * r),
        middle * r * r / 2 + 0.4 * ends * r * r);
  }
  Matrix3d operator()(const Cylinder& cylinder) const {
    const double r = cylinder.radius, l = cylinder.length;
    return about_z(mass * (l * l / 12 + r * r / 4), mass * r * r / 2);
  }
  Matrix3d operator()(const Box& box) const {
    const Vector3d squares = box.edges.cwiseAbs2();
    return mass / 12 * (squares.sum() * Matrix3d::Identity() - Matrix3d(squares.asDiagonal()));
  }
  Matrix3d operator()(const Ring& ring) const {
    const std::size_t count = ring.corners.size();
    double length = 0;
    Matrix3d sum = Matrix3d::Zero();
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3d &a = ring.corners[i], &b = ring.corners[(i + 1) % count];
      const double l = (b - a).norm();
      const Vector3d d = (b - a) / l;
      const Matrix3d disc =
          l * ring.radius * ring.radius / 4 * (Matrix3d::Identity() + d * d.transpose());
      sum += rod_inertia(d, l, l) + offset_inertia((a + b) / 2, l) + disc;
      length += l;
    }
    return mass / length * sum;
  }
  Matrix3d operator()(const HalfSpace&) const { return refuse("half-space"); }
  Matrix3d operator()(const Mesh&) const { return refuse("mesh"); }

  static Matrix3d refuse(const char* kind) {
    throw InvalidArgument("solid inertia: a {} has none", kind);
  }
};

Shape as_mesh(const Shape& shape, Index divisions) {
  Shape mesh = shape;
  const Index around = kFacetsAround;
  if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) {
    mesh.geometry = mesh_of(Capsule{sphere->radius, 0}, around, 1);
  } else if (const auto* capsule = std::get_if<Capsule>(&shape.geometry)) {
    mesh.geometry = mesh_of(*capsule, around, 1);
  } else if (const auto* ring = std::get_if<Ring>(&shape.geometry)) {
    mesh.geometry = mesh_of(*ring, around);
  } else if (const auto* cylinder = std::get_if<Cylinder>(&shape.geometry)) {
    mesh.geometry = mesh_of(*cylinder, 4 * around);
  } else if (const auto* box = std::get_if<Box>(&shape.geometry)) {
    mesh.geometry = mesh_of(*box, divisions);
  }
  return mesh;
}

}  // namespace

Matrix3d solid_inertia(const Geometry& geometry, double mass) {
  return std::visit(SolidInertia{mass}, geometry);
}

std::function<std::vector<ContactPoint>(const Kinematics&)> touching(std::vector<Shape> shapes,
                                                                     std::vector<LinkPair> excluded,
                                                                     Surfaces surfaces,
                                                                     Index divisions) {
  if (surfaces == Surfaces::mesh)
    for (Shape& shape : shapes) shape = as_mesh(shape, divisions);
  return [world = World(std::move(shapes), std::move(excluded))](const Kinematics& k) mutable {
    return world.contacts(k);
  };
}

}  // namespace lcp
