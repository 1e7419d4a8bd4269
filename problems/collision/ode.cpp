#include "problems/collision/ode.h"

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <mutex>
#include <stdexcept>
#include <tuple>

namespace lcp::collision {

namespace {

/// Contacts of one pair that ODE is asked for; meshes have tens.
constexpr int kContactsLimit = 1024;

/// Around a capsule or cylinder that stands as a mesh: 0.1 % of the radius within it at most.
constexpr Index kFacets = 64;

/// Held while ODE works: as Debian builds it, all threads share the memory in which it collides
/// meshes. Initialises it the first time.
std::unique_lock<std::mutex> use_ode() {
  static std::mutex mutex;
  std::unique_lock<std::mutex> lock(mutex);
  static const bool initialised =
      dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  // Its warnings go to stderr: that meshes have many points close together, which is their nature.
  static const bool silenced = (dSetMessageHandler([](int, const char*, va_list) {}), true);
  static_cast<void>(silenced);
  if (!initialised) throw std::runtime_error("collision: ODE cannot be initialised");
  return lock;
}

/// A mesh in the form that ODE keeps pointers to.
struct MeshData {
  std::vector<double> vertices;
  std::vector<dTriIndex> indices;
  dTriMeshDataID id;

  explicit MeshData(const Mesh& mesh) : id(dGeomTriMeshDataCreate()) {
    for (const Vector3d& vertex : mesh.vertices)
      vertices.insert(vertices.end(), vertex.begin(), vertex.end());
    for (const auto& triangle : mesh.triangles)
      for (const int vertex : triangle) indices.push_back(static_cast<dTriIndex>(vertex));
    dGeomTriMeshDataBuildDouble(id, vertices.data(), 3 * sizeof(double),
                                static_cast<int>(mesh.vertices.size()), indices.data(),
                                static_cast<int>(indices.size()), 3 * sizeof(dTriIndex));
  }
  MeshData(const MeshData&) = delete;
  MeshData& operator=(const MeshData&) = delete;
  ~MeshData() { dGeomTriMeshDataDestroy(id); }
};

}  // namespace

struct OdeGeom::Implementation {
  Geometry geometry;
  std::unique_ptr<MeshData> mesh;
  dGeomID geom = nullptr;

  explicit Implementation(const Geometry& made) : geometry(made) {
    const auto lock = use_ode();
    geom = std::visit(*this, geometry);
    if (geom == nullptr) throw std::runtime_error("collision: ODE has no such shape");
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;
  ~Implementation() {
    const auto lock = use_ode();
    dGeomDestroy(geom);
    mesh.reset();
  }

  dGeomID operator()(const Sphere& sphere) { return dCreateSphere(nullptr, sphere.radius); }
  dGeomID operator()(const Capsule& capsule) {
    return (*this)(mesh_of(capsule, kFacets, kFacets / 4));
  }
  dGeomID operator()(const Box& box) {
    return dCreateBox(nullptr, box.edges.x(), box.edges.y(), box.edges.z());
  }
  dGeomID operator()(const Cylinder& cylinder) { return (*this)(mesh_of(cylinder, kFacets)); }
  dGeomID operator()(const Mesh& shape) {
    mesh = std::make_unique<MeshData>(shape);
    return dCreateTriMesh(nullptr, mesh->id, nullptr, nullptr, nullptr);
  }
  template <class Other>
  dGeomID operator()(const Other&) {
    return nullptr;
  }
};

OdeGeom::OdeGeom(const Geometry& geometry)
    : implementation_(std::make_unique<Implementation>(geometry)) {}
OdeGeom::OdeGeom(const OdeGeom& other) : OdeGeom(other.implementation_->geometry) {}
OdeGeom& OdeGeom::operator=(const OdeGeom& other) { return *this = OdeGeom(other); }
OdeGeom::OdeGeom(OdeGeom&&) noexcept = default;
OdeGeom& OdeGeom::operator=(OdeGeom&&) noexcept = default;
OdeGeom::~OdeGeom() = default;

void OdeGeom::place(const Pose& pose) {
  const auto lock = use_ode();
  dMatrix3 rows = {};
  constexpr int row_length = 4;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rows[row_length * i + j] = pose.R(i, j);
  dGeomSetRotation(implementation_->geom, rows);
  dGeomSetPosition(implementation_->geom, pose.p.x(), pose.p.y(), pose.p.z());
}

void OdeGeom::collide(const OdeGeom& first, const OdeGeom& second, std::vector<Touch>& touches) {
  const auto lock = use_ode();
  std::array<dContactGeom, kContactsLimit> contacts;
  const int count = dCollide(first.implementation_->geom, second.implementation_->geom,
                             kContactsLimit, contacts.data(), sizeof(dContactGeom));
  std::vector<Touch> found;
  for (int i = 0; i < count; ++i) {
    const dContactGeom& contact = contacts[i];
    // Not where a mesh has a triangle without area.
    const Vector3d normal = Vector3d(contact.normal[0], contact.normal[1], contact.normal[2]);
    if (!(normal.norm() > 0) || !(contact.depth >= 0)) continue;
    found.push_back({Vector3d(contact.pos[0], contact.pos[1], contact.pos[2]), normal.normalized(),
                     contact.depth, 0});
  }
  const auto key = [](const Touch& touch) {
    const Vector3d &p = touch.position, &n = touch.normal;
    return std::tuple(-touch.depth, p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
  };
  std::sort(found.begin(), found.end(),
            [&](const Touch& a, const Touch& b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i].feature = static_cast<Index>(i);
    touches.push_back(found[i]);
  }
}

}  // namespace lcp::collision
