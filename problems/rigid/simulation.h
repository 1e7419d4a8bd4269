#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "problems/contact/contact_solution.h"
#include "problems/rigid/contact_dynamics.h"
#include "problems/rigid/joint_space.h"
#include "solvers/errors.h"

namespace lcp {

/// A force at a point of a link.
struct PointForce {
  Index link = 0;
  Vector3d position, force;  ///< m, N, world axes.
};

/// A system to simulate: bodies, where they start, what drives them and where they touch.
struct System {
  Model model;
  State start;
  std::vector<Index> handles;  ///< Links that may touch something, ascending.
  /// What prescribed joints do at a time (s); may stay empty where there are none.
  std::function<JointMotion(double time)> reference = {};
  /// Points at which links touch; ids name bodies as body_of. Their normal velocities are filled in.
  /// May stay empty where nothing ever touches.
  std::function<std::vector<ContactPoint>(const Kinematics&)> collide = {};
  /// Forces that pull at links besides gravity and contacts. May stay empty where no such force acts.
  std::function<std::vector<PointForce>(double time, const Kinematics&)> pull = {};
  double mu = 0.5;                      ///< Of every contact.
  Vector3d gravity = {0, 0, -9.80665};  ///< m/s^2.
};

struct Stepping {
  enum class Scheme {
    /// Fourth-order Runge-Kutta; contacts and forces of the first stage are held through the step.
    paper,
    /// Euler in u, then q moves with the new u.
    semi_implicit,
  };

  Scheme scheme = Scheme::paper;
  double dt = 1e-3;  ///< s.
  ContactModel contact = {};
  ReductionOptions reduction = {.method = ReductionOptions::Method::none};
  PositionCorrection correction = {};
  enum class Matrix {
    ada,    ///< By assembly and disassembly, with the noise of its differences.
    clean,  ///< As a product (see Simulation::clean_contacts).
  };

  Matrix matrix = Matrix::ada;  ///< Where contact matrices come from.
};

/// One step, as it is before it moves the bodies. References hold while the caller looks at it.
struct Frame {
  Index number = 0;
  const State& state;
  const Kinematics& kinematics;
  std::vector<ContactPoint> points;  ///< After reduction.
  Index points_found = 0;            ///< Before.
  LinkContacts links;
  ContactProblem contacts;  ///< Empty where nothing touches, and so are the following.
  ContactSolution solution;
  VectorXd link_forces;  ///< 6N on the handles, at kinematics.origin.
  std::vector<PointForce> pulls;
  const FrameSolutions& before;  ///< Of the step before this one; empty where nothing touched.

  /// Force of contact i on its body 1, N, world axes.
  Vector3d force(Index i) const;
};

/// Bodies no longer move at finite speed, as under the forces of a solver that is wrong.
struct SimulationBroke : Formatted<std::runtime_error> {
  using Formatted::Formatted;
};

/// Steps a system through time, with a solver in the loop. Deterministic.
class Simulation {
 public:
  /// Throws std::invalid_argument on a system that its parts refuse, without links, or whose start
  /// has another shape or is not finite; prescribed joints without a reference; dt not positive.
  Simulation(System system, Stepping stepping);

  const System& system() const { return *system_; }
  const Stepping& stepping() const { return stepping_; }
  const State& state() const { return state_; }

  /// Detects and solves the contacts, hands the frame to `look` and moves the bodies by dt: contact
  /// forces act through the whole step as they are at its beginning (forces of world axes at points
  /// fixed in the world). Throws SimulationBroke, naming the time, where the state or the contact
  /// problem is none: not finite, or its W nothing but rounding.
  void step(const ContactSolver& solver, const std::function<void(const Frame&)>& look = {});

  /// The contact problem of a frame with a matrix that is symmetric and positive semidefinite up to
  /// rounding of its entries: from the composite body's inertia where the system moves as one body
  /// at which nothing pulls, else from its joint space, with vbar of the ADA. To be asked for while
  /// looking at the frame.
  ContactProblem clean_contacts(const Frame& frame) const;
  /// Whether it is from the composite body.
  bool is_composite_body() const { return composite_.has_value(); }

 private:
  JointMotion reference(double time) const;
  void follow_reference(State& state) const;
  Kinematics kinematics_of(const State& state, const Vector3d& origin) const;
  std::vector<ContactPoint> contact_points(const Kinematics& kinematics) const;
  void pose_contacts(Frame& frame) const;
  void require_sound(const ContactProblem& contacts) const;
  void solve(Frame& frame, const ContactSolver& solver) const;
  /// Assembles the system under what acts on it but contacts, and `more` (6) on each link, if any.
  void assemble(ForwardDynamics& dynamics, const State& state, const Kinematics& kinematics,
                const std::vector<PointForce>& pulls, std::vector<Vector6d> more) const;
  VectorXd accelerations(const State& state, const Vector3d& origin, const VectorXd& forces);
  void move_by_runge_kutta(const VectorXd& first_stage, const Vector3d& origin,
                           const VectorXd& forces);

  /// Stays where it is when the simulation is moved: dynamics_ refers to its model.
  std::shared_ptr<const System> system_;
  Stepping stepping_;
  State state_;
  Index number_ = 0;
  FrameSolutions last_;  ///< Of the last step.
  ForwardDynamics dynamics_;
  ForwardDynamics later_stages_;  ///< Without handles: contact forces are known by then.
  std::optional<CompositeBody> composite_;
  JointSpace joint_space_;
};

}  // namespace lcp
