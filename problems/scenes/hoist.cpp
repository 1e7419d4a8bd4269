// hoist: a chain is thrown over a rod, and one of its ends is pulled along the floor.
//
// What      The hoist of the paper's Section V-C, Table III and Fig. 4: a long open chain in continuous
//           contact with a rod. Ours also lies on a floor with both ends. Links on the round rod touch
//           it in four points, of which two are redundant, links on the floor in eight.
// Chain     `links` links joined by ball joints 0.1 m apart, with a damping of 2 mN m s/rad. A link is two
//           plates of 90 x 20 x 40 mm, 20 mm apart, 0.15 kg together. The chain begins as an arch that
//           follows the rod at a distance, two strands down to the floor, and the rest flat on it; `lift`
//           above all this, and thrown upwards.
// Rod       Round, along y, fixed; its radius fits the arch: 0.23 m for 26 links. It grows with the
//           chain, so that the share of links on the rod, in the air and on the floor stays.
// Pull      A hand holds the centre of the last link through a spring (500 N/m) and a damper
//           (10 N s/m). It takes hold between 2 s and 3 s and goes away along the floor by `pull` of the
//           chain's length between 3 s and 7 s, along a quintic, then rests.
// Source    K. Yamane, Y. Nakamura (2008), V-C; sizes, masses, motion and friction are not published.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "problems/scenes/scene.h"
#include "problems/scenes/smooth_step.h"
#include "problems/scenes/solid_bodies.h"

namespace lcp {
namespace {

struct HoistKnobs {
  Index links = 26;
  Index plates = 2;
  double clearance = 0.002;
  double lift = 0.02;
  double toss = 1;
  double pull = 0.12;
  Surfaces surfaces = Surfaces::exact;
  SteppingKnobs stepping = {.mu = 0.3};
};

OptionTable knob_table(HoistKnobs& knobs) {
  OptionTable own = {
      count("links", knobs.links, 8, 400, "of the chain"),
      count("plates", knobs.plates, 1, 2, "of a link, side by side"),
      real("clearance", knobs.clearance, 0, 0.05, "between the arch and the rod at first, m"),
      real("lift", knobs.lift, 0, 1, "of the chain above rod and floor at the start, m"),
      real("toss", knobs.toss, 0, 5, "upward speed of the chain at the start, m/s"),
      real("pull", knobs.pull, 0, 0.5, "way of the hand over the length of the chain"),
      choice("surfaces", knobs.surfaces, "boxes and a round rod, or triangles in their place"),
  };
  return with_stepping_knobs(std::move(own), knobs.stepping);
}

constexpr double kPitch = 0.1;                            // m, between joints
const Vector3d kEdges(0.09, 0.02, 0.04);                  // m
constexpr double kApart = 0.04;                           // m, between the plates' centres
constexpr double kMass = 0.15;                            // kg
constexpr double kDamping = 2e-3;                         // N m s/rad
constexpr double kRodLength = 0.4;                        // m
constexpr double kStiffness = 500, kDamper = 10;          // N/m, N s/m
constexpr double kHold = 2, kPull = 3, kRest = 7;         // s
constexpr double kOnRod = 8.0 / 26, kOnFloor = 1.0 / 26;  // shares of links, at either end

/// How the links are shared out, from the first to the last end: floor, strand, arch, strand, floor.
struct Layout {
  Index arch, strand, floor, more;  ///< `more`: of the last strand.

  explicit Layout(Index links)
      : arch(std::max<Index>(3, std::lround(kOnRod * static_cast<double>(links)))),
        floor(std::max<Index>(1, std::lround(kOnFloor * static_cast<double>(links)))) {
    const Index rest = links - arch - 2 * floor;
    strand = rest / 2;
    more = rest % 2;
  }

  double rod_radius(double clearance) const {
    const double half_turn = std::numbers::pi / 2 / static_cast<double>(arch);
    return kPitch / 2 / std::tan(half_turn) - kEdges.z() / 2 - clearance;
  }
  double strand_height() const { return kPitch * static_cast<double>(strand); }
};

/// Pitch angles (rad) of the links, from the first: 0 along x, pi/2 upwards.
std::vector<double> pitches(const Layout& layout) {
  std::vector<double> angles(layout.floor, 0.0);
  angles.insert(angles.end(), layout.strand, std::numbers::pi / 2);
  for (Index i = 0; i < layout.arch; ++i)
    angles.push_back(std::numbers::pi *
                     (0.5 - (static_cast<double>(i) + 0.5) / static_cast<double>(layout.arch)));
  angles.insert(angles.end(), layout.strand, -std::numbers::pi / 2);
  angles.insert(angles.end(), layout.floor + layout.more, 0.0);
  return angles;
}

/// A link's plates, side by side in its frame; a single one is as wide as two and what is between.
std::vector<collision::Shape> plates_of(Index link, Index plates) {
  const auto plate = [&](const Vector3d& edges, double side) {
    return collision::Shape{
        collision::Box{edges}, link, {Matrix3d::Identity(), {kPitch / 2, side, 0}}};
  };
  if (plates == 1) return {plate(kEdges + Vector3d(0, kApart, 0), 0)};
  return {plate(kEdges, -kApart / 2), plate(kEdges, kApart / 2)};
}

/// Of all plates of a link about its centre.
Matrix3d link_inertia(Index plates) {
  Matrix3d inertia = Matrix3d::Zero();
  for (const collision::Shape& plate : plates_of(0, plates)) {
    const double mass = kMass / static_cast<double>(plates), side = plate.in_link.p.y();
    inertia += solid_inertia(plate.geometry, mass);
    inertia.diagonal() += mass * side * side * Vector3d(1, 0, 1);
  }
  return inertia;
}

/// Links along x, centres in their middle.
Model chain(Index links, Index plates) {
  std::vector<Link> all;
  for (Index i = 0; i < links; ++i) {
    Link link;
    link.name = fmt::format("link{}", i + 1);
    link.mass = kMass;
    link.centre = {kPitch / 2, 0, 0};
    link.inertia = link_inertia(plates);
    if (i > 0) {
      link.parent = i - 1;
      link.joint = JointKind::ball;
      link.in_parent.p = {kPitch, 0, 0};
      link.damping = kDamping;
    }
    all.push_back(link);
  }
  return Model(std::move(all));
}

/// A turn about y by which x comes to point upwards at `pitch`.
Eigen::Quaterniond turned(double pitch) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(-pitch, Vector3d::UnitY()));
}

State start(const Model& model, const Layout& layout, const HoistKnobs& knobs) {
  State state = state_at_zero(model);
  const std::vector<double> angles = pitches(layout);
  // The arch stands over the rod, whose axis is at x = 0.
  const double half =
      kPitch / 2 / std::sin(std::numbers::pi / 2 / static_cast<double>(layout.arch));
  state.q.head<3>() =
      Vector3d(-half - kPitch * static_cast<double>(layout.floor), 0, kEdges.z() / 2 + knobs.lift);
  state.u.segment<3>(3) = Vector3d(0, 0, knobs.toss);
  for (Index i = 0; i < model.size(); ++i) {
    const double turn = i == 0 ? angles[0] : angles[i] - angles[i - 1];
    state.q.segment<4>(model.q_of(i) + (i == 0 ? 3 : 0)) = turned(turn).coeffs();
  }
  return state;
}

/// The hand at the last link, which pulls it from where it lies at the start.
std::function<std::vector<PointForce>(double, const Kinematics&)> hand(const Model& model,
                                                                       const State& at,
                                                                       const HoistKnobs& knobs) {
  const Index last = model.size() - 1;
  const Vector3d tip(kPitch / 2, 0, 0);
  Vector3d held = kinematics(model, at).pose[last] * tip;
  held.z() -= knobs.lift;
  const double way = knobs.pull * kPitch * static_cast<double>(model.size());
  return [=](double time, const Kinematics& k) -> std::vector<PointForce> {
    const double grip = smooth_step((time - kHold) / (kPull - kHold));
    if (grip == 0) return {};
    const Vector3d end = k.pose[last] * tip;
    const Vector3d hand =
        held + way * smooth_step((time - kPull) / (kRest - kPull)) * Vector3d::UnitX();
    const Vector3d velocity = velocity_at(k.from_origin(end), k.velocity[last]);
    return {{last, end, grip * (kStiffness * (hand - end) - kDamper * velocity)}};
  };
}

SceneSetup set_up(const HoistKnobs& knobs) {
  using namespace collision;
  const Layout layout(knobs.links);
  Model model = chain(knobs.links, knobs.plates);
  const State at = start(model, layout, knobs);

  std::vector<Index> handles;
  std::vector<Shape> shapes = {
      {HalfSpace{}},
      {Cylinder{layout.rod_radius(knobs.clearance), kRodLength},
       Link::world,
       {Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()).toRotationMatrix(),
        {0, 0, kEdges.z() / 2 + layout.strand_height()}}}};
  for (Index i = 0; i < model.size(); ++i) {
    handles.push_back(i);
    for (Shape& plate : plates_of(i, knobs.plates)) shapes.push_back(std::move(plate));
  }
  std::vector<LinkPair> joined;
  for (Index i = 1; i < model.size(); ++i) joined.emplace_back(i - 1, i);
  auto pull = hand(model, at, knobs);
  auto collide = touching(shapes, joined, knobs.surfaces);
  return {.system = {.model = std::move(model),
                     .start = at,
                     .handles = std::move(handles),
                     .collide = std::move(collide),
                     .pull = std::move(pull),
                     .mu = knobs.stepping.mu},
          .stepping = knobs.stepping.stepping(),
          .length = kPitch * static_cast<double>(knobs.links),
          .duration = 10,
          .shapes = std::move(shapes)};
}

const SceneRegistration hoist{
    {"hoist", "a chain thrown over a rod and pulled along the floor by one end",
     "Yamane and Nakamura 2008, V-C, Table III, Fig. 4"},
    HoistKnobs{},
    knob_table,
    set_up};

}  // namespace
}  // namespace lcp
