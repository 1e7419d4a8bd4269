// stack: boxes on top of one another, on a fixed floor.
//
// What      `bodies` equal boxes, each `mass_ratio` times as heavy as the one below it, with
//           `per_interface` contacts between neighbours and below the lowest. A contact shares bodies
//           with its neighbours only, so W is block tridiagonal; the forces must travel down the
//           whole stack, which takes iterative methods as many sweeps as there are boxes, and more
//           the more weight the light boxes below carry. rank(W) = 6 bodies from three contacts an
//           interface; redundant beyond that.
// Geometry  Each box is shifted along x and y by up to `offset` at random; neighbours touch along the
//           outline of the rectangle that they share, at equal shares of its edges.
// Motion    Resting; every box has a random twist whose components reach `disturbance` (linear, and
//           angular times half the length).
// Frames    Stand alone: each has new shifts and velocities, from one generator in sequence.
// Seed      Of that generator (mt19937_64).
// Source    Stacks are the standard trial of contact solvers, as in E. Guendelman, R. Bridson, R.
//           Fedkiw (2003), "Nonconvex rigid bodies with stacking", ACM Trans. Graphics 22(3), which
//           Yamane and Nakamura (2008) cite as [8]. The heavy box on light ones is what makes
//           Gauss-Seidel slow.

#include <algorithm>
#include <cmath>

#include "problems/families/contact/frame_knobs.h"
#include "problems/families/contact/rigid_bodies.h"
#include "solvers/errors.h"

namespace lcp {
namespace {

using Eigen::Vector3d;

struct StackKnobs {
  Index bodies = 4;
  Index per_interface = 4;
  double mass_ratio = 10;
  double mass = 1;
  double length = 0.2;
  double width = 0.15;
  double height = 0.1;
  double offset = 0.01;
  double disturbance = 1e-3;
  FrameKnobs frame;
};

OptionTable knob_table(StackKnobs& knobs) {
  OptionTable own = {
      count("bodies", knobs.bodies, 1, 64, "boxes"),
      count("per_interface", knobs.per_interface, 3, 64,
            "contacts between neighbours and on the floor"),
      real("mass_ratio", knobs.mass_ratio, 1e-3, 1e3, "mass of a box over that of the one below"),
      real("mass", knobs.mass, 1e-6, 1e6, "of the lowest box, kg"),
      real("length", knobs.length, 1e-3, 100, "of a box along x, m"),
      real("width", knobs.width, 1e-3, 100, "of a box along y, m"),
      real("height", knobs.height, 1e-3, 100, "of a box, m"),
      real("offset", knobs.offset, 0, 10, "largest shift of a box along x and y, m"),
      real("disturbance", knobs.disturbance, 0, 100,
           "largest random velocity of a centre, and of the ends by turning, m/s"),
  };
  return with_frame_knobs(std::move(own), knobs.frame, "along x", driver_of_lone_frames);
}

std::vector<RigidBody> draw_bodies(const StackKnobs& knobs, Random& random) {
  std::vector<RigidBody> bodies(knobs.bodies);
  double mass = knobs.mass;
  for (Index b = 0; b < knobs.bodies; ++b) {
    RigidBody& body = bodies[b];
    body.mass = mass;
    body.inertia = box_inertia(mass, {knobs.length, knobs.width, knobs.height});
    body.centre = random_vector(knobs.offset, random);
    body.centre.z() = (static_cast<double>(b) + 0.5) * knobs.height;
    body.velocity = random_vector(knobs.disturbance, random);
    body.angular_velocity = random_vector(knobs.disturbance, random) / (knobs.length / 2);
    mass *= knobs.mass_ratio;
  }
  return bodies;
}

/// Box b + 1 on what is below it, from the floor up.
std::vector<PlacedContact> touch(const StackKnobs& knobs, const std::vector<RigidBody>& bodies) {
  std::vector<PlacedContact> contacts;
  for (Index b = 0; b < knobs.bodies; ++b) {
    const Vector3d upper = bodies[b].centre;
    const Vector3d lower = b > 0 ? bodies[b - 1].centre : upper;
    Vector3d middle = (upper + lower) / 2;
    middle.z() = static_cast<double>(b) * knobs.height;
    const Vector3d shift = (upper - lower).cwiseAbs();
    for (const Vector3d& point : rectangle_outline(middle, knobs.length - shift.x(),
                                                   knobs.width - shift.y(), knobs.per_interface)) {
      const Index feature = static_cast<Index>(contacts.size()) - b * knobs.per_interface;
      contacts.push_back(
          {make_contact(Vector3d::UnitZ(), Vector3d::UnitX(), knobs.frame.mu, {b + 1, b, feature}),
           point});
    }
  }
  return contacts;
}

std::vector<Instance> generate_stack(const StackKnobs& knobs, const Draw& draw) {
  const double narrow = std::min(knobs.length, knobs.width);
  if (!(2 * knobs.offset < narrow))
    throw InvalidArgument(
        "stack: offset={}: neighbours may miss one another; expected less than half the "
        "shorter edge, {}",
        knobs.offset, narrow / 2);
  return lone_frames(knobs.frame, draw, [&](Random& random, auto& provenance) {
    const std::vector<RigidBody> bodies = draw_bodies(knobs, random);
    const std::vector<PlacedContact> contacts = touch(knobs, bodies);
    provenance["contact_positions"] = spell_positions(contacts);
    return contact_problem(bodies, contacts, knobs.frame.dt);
  });
}

const FamilyRegistration stack{
    {"stack", "boxes on top of one another, each heavier than the one below",
     "Guendelman, Bridson and Fedkiw 2003", 50},
    StackKnobs{},
    knob_table,
    generate_stack};

}  // namespace
}  // namespace lcp
