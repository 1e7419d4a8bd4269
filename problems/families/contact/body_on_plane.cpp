// body-on-plane: one box on a fixed plane, touched at any number of points.
//
// What      The smallest contact problem with as much redundancy as one likes: 6 degrees of freedom,
//           3 of which coplanar normals hold, against 3 ... 256 points. rank(W) <= 6, of its normal
//           part 3 where the points are coplanar, 2 where they are collinear.
// Layouts   coplanar     the points are drawn one to a sector around the foot of the centre of mass,
//                        at a random share of the way to the edge of a disc or rectangle; with 4 or
//                        more points the centre of mass is above their polygon.
//           collinear    on a line through that foot in a random direction, one to a stretch.
//           duplicated   coplanar places, each taken by `copies` contacts: columns of W that agree to
//                        the bit, ties that no arithmetic can tell apart.
//           noisy        coplanar, then each point moved by up to `noise` along x, y and z (below the
//                        plane it counts as penetrating), and each normal tilted by up to
//                        `normal_noise`: what a collision test on meshes returns.
// Motion    Resting or sliding in a random direction at `speed`; to either a twist is added whose
//           components are random, up to `disturbance` (linear, and angular times half the length).
// Frames    Stand alone: each has new points and velocities, from one generator in sequence. Contacts
//           come in the order of problems/contact/reduction.h, whose rules can thin them out.
// Seed      Of that generator (mt19937_64).
// Source    The redundant contacts of K. Yamane, Y. Nakamura (2008), IV-C and V-A, on one body.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/contact/reduction.h"
#include "problems/families/contact/frame_knobs.h"
#include "problems/families/contact/rigid_bodies.h"
#include "solvers/errors.h"

namespace lcp {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

struct PlaneKnobs {
  enum class Layout { coplanar, collinear, duplicated, noisy };
  enum class Patch { disc, rectangle };
  enum class Motion { resting, sliding };

  Index contacts = 16;
  Layout layout = Layout::coplanar;
  Patch patch = Patch::rectangle;
  Index copies = 2;
  double noise = 1e-4;
  double normal_noise = 0.01;
  Motion motion = Motion::resting;
  double speed = 0.3;
  double disturbance = 1e-3;
  double mass = 1;
  double length = 0.2;
  double width = 0.15;
  double height = 0.1;
  double inertia = 1;
  ReductionOptions reduction{.method = ReductionOptions::Method::none};
  FrameKnobs frame;
};

OptionTable knob_table(PlaneKnobs& knobs) {
  OptionTable own = {
      count("contacts", knobs.contacts, 3, 256, "points before the reduction"),
      choice("layout", knobs.layout, "how the points lie"),
      choice("patch", knobs.patch,
             "what the points fill: the box's face, or the largest disc in it"),
      count("copies", knobs.copies, 2, 256, "contacts at each place; layout=duplicated"),
      real("noise", knobs.noise, 0, 0.1, "m, of each coordinate; layout=noisy"),
      real("normal_noise", knobs.normal_noise, 0, 0.5, "rad, of each normal; layout=noisy"),
      choice("motion", knobs.motion, "before the step"),
      real("speed", knobs.speed, 0, 100, "m/s; motion=sliding"),
      real("disturbance", knobs.disturbance, 0, 100,
           "largest random velocity of the centre, and of the ends by turning, m/s"),
      real("mass", knobs.mass, 1e-6, 1e6, "kg"),
      real("length", knobs.length, 1e-3, 100, "of the box along x, m"),
      real("width", knobs.width, 1e-3, 100, "of the box along y, m"),
      real("height", knobs.height, 1e-3, 100, "of the box, m"),
      real("inertia", knobs.inertia, 1e-3, 1e3, "over that of the homogeneous box"),
      choice("reduction", knobs.reduction.method,
             "which points become contacts: all, the paper's choice, the four deepest"),
      choice("separating", knobs.reduction.separating,
             "what a reduction does with points whose bodies separate"),
  };
  return with_frame_knobs(std::move(own), knobs.frame, "along x", driver_of_lone_frames);
}

/// From the middle of the patch to its edge at an angle, m.
double reach(const PlaneKnobs& knobs, double angle) {
  const double x = knobs.length / 2, y = knobs.width / 2;
  if (knobs.patch == PlaneKnobs::Patch::disc) return std::min(x, y);
  return 1 / std::max(std::abs(std::cos(angle)) / x, std::abs(std::sin(angle)) / y);
}

Vector3d at(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

std::vector<Vector3d> draw_places(const PlaneKnobs& knobs, Random& random) {
  const bool collinear = knobs.layout == PlaneKnobs::Layout::collinear;
  const Index copies = knobs.layout == PlaneKnobs::Layout::duplicated ? knobs.copies : 1;
  const double places = static_cast<double>(knobs.contacts / copies);
  const double direction = 2 * pi * random.between(0, 1);
  std::vector<Vector3d> points;
  for (double i = 0; i < places; ++i) {
    Vector3d point;
    if (collinear) {
      const double share = (2 * (i + random.between(0, 1)) - places) / places;
      point = at(share * reach(knobs, direction), direction);
    } else {
      // Within the middle half of its sector, so that no gap between points reaches half a turn.
      const double angle = direction + 2 * pi * (i + random.between(0, 1) / 2) / places;
      point = at(std::sqrt(random.between(0, 1)) * reach(knobs, angle), angle);
    }
    points.insert(points.end(), copies, point);
  }
  return points;
}

/// The box over the foot of its centre of mass at the origin, moving.
RigidBody draw_body(const PlaneKnobs& knobs, Random& random) {
  const auto disturbance = [&] { return random_vector(knobs.disturbance, random); };
  RigidBody body;
  body.mass = knobs.mass;
  body.inertia = knobs.inertia * box_inertia(knobs.mass, {knobs.length, knobs.width, knobs.height});
  body.centre.z() = knobs.height / 2;
  if (knobs.motion == PlaneKnobs::Motion::sliding)
    body.velocity = at(knobs.speed, 2 * pi * random.between(0, 1));
  body.velocity += disturbance();
  body.angular_velocity = disturbance() / (knobs.length / 2);
  return body;
}

/// The points that a collision test would return, a feature each.
std::vector<ContactPoint> draw_points(const PlaneKnobs& knobs, const RigidBody& body,
                                      Random& random) {
  std::vector<ContactPoint> points;
  for (const Vector3d& place : draw_places(knobs, random)) {
    ContactPoint point{.position = place, .normal = Vector3d::UnitZ()};
    point.id = {1, 0, static_cast<Index>(points.size())};
    if (knobs.layout == PlaneKnobs::Layout::noisy) {
      for (double& coordinate : point.position) coordinate += knobs.noise * random.between(-1, 1);
      const double towards = 2 * pi * random.between(0, 1),
                   tilt = knobs.normal_noise * random.between(0, 1);
      point.normal = at(std::sin(tilt), towards) + std::cos(tilt) * Vector3d::UnitZ();
      point.depth = -point.position.z();
    }
    point.normal_velocity = point.normal.dot(body.velocity_at(point.position));
    points.push_back(point);
  }
  return points;
}

std::vector<Instance> generate_plane(const PlaneKnobs& knobs, const Draw& draw) {
  if (knobs.layout == PlaneKnobs::Layout::duplicated && knobs.contacts % knobs.copies != 0)
    throw InvalidArgument("body-on-plane: contacts={}: expected a multiple of copies={}",
                          knobs.contacts, knobs.copies);
  return lone_frames(knobs.frame, draw, [&](Random& random, auto& provenance) {
    const RigidBody body = draw_body(knobs, random);
    const std::vector<ContactPoint> points = draw_points(knobs, body, random);
    std::vector<PlacedContact> contacts;
    for (const Index i : reduce_contacts(points, knobs.reduction))
      contacts.push_back(
          {make_contact(points[i].normal, Vector3d::UnitX(), knobs.frame.mu, points[i].id),
           points[i].position, points[i].depth});
    provenance["points_found"] = std::to_string(points.size());
    provenance["contact_positions"] = spell_positions(contacts);
    return contact_problem({body}, contacts, knobs.frame.dt);
  });
}

const FamilyRegistration body_on_plane{
    {"body-on-plane", "a box on a plane, touched at 3 ... 256 points: rank(W) <= 6",
     "Yamane and Nakamura 2008, IV-C", 50},
    PlaneKnobs{},
    knob_table,
    generate_plane};

}  // namespace
}  // namespace lcp
