// net: cylinders fall on strings that are fixed at both ends and cross one another.
//
// What      The net of the paper's Section V-C, Table III and Fig. 4: closed loops, free bodies between
//           them. Half of the strings lie along x, the others along y on top of them.
// String    16 ball joints, the first and the last in the world, and 15 capsules between them, 60 mm
//           long and 16 mm thick, 18 g; a damping of 0.1 mN m s/rad in all joints but the last. A string
//           begins as an arc that sags by a fifth of its length.
// Cylinders 90 mm thick, 0.3 m long, 0.25 kg: three along x, side by side, and two along y above them.
// Loops     The last joint of each string closes a loop through the world; what opens of it between
//           steps closes again at 100 1/s.
// Source    K. Yamane, Y. Nakamura (2008), V-C; sizes, masses, motion and friction are not published.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "problems/scenes/scene.h"
#include "problems/scenes/solid_bodies.h"

namespace lcp {
namespace {

struct NetKnobs {
  Index strings = 4;
  Index cylinders = 5;
  double gap = 0.01;
  Surfaces surfaces = Surfaces::exact;
  SteppingKnobs stepping = {.mu = 0.4};
};

OptionTable knob_table(NetKnobs& knobs) {
  OptionTable own = {
      count("strings", knobs.strings, 2, 32, "even: half of them along x, the others along y"),
      count("cylinders", knobs.cylinders, 0, 64, "that fall on the net"),
      real("gap", knobs.gap, 0, 0.1, "between cylinders and net, and among them, at the start, m"),
      choice("surfaces", knobs.surfaces, "round surfaces, or triangles in their place"),
  };
  return with_stepping_knobs(std::move(own), knobs.stepping);
}

constexpr Index kLinks = 15;                       // of a string
constexpr double kLength = 0.06, kRadius = 0.008;  // m
constexpr double kMass = 0.018;                    // kg
constexpr double kDamping = 1e-4;                  // N m s/rad
constexpr double kBend = 0.75;                     // rad, pitch of a string at its ends
constexpr double kSpacing = 0.2;                   // m, between parallel strings
constexpr double kCrossing = 0.001;                // m, between strings at the start
constexpr double kCylinderRadius = 0.045, kCylinderLength = 0.3;  // m
constexpr double kCylinderMass = 0.25;                            // kg
constexpr double kCylinderSpacing = 0.1;                          // m, in a layer
constexpr Index kLayer = 3;                                       // cylinders of the lowest layer

/// Pitch of link i of a string: downwards at first.
double pitch(Index i) { return kBend * (1 - (2.0 * static_cast<double>(i) + 1) / kLinks); }

double span() {
  double sum = 0;
  for (Index i = 0; i < kLinks; ++i) sum += kLength * std::cos(pitch(i));
  return sum;
}

/// Height of a string below its ends at a distance from its middle.
double sag_at(double from_middle) {
  double x = -span() / 2, z = 0;
  for (Index i = 0; i < kLinks; ++i) {
    const double run = kLength * std::cos(pitch(i));
    if (x + run >= -std::abs(from_middle))
      return -z + std::tan(pitch(i)) * (-std::abs(from_middle) - x);
    x += run;
    z -= kLength * std::sin(pitch(i));
  }
  return -z;
}

/// x turned downwards by an angle.
Eigen::Quaterniond turned(double down) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(down, Vector3d::UnitY()));
}

collision::Capsule string_shape() { return {kRadius, kLength - 2 * kRadius}; }

/// Along x in a frame that takes its z axis there.
Matrix3d along_x() {
  return Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()).toRotationMatrix();
}

/// Everything that the scene is made of, as it is built up.
struct Parts {
  std::vector<Link> links;
  std::vector<Loop> loops;
  std::vector<collision::Shape> shapes;
  std::vector<collision::LinkPair> joined;
  std::vector<Eigen::Quaterniond> turns;  ///< Of ball joints, and of free links.
  std::vector<Vector3d> places;           ///< Of free links.
};

/// A string from one end, whose frame `end` has x along it and z upwards.
void add_string(Parts& parts, const std::string& name, const Pose& end) {
  for (Index i = 0; i < kLinks; ++i) {
    const Index number = static_cast<Index>(parts.links.size());
    Link link;
    link.name = fmt::format("{}.{}", name, i + 1);
    link.joint = JointKind::ball;
    link.parent = i == 0 ? Link::world : number - 1;
    link.in_parent = i == 0 ? end : Pose{Matrix3d::Identity(), {kLength, 0, 0}};
    link.mass = kMass;
    link.centre = {kLength / 2, 0, 0};
    link.inertia = along_x() * solid_inertia(string_shape(), kMass) * along_x().transpose();
    link.damping = kDamping;
    parts.links.push_back(link);
    parts.turns.push_back(turned(i == 0 ? pitch(0) : pitch(i) - pitch(i - 1)));
    parts.places.push_back(Vector3d::Zero());
    parts.shapes.push_back({string_shape(), number, {along_x(), {kLength / 2, 0, 0}}});
    if (i > 0) parts.joined.emplace_back(number - 1, number);
  }
  parts.loops.push_back({.name = name + ".end",
                         .joint = JointKind::ball,
                         .link1 = Link::world,
                         .link2 = static_cast<Index>(parts.links.size()) - 1,
                         .in_link1 = {Matrix3d::Identity(), end * Vector3d(span(), 0, 0)},
                         .in_link2 = {Matrix3d::Identity(), {kLength, 0, 0}}});
}

/// Strings along x at z = 0 of their ends, or along y on top of those.
void add_strings(Parts& parts, Index count, bool along_y) {
  const Matrix3d R =
      Eigen::AngleAxisd(along_y ? std::numbers::pi / 2 : 0, Vector3d::UnitZ()).toRotationMatrix();
  for (Index i = 0; i < count; ++i) {
    const double aside = kSpacing * (static_cast<double>(i) - 0.5 * static_cast<double>(count - 1));
    const double up = along_y ? 2 * kRadius + kCrossing : 0;
    const Vector3d start = R * Vector3d(-span() / 2, along_y ? -aside : aside, up);
    add_string(parts, fmt::format("{}{}", along_y ? "y" : "x", i + 1), {R, start});
  }
}

/// All along x, in layers of three and two in turn, the upper ones over the gaps of the lower.
void add_cylinders(Parts& parts, Index count, double gap) {
  const collision::Cylinder shape{kCylinderRadius, kCylinderLength};
  double height = -sag_at(kSpacing / 2) + 3 * kRadius + kCrossing;
  Index most = kLayer;
  for (Index placed = 0; placed < count; most = most == kLayer ? kLayer - 1 : kLayer) {
    const Index layer = std::min(count - placed, most);
    height += kCylinderRadius + gap;
    for (Index i = 0; i < layer; ++i, ++placed) {
      const double aside =
          kCylinderSpacing * (static_cast<double>(i) - 0.5 * static_cast<double>(layer - 1));
      Link link;
      link.name = fmt::format("cylinder{}", placed + 1);
      link.mass = kCylinderMass;
      link.inertia = solid_inertia(shape, kCylinderMass);
      parts.shapes.push_back({shape, static_cast<Index>(parts.links.size())});
      parts.links.push_back(link);
      parts.turns.push_back(Eigen::Quaterniond(along_x()));
      parts.places.push_back(Vector3d(0, aside, height));
    }
    height += kCylinderRadius;
  }
}

State start(const Model& model, const Parts& parts) {
  State at = state_at_zero(model);
  for (Index i = 0; i < model.size(); ++i) {
    const Index place = model.q_of(i);
    const bool free = model.link(i).joint == JointKind::free;
    if (free) at.q.segment<3>(place) = parts.places[i];
    at.q.segment<4>(place + (free ? 3 : 0)) = parts.turns[i].coeffs();
  }
  return at;
}

SceneSetup set_up(const NetKnobs& knobs) {
  if (knobs.strings % 2 != 0) throw std::invalid_argument("net: strings: expected an even number");
  Parts parts;
  add_strings(parts, knobs.strings / 2, false);
  add_strings(parts, knobs.strings / 2, true);
  add_cylinders(parts, knobs.cylinders, knobs.gap);
  Model model(parts.links, parts.loops);
  State at = start(model, parts);
  std::vector<Index> handles(model.size());
  for (Index i = 0; i < model.size(); ++i) handles[i] = i;
  return {.system = {.model = std::move(model),
                     .start = std::move(at),
                     .handles = std::move(handles),
                     .collide = touching(parts.shapes, parts.joined, knobs.surfaces),
                     .mu = knobs.stepping.mu},
          .stepping = knobs.stepping.stepping(),
          .length = kLinks * kLength,
          .duration = 2,
          .shapes = parts.shapes};
}

const SceneRegistration net{
    {"net", "cylinders fall on strings that are fixed at both ends and cross: closed loops",
     "Yamane and Nakamura 2008, V-C, Table III, Fig. 4"},
    NetKnobs{},
    knob_table,
    set_up};

}  // namespace
}  // namespace lcp
