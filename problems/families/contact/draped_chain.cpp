// draped-chain: frames of a chain that hangs over a fixed horizontal rod and is shaken.
//
// What      A chain of rods with ball joints; some links lie on the upper half of the rod with two
//           beads each, the ends hang down and carry heavier links. Forces reach every contact
//           through the joints, so W is dense; neighbouring beads, of one link and of the next, move
//           almost alike, so W is rank-deficient and badly conditioned. 26 links, 12 of them on the
//           rod: about 24 contacts, n about 240.
// Series    Each frame starts from the velocity and the pose to which the forces of the frame before
//           led (bead_chain.h; semi-implicit: the pose moves with v+). So that the chain goes on
//           moving, every `shake_every` frames, and at the first, its velocity is replaced by a
//           seeded one that the joints allow: sliding around the rod with up to `slide_speed`, and
//           sideways along it in half waves of up to `shake_speed`.
// Seed      Of the generator (mt19937_64) of these velocities.
// Touch     A bead within `margin` of the rod is a contact; a bead inside it is pushed out by 0.005
//           of its depth a step.
// Source    The kind of problem of K. Yamane, Y. Nakamura (2008), V-B (hoisting chain), Table III.

#include <cmath>
#include <numbers>

#include "problems/families/contact/bead_chain.h"
#include "problems/families/contact/frame_knobs.h"
#include "solvers/errors.h"

namespace lcp {
namespace {

using Eigen::Vector3d;

struct ChainKnobs {
  Index links = 26;
  Index wrapped = 12;
  double mass_ratio = 10;
  double link_mass = 0.02;
  double link_length = 0.03;
  double bead_radius = 0.004;
  double bead_offset = 0.4;
  double axial_share = 0.05;
  double margin = 2e-4;
  FrameKnobs frame{.mu = 0.3};
  Index shake_every = 10;
  double slide_speed = 0.3;
  double shake_speed = 0.3;
};

OptionTable knob_table(ChainKnobs& knobs) {
  OptionTable own = {
      count("links", knobs.links, 2, 100, "links of the chain"),
      count("wrapped", knobs.wrapped, 2, 100,
            "links on the rod, two contacts each; half of the others hang on either side"),
      real("mass_ratio", knobs.mass_ratio, 1e-3, 1e6, "mass of either end link over another's"),
      real("link_mass", knobs.link_mass, 1e-6, 1e3, "kg"),
      real("link_length", knobs.link_length, 1e-3, 10, "m"),
      real("bead_radius", knobs.bead_radius, 1e-5, 1, "m"),
      real("bead_offset", knobs.bead_offset, 0.01, 0.5,
           "bead from the centre of its link, in link lengths"),
      real("axial_share", knobs.axial_share, 1e-6, 1, "axial over transverse inertia of a link"),
      real("margin", knobs.margin, 0, 0.1, "largest gap of a contact, m"),
      count("shake_every", knobs.shake_every, 1, 1000000, "frames between new velocities"),
      real("slide_speed", knobs.slide_speed, 0, 100, "largest speed around the rod, m/s"),
      real("shake_speed", knobs.shake_speed, 0, 100, "largest speed along the rod, m/s"),
  };
  return with_frame_knobs(std::move(own), knobs.frame, "around the rod", driver_of_a_series);
}

/// From the centre of the rod to the centre of a link that lies on it, m.
double link_distance(const ChainKnobs& knobs) {
  const double turn = std::numbers::pi / static_cast<double>(knobs.wrapped);
  return knobs.link_length / 2 / std::tan(turn / 2);
}

/// The rod on which `wrapped` links fill half a turn, every bead touching.
FixedRod make_rod(const ChainKnobs& knobs) {
  FixedRod rod;
  rod.radius =
      std::hypot(link_distance(knobs), knobs.bead_offset * knobs.link_length) - knobs.bead_radius;
  rod.margin = knobs.margin;
  rod.mu = knobs.frame.mu;
  return rod;
}

/// The chain at rest: up one side, over the rod, down the other.
BeadChain drape(const ChainKnobs& knobs) {
  BeadChain chain;
  chain.link_length = knobs.link_length;
  chain.bead_radius = knobs.bead_radius;
  chain.bead_offset = knobs.bead_offset * knobs.link_length;
  chain.axial_share = knobs.axial_share;
  chain.masses = VectorXd::Constant(knobs.links, knobs.link_mass);
  chain.masses(0) = chain.masses(knobs.links - 1) = knobs.mass_ratio * knobs.link_mass;
  chain.nu = VectorXd::Zero(6 * knobs.links);

  const Index rising = (knobs.links - knobs.wrapped) / 2;
  const double turn = std::numbers::pi / static_cast<double>(knobs.wrapped);
  chain.axes.resize(3, knobs.links);
  for (Index i = 0; i < knobs.links; ++i) {
    // Angle from straight up: 0 while rising, pi while falling.
    const double place = static_cast<double>(i - rising) + 0.5;
    const double angle = std::clamp(place * turn, 0.0, std::numbers::pi);
    chain.axes.col(i) << std::sin(angle), 0, std::cos(angle);
  }
  const double corner = std::hypot(link_distance(knobs), knobs.link_length / 2);
  chain.head << -corner, 0, -static_cast<double>(rising) * knobs.link_length;
  return chain;
}

/// A velocity that the joints allow: along the chain, and along the rod in one to three half waves.
VectorXd shake(const BeadChain& chain, const ChainKnobs& knobs, Random& random) {
  const double slide = knobs.slide_speed * random.between(-1, 1);
  const Vector3d waves =
      knobs.shake_speed *
      Vector3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)) / 3;
  BeadChain shaken = chain;
  shaken.nu.setZero();
  for (Index i = 0; i < chain.links(); ++i) {
    const double phase =
        std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(chain.links());
    shaken.nu.segment<3>(6 * i) = slide * chain.axes.col(i);
    for (Index k = 0; k < waves.size(); ++k)
      shaken.nu(6 * i + 1) += waves(k) * std::sin(static_cast<double>(k + 1) * phase);
  }
  return joined_velocity(shaken);
}

std::vector<Instance> generate_chain(const ChainKnobs& knobs, const Draw& draw) {
  if (knobs.wrapped > knobs.links)
    throw InvalidArgument("draped-chain: wrapped={}: expected at most links={}", knobs.wrapped,
                          knobs.links);
  const FixedRod rod = make_rod(knobs);
  if (!(rod.radius > 0))
    throw InvalidArgument(
        "draped-chain: wrapped={} links leave no room for a rod between them; expected "
        "more, longer ones, or smaller beads",
        knobs.wrapped);
  FrameSeries series(draw.corpus, knobs.frame.driver, knobs.frame.friction_model());
  Random random(draw.seed);
  BeadChain chain = drape(knobs);
  for (Index frame = 0; frame < draw.count; ++frame) {
    const bool shaken = frame % knobs.shake_every == 0;
    if (shaken) chain.nu = shake(chain, knobs, random);
    const ChainStep step(chain, rod, knobs.frame.dt);
    const VectorXd forces =
        series.add(step.contact_problem(), knobs.frame.dt * static_cast<double>(frame + 1),
                   shaken ? "seeded sliding and shaking" : "");
    chain.nu = step.velocity_after(forces);
    chain.advance(knobs.frame.dt);
  }
  return series.take();
}

const FamilyRegistration draped_chain{
    {"draped-chain", "a chain shaken over a fixed rod: dense, rank-deficient W, heavy ends",
     "Yamane and Nakamura 2008, V-B", 50},
    ChainKnobs{},
    knob_table,
    generate_chain};

}  // namespace
}  // namespace lcp
