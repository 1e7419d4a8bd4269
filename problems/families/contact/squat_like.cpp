// squat-like: frames of a rigid composite body that squats and sways on two flat feet.
//
// What      What a humanoid under perfect joint control is to its contacts: one rigid body whose
//           centre of mass moves in a prescribed way, on coplanar contacts along the edges of both
//           soles. rank(W) = 6 whatever their number; with 16 contacts and 8 directions n = 160.
// Model     Twist (v_b, omega) of the feet, about a point b on the floor between them; centre of
//           mass at r(t) from b, lean, sway and bob with one phase s:
//               r = (A_l sin(w_l t + s), A_s sin(w_s t + s), h - A_b (1 - cos(w_b t + s)) / 2).
//           Momentum p = m (v_b + omega x r + r'), spin L = I omega, I constant. One step is
//               p+ = p + dt m g + dt sum f_i,   L+ = L + dt sum (x_i - r) x f_i,
//           with r and r' at its end, so that contact i moves with v_i+ = W f + vbar,
//               W_ij = dt (1/m - [x_i - r]x I^-1 [x_j - r]x).
//           The step starts from (p, L) as the forces of the frame before left them, uncleaned: the
//           rounding noise in them decides which rows are tied.
// Held      Only velocities are carried on. The pose of the feet is held, so the points stay the
//           same: exact for sliding on a floor, an approximation for tilting soles, which do not
//           tilt here because the zero moment point stays between the feet.
// Seed      Shifts the phase s, by less than 0.2 rad; seed 1 stands for s = 0.
// Source    The experiment of K. Yamane, Y. Nakamura (2008), V-A and Table I, reduced to the body
//           that its contacts see; size and weight of a 7 kg, 0.55 m robot.

#include <cmath>
#include <numbers>

#include "problems/families/contact/frame_knobs.h"
#include "problems/families/contact/rigid_bodies.h"
#include "solvers/errors.h"

namespace lcp {
namespace {

using Eigen::Vector3d;

struct SquatKnobs {
  Index contacts = 16;
  FrameKnobs frame;
  double mass = 7;
  double com_height = 0.28;
  double bob_amplitude = 0.06;
  double bob_frequency = 1;
  double sway_amplitude = 0.03;
  double sway_frequency = 0.8;
  double lean_amplitude = 0.005;
  double lean_frequency = 0.6;
  double sole_length = 0.12;
  double sole_width = 0.07;
  double stance = 0.1;
};

OptionTable knob_table(SquatKnobs& knobs) {
  OptionTable own = {
      count("contacts", knobs.contacts, 4, 128,
            "even; along the edges of both soles: 8 corners only, 16 corners and mid-edges"),
      real("mass", knobs.mass, 1e-3, 1e6, "kg"),
      real("com_height", knobs.com_height, 0.01, 10, "highest point of the centre of mass, m"),
      real("bob_amplitude", knobs.bob_amplitude, 0, 1, "depth of the squat, m"),
      real("bob_frequency", knobs.bob_frequency, 0, 100, "squats per second, Hz"),
      real("sway_amplitude", knobs.sway_amplitude, 0, 1, "sway to either side, m"),
      real("sway_frequency", knobs.sway_frequency, 0, 100, "sways per second, Hz"),
      real("lean_amplitude", knobs.lean_amplitude, 0, 1, "sway to front and back, m"),
      real("lean_frequency", knobs.lean_frequency, 0, 100, "sways to front and back, Hz"),
      real("sole_length", knobs.sole_length, 1e-3, 10, "along the walking direction, m"),
      real("sole_width", knobs.sole_width, 1e-3, 10, "across it, m"),
      real("stance", knobs.stance, 0, 10, "between the centres of the soles, m"),
  };
  return with_frame_knobs(std::move(own), knobs.frame, "forward", driver_of_a_series);
}

constexpr double kGravity = 9.81;  // m/s^2

/// Centre of mass relative to b and its velocity, prescribed.
struct Motion {
  Vector3d position;
  Vector3d velocity;
};

class Squat {
 public:
  Squat(const SquatKnobs& knobs, std::uint64_t seed) : knobs_(knobs), points_(sole_points(knobs)) {
    // A box as large as the robot's body.
    const Vector3d box(0.15, 0.20, 0.50);
    inertia_ = box_inertia(knobs.mass, box);
    // Multiples of the golden ratio are spread evenly; seed 1 stands for no shift.
    const double turns = static_cast<double>(seed - 1) * std::numbers::phi;
    phase_ = kLargestPhaseShift * (turns - std::floor(turns));
    momentum_ = knobs_.mass * motion(0).velocity;
  }

  /// The step from `time` - dt to `time`.
  ContactProblem contact_problem(double time) const {
    const Vector3d r = motion(time).position;
    ContactProblem problem;
    problem.dt = knobs_.frame.dt;
    for (std::size_t i = 0; i < points_.size(); ++i)
      problem.contacts.push_back(make_contact(Vector3d::UnitZ(), Vector3d::UnitX(), knobs_.frame.mu,
                                              {1, 0, static_cast<Index>(i)}));
    const MatrixXd axes = contact_axes(problem.contacts);
    const RigidBody body{.mass = knobs_.mass, .inertia = inertia_, .centre = r};
    MatrixXd A(6, axes.rows());
    for (Index row = 0; row < axes.rows(); ++row)
      A.col(row) = weighted_push(body, points_[row / 3], axes.row(row).transpose());
    problem.W = delassus_matrix(A, knobs_.frame.dt);
    problem.v_before = velocities(axes, momentum_, time - knobs_.frame.dt);
    problem.vbar = velocities(axes, momentum_ + knobs_.frame.dt * knobs_.mass * gravity(), time);
    return problem;
  }

  /// Carries the body on under contact forces (3 Nc, N, contact axes).
  void step(double time, const ContactProblem& problem, const VectorXd& forces) {
    const Vector3d r = motion(time).position;
    momentum_ += knobs_.frame.dt * knobs_.mass * gravity();
    for (Index i = 0; i < problem.size(); ++i) {
      const Contact& contact = problem.contacts[i];
      const Vector3d f = forces(3 * i) * contact.n + forces(3 * i + 1) * contact.t1 +
                         forces(3 * i + 2) * contact.t2;
      momentum_ += knobs_.frame.dt * f;
      omega_ += knobs_.frame.dt * (points_[i] - r).cross(f).cwiseQuotient(inertia_);
    }
  }

 private:
  static constexpr double kLargestPhaseShift = 0.2;  // rad, by which seeds differ

  static Vector3d gravity() { return {0, 0, -kGravity}; }

  /// Along the edges of either sole, from the front left corner, both soles alike.
  static std::vector<Vector3d> sole_points(const SquatKnobs& knobs) {
    std::vector<Vector3d> points;
    for (const double side : {1.0, -1.0})
      for (const Vector3d& point :
           rectangle_outline(Vector3d(0, side * knobs.stance / 2, 0), knobs.sole_length,
                             knobs.sole_width, knobs.contacts / 2))
        points.push_back(point);
    return points;
  }

  Motion motion(double time) const {
    const double lean_rate = 2 * std::numbers::pi * knobs_.lean_frequency;
    const double sway_rate = 2 * std::numbers::pi * knobs_.sway_frequency;
    const double bob_rate = 2 * std::numbers::pi * knobs_.bob_frequency;
    const double lean = lean_rate * time + phase_;
    const double sway = sway_rate * time + phase_;
    const double bob = bob_rate * time + phase_;
    return {{knobs_.lean_amplitude * std::sin(lean), knobs_.sway_amplitude * std::sin(sway),
             knobs_.com_height - knobs_.bob_amplitude * (1 - std::cos(bob)) / 2},
            {knobs_.lean_amplitude * lean_rate * std::cos(lean),
             knobs_.sway_amplitude * sway_rate * std::cos(sway),
             -knobs_.bob_amplitude * bob_rate * std::sin(bob) / 2}};
  }

  /// Contact velocities of the feet at `time`, if the body has this momentum.
  VectorXd velocities(const MatrixXd& axes, const Vector3d& momentum, double time) const {
    const Motion com = motion(time);
    const Vector3d v_b = momentum / knobs_.mass - omega_.cross(com.position) - com.velocity;
    VectorXd velocity(axes.rows());
    for (Index row = 0; row < axes.rows(); ++row)
      velocity(row) = axes.row(row).dot(v_b + omega_.cross(points_[row / 3]));
    return velocity;
  }

  SquatKnobs knobs_;
  double phase_ = 0;  ///< rad.
  std::vector<Vector3d> points_;
  Vector3d inertia_;                   ///< Principal moments about the centre of mass, kg m^2.
  Vector3d momentum_;                  ///< kg m/s.
  Vector3d omega_ = Vector3d::Zero();  ///< rad/s.
};

std::vector<Instance> generate_squat(const SquatKnobs& knobs, const Draw& draw) {
  if (knobs.contacts % 2 != 0)
    throw InvalidArgument("squat-like: contacts={}: expected an even number, half on each foot",
                          knobs.contacts);
  FrameSeries series(draw.corpus, knobs.frame.driver, knobs.frame.friction_model());
  Squat squat(knobs, draw.seed);
  for (Index frame = 0; frame < draw.count; ++frame) {
    const double time = knobs.frame.dt * static_cast<double>(frame + 1);
    const ContactProblem problem = squat.contact_problem(time);
    squat.step(time, problem, series.add(problem, time, frame == 0 ? "feet at rest" : ""));
  }
  return series.take();
}

const FamilyRegistration squat_like{
    {"squat-like", "a body squats and sways on two flat feet: coplanar contacts, rank(W) = 6",
     "Yamane and Nakamura 2008, V-A", 200},
    SquatKnobs{},
    knob_table,
    generate_squat};

}  // namespace
}  // namespace lcp
