// peg-in-hole: a round peg pushed into a round hole and against its wall.
//
// What      Contacts all around the peg at several heights, normals radial: they hold 4 degrees of
//           freedom, axial sliding and turning are left to friction. Opposite contacts can press
//           against one another with any force, so that friction jams the peg (force closure): W is
//           singular, and forces that hold are far from unique.
// Geometry  Peg of `radius` and `length`; hole with a vertical axis through the origin and `clearance`
//           more radius. The peg leans in a random direction phi by `tilt` times the most that the
//           clearance allows, and is shifted towards phi until its upper end touches; at tilt = 1 the
//           lower end touches opposite, as in two-point wedging, at tilt = 0 one side all along.
//           Points at `rings` heights from end to end, `per_ring` around each, the first towards phi,
//           are contacts where their gap is at most `margin`. Without clearance all are.
// Motion    Moving in along its axis at `speed`, plus a random twist whose components reach
//           `disturbance` (linear, and angular times half the length). Besides weight, `push` acts
//           across at the centre of the upper end in a random direction, `press` downwards.
// Frames    Stand alone: each has new phi, push direction and velocities, from one generator in
//           sequence.
// Seed      Of that generator (mt19937_64).
// Source    The two-point wedging and jamming of D. E. Whitney (1982), "Quasi-static assembly of
//           compliantly supported rigid parts", J. Dynamic Systems, Measurement, and Control 104.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/families/contact/frame_knobs.h"
#include "problems/families/contact/rigid_bodies.h"
#include "solvers/errors.h"

namespace lcp {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

struct PegKnobs {
  Index rings = 3;
  Index per_ring = 8;
  double radius = 0.01;
  double length = 0.04;
  double mass = 0.2;
  double clearance = 0;
  double tilt = 1;
  double margin = 2e-4;
  double speed = 0.1;
  double disturbance = 1e-3;
  double push = 5;
  double press = 0;
  FrameKnobs frame{.mu = 0.3};
};

OptionTable knob_table(PegKnobs& knobs) {
  OptionTable own = {
      count("rings", knobs.rings, 2, 32, "heights with contacts, from end to end"),
      count("per_ring", knobs.per_ring, 3, 64, "points around the peg at each height"),
      real("radius", knobs.radius, 1e-4, 10, "of the peg, m"),
      real("length", knobs.length, 1e-4, 100, "of the peg, m"),
      real("mass", knobs.mass, 1e-6, 1e6, "kg"),
      real("clearance", knobs.clearance, 0, 10, "radius of the hole less the peg's, m"),
      real("tilt", knobs.tilt, 0, 1, "share of the tilt that the clearance allows"),
      real("margin", knobs.margin, 0, 10, "m: points with at most this gap are contacts"),
      real("speed", knobs.speed, 0, 100, "into the hole, m/s"),
      real("disturbance", knobs.disturbance, 0, 100,
           "largest random velocity of the centre, and of the ends by turning, m/s"),
      real("push", knobs.push, 0, 1e6, "force across, at the upper end, N"),
      real("press", knobs.press, 0, 1e6, "force downwards, N"),
  };
  return with_frame_knobs(std::move(own), knobs.frame, "upwards", driver_of_lone_frames);
}

/// Angle psi at which both ends of the peg touch: (l/2) sin psi + r cos psi = hole's radius.
double largest_tilt(const PegKnobs& knobs) {
  const double half = knobs.length / 2, hole = knobs.radius + knobs.clearance;
  const double diagonal = std::hypot(half, knobs.radius);
  if (!(hole < diagonal))
    throw InvalidArgument("peg-in-hole: clearance={}: the peg can turn over; expected less than {}",
                          knobs.clearance, diagonal - knobs.radius);
  return std::max(0.0, std::asin(hole / diagonal) - std::asin(knobs.radius / diagonal));
}

/// The peg leaning towards +x, upper end touching; its principal axes are across, y and along.
RigidBody leaning_peg(const PegKnobs& knobs) {
  const double tilt = knobs.tilt * largest_tilt(knobs), half = knobs.length / 2;
  const double r2 = knobs.radius * knobs.radius, l2 = knobs.length * knobs.length;
  RigidBody peg;
  peg.mass = knobs.mass;
  peg.inertia = knobs.mass * Vector3d((3 * r2 + l2) / 12, (3 * r2 + l2) / 12, r2 / 2);
  peg.axes = Eigen::AngleAxisd(tilt, Vector3d::UnitY()).toRotationMatrix();
  peg.centre.x() =
      knobs.clearance + knobs.radius - half * std::sin(tilt) - knobs.radius * std::cos(tilt);
  return peg;
}

RigidBody draw_peg(const PegKnobs& knobs, Random& random) {
  const auto disturbance = [&] { return random_vector(knobs.disturbance, random); };
  RigidBody peg = leaning_peg(knobs);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2 * pi * random.between(0, 1), Vector3d::UnitZ()).toRotationMatrix();
  peg.axes = turn * peg.axes;
  peg.centre = turn * peg.centre;
  const Vector3d along = peg.axes.col(2);
  const double towards = 2 * pi * random.between(0, 1);
  const Vector3d push = knobs.push * Vector3d(std::cos(towards), std::sin(towards), 0);
  peg.force = push - knobs.press * Vector3d::UnitZ();
  peg.moment = (knobs.length / 2 * along).cross(push);
  peg.velocity = disturbance() - knobs.speed * along;
  peg.angular_velocity = disturbance() / (knobs.length / 2);
  return peg;
}

/// From the lowest ring up, each from phi on; the feature counts points whether they touch or not.
std::vector<PlacedContact> touch(const PegKnobs& knobs, const RigidBody& peg) {
  std::vector<PlacedContact> contacts;
  for (Index k = 0; k < knobs.rings; ++k) {
    const double height =
        knobs.length * (static_cast<double>(k) / static_cast<double>(knobs.rings - 1) - 0.5);
    for (Index j = 0; j < knobs.per_ring; ++j) {
      const double angle = 2 * pi * static_cast<double>(j) / static_cast<double>(knobs.per_ring);
      const Vector3d point =
          peg.centre + peg.axes * Vector3d(knobs.radius * std::cos(angle),
                                           knobs.radius * std::sin(angle), height);
      const Vector3d radial(point.x(), point.y(), 0);
      const double gap = knobs.radius + knobs.clearance - radial.norm();
      if (gap > knobs.margin) continue;
      contacts.push_back(
          {make_contact(-radial, Vector3d::UnitZ(), knobs.frame.mu, {1, 0, k * knobs.per_ring + j}),
           point, -gap});
    }
  }
  return contacts;
}

std::vector<Instance> generate_peg(const PegKnobs& knobs, const Draw& draw) {
  return lone_frames(knobs.frame, draw, [&](Random& random, auto& provenance) {
    const RigidBody peg = draw_peg(knobs, random);
    const std::vector<PlacedContact> contacts = touch(knobs, peg);
    provenance["contact_positions"] = spell_positions(contacts);
    return contact_problem({peg}, contacts, knobs.frame.dt);
  });
}

const FamilyRegistration peg_in_hole{
    {"peg-in-hole", "a peg pushed into a hole: opposite contacts that jam", "Whitney 1982", 50},
    PegKnobs{},
    knob_table,
    generate_peg};

}  // namespace
}  // namespace lcp
