// ring: wires with a ring at either end, linked into one another and hung.
//
// What      The ring of the paper's Section V-C, Table III and Fig. 4: contacts of non-convex bodies. A
//           chain of `wires` wires hangs from a ring that is fixed, inclined by `tilt`, and swings.
// Wire      Five ball joints: ring, four straight pieces, ring. The pieces are 40 mm long and 8 mm
//           thick. A ring is a closed wire, 10 mm thick, through the corners of a regular polygon of 42
//           mm radius; with the default of four it hangs from a corner, and where two such hook into one
//           another either side of each corner touches either side of the other: four points. Round rings
//           (64 corners) touch in one or two. Steel, 7800 kg/m^3; the joints have a damping of 0.02 mN m
//           s/rad.
// Start     At rest. Rings that hook into one another are at right angles, and fall by `gap` until they
//           touch.
// Source    K. Yamane, Y. Nakamura (2008), V-C; sizes, masses, motion and friction are not published.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "problems/scenes/scene.h"
#include "problems/scenes/solid_bodies.h"

namespace lcp {
namespace {

struct RingKnobs {
  Index wires = 7;
  Index corners = 4;
  double gap = 0.0005;
  double tilt = 15;
  Surfaces surfaces = Surfaces::exact;
  SteppingKnobs stepping = {.mu = 0.3};
};

OptionTable knob_table(RingKnobs& knobs) {
  OptionTable own = {
      count("wires", knobs.wires, 1, 64, "in the chain"),
      count("corners", knobs.corners, 4, 128, "of a ring, a multiple of 4; 64: round"),
      real("gap", knobs.gap, 0, 0.02, "between rings at the start, m"),
      real("tilt", knobs.tilt, 0, 60, "of the chain at the start, degrees"),
      choice("surfaces", knobs.surfaces, "round wires, or triangles in their place"),
  };
  return with_stepping_knobs(std::move(own), knobs.stepping);
}

constexpr Index kPieces = 4, kLinks = kPieces + 2;            // of a wire
constexpr double kPiece = 0.04, kPieceThickness = 0.008;      // m
constexpr double kRingRadius = 0.042, kRingThickness = 0.01;  // m
constexpr double kDensity = 7800;                             // kg/m^3
constexpr double kDamping = 2e-5;                             // N m s/rad

/// A ring in its x-z plane, a corner on the z axis.
collision::Ring ring_shape(Index corners) {
  collision::Ring ring{{}, kRingThickness / 2};
  for (Index i = 0; i < corners; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    ring.corners.push_back({kRingRadius * std::sin(angle), 0, kRingRadius * std::cos(angle)});
  }
  return ring;
}

double disc(double thickness) { return std::numbers::pi / 4 * thickness * thickness; }

/// How far the hooked corners of two rings are from one another where the rings just touch: the
/// sides of two corners of half angle phi, at right angles, are d sin(phi) / sqrt(1 + cos^2(phi))
/// apart where the corners are d.
double hooked(Index corners) {
  const double phi = std::numbers::pi / 2 * (1 - 2 / static_cast<double>(corners));
  return kRingThickness * std::sqrt(1 + std::cos(phi) * std::cos(phi)) / std::sin(phi);
}

Link ring_link(const std::string& name, const collision::Ring& shape) {
  Link link;
  link.name = name;
  const double side = 2 * kRingRadius * std::sin(std::numbers::pi / double(shape.corners.size()));
  link.mass = kDensity * disc(kRingThickness) * side * static_cast<double>(shape.corners.size());
  link.inertia = solid_inertia(shape, link.mass);
  return link;
}

/// Hangs from the link before it.
void hang(Link& link, Index parent, const Vector3d& joint) {
  link.parent = parent;
  link.joint = JointKind::ball;
  link.in_parent.p = joint;
  link.damping = kDamping;
}

/// What a wire's pieces look like, along z.
collision::Capsule piece_shape() { return {kPieceThickness / 2, kPiece - kPieceThickness}; }

/// Adds a wire from its upper ring, which floats, to its lower one.
void add_wire(std::vector<Link>& links, Index number, const collision::Ring& shape) {
  const std::string name = fmt::format("wire{}", number + 1);
  links.push_back(ring_link(name + ".upper", shape));
  for (Index i = 0; i < kPieces; ++i) {
    Link piece;
    piece.name = fmt::format("{}.piece{}", name, i + 1);
    piece.mass = kDensity * disc(kPieceThickness) * kPiece;
    piece.centre = {0, 0, -kPiece / 2};
    piece.inertia = solid_inertia(piece_shape(), piece.mass);
    piece.inertia(2, 2) = piece.inertia(0, 0);
    hang(piece, static_cast<Index>(links.size()) - 1, {0, 0, i == 0 ? -kRingRadius : -kPiece});
    links.push_back(piece);
  }
  Link lower = ring_link(name + ".lower", shape);
  lower.centre = {0, 0, -kRingRadius};
  hang(lower, static_cast<Index>(links.size()) - 1, {0, 0, -kPiece});
  links.push_back(lower);
}

/// Turns the plane of a ring from x-z to y-z.
Matrix3d across() {
  return Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitZ()).toRotationMatrix();
}

/// The fixed ring stands at the origin in the x-z plane, upper rings in the y-z plane, lower ones in
/// the x-z plane again, before all is tilted.
SceneSetup set_up(const RingKnobs& knobs) {
  using namespace collision;
  if (knobs.corners % 4 != 0)
    throw std::invalid_argument("ring: corners: expected a multiple of 4");
  const Ring shape = ring_shape(knobs.corners);
  std::vector<Link> links;
  std::vector<Shape> shapes = {{shape}};
  std::vector<LinkPair> joined;
  for (Index wire = 0; wire < knobs.wires; ++wire) {
    const Index first = static_cast<Index>(links.size()), last = first + kLinks - 1;
    add_wire(links, wire, shape);
    shapes.push_back({shape, first, {across(), Vector3d::Zero()}});
    for (Index i = first + 1; i < last; ++i)
      shapes.push_back({piece_shape(), i, {Matrix3d::Identity(), {0, 0, -kPiece / 2}}});
    shapes.push_back({shape, last, {Matrix3d::Identity(), {0, 0, -kRingRadius}}});
    for (Index i = first + 1; i <= last; ++i) joined.emplace_back(i - 1, i);
  }

  Model model(std::move(links));
  State at = state_at_zero(model);
  const Eigen::Quaterniond tilt(
      Eigen::AngleAxisd(knobs.tilt * std::numbers::pi / 180, Vector3d(1, 1, 0).normalized()));
  shapes[0].in_link.R = tilt.toRotationMatrix();
  const double period = 4 * kRingRadius + kPiece * kPieces - (hooked(knobs.corners) + knobs.gap);
  std::vector<Index> handles;
  for (Index i = 0; i < model.size(); ++i) {
    handles.push_back(i);
    if (model.link(i).joint != JointKind::free) continue;
    const Index wire = i / kLinks;
    const Vector3d below(
        0, 0,
        hooked(knobs.corners) + knobs.gap - 2 * kRingRadius - period * static_cast<double>(wire));
    at.q.segment<3>(model.q_of(i)) = tilt * below;
    at.q.segment<4>(model.q_of(i) + 3) = tilt.coeffs();
  }
  auto collide = touching(shapes, joined, knobs.surfaces);
  return {.system = {.model = std::move(model),
                     .start = std::move(at),
                     .handles = std::move(handles),
                     .collide = std::move(collide),
                     .mu = knobs.stepping.mu},
          .stepping = knobs.stepping.stepping(),
          .length = period * static_cast<double>(knobs.wires),
          .duration = 4,
          .shapes = std::move(shapes)};
}

const SceneRegistration ring{
    {"ring", "wires with non-convex rings at their ends, linked into one another and hung",
     "Yamane and Nakamura 2008, V-C, Table III, Fig. 4"},
    RingKnobs{},
    knob_table,
    set_up};

}  // namespace
}  // namespace lcp
