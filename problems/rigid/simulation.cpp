#include "problems/rigid/simulation.h"

#include <cmath>
#include <stdexcept>

#include "solvers/errors.h"

namespace lcp {

Vector3d Frame::force(Index i) const {
  const Contact& contact = contacts.contacts[i];
  const auto f = solution.forces.segment<3>(3 * i);
  return f(0) * contact.n + f(1) * contact.t1 + f(2) * contact.t2;
}

Simulation::Simulation(System system, Stepping stepping)
    : system_(std::make_shared<const System>(std::move(system))),
      stepping_(std::move(stepping)),
      state_(system_->start),
      dynamics_(system_->model, system_->handles),
      later_stages_(system_->model, {}),
      joint_space_(system_->model, system_->handles) {
  const Model& model = system_->model;
  if (!(stepping_.dt > 0) || !std::isfinite(stepping_.dt))
    throw InvalidArgument("simulation: dt is {} s, expected a positive time", stepping_.dt);
  if (model.size() == 0) throw std::invalid_argument("simulation: the model has no links");
  if (state_.q.size() != model.coordinates() || state_.u.size() != model.velocities())
    throw InvalidArgument(
        "simulation: the start has {} coordinates and {} velocities, expected {} and {}",
        state_.q.size(), state_.u.size(), model.coordinates(), model.velocities());
  if (!state_.q.allFinite() || !state_.u.allFinite() || !std::isfinite(state_.time))
    throw std::invalid_argument("simulation: the start is not finite");
  if (!(system_->mu >= 0) || !std::isfinite(system_->mu))
    throw InvalidArgument("simulation: mu is {}, expected 0 or more", system_->mu);
  if (!model.prescribed().empty() && !system_->reference)
    throw std::invalid_argument("simulation: prescribed joints without a reference motion");
  if (moves_as_one_body(model) && !system_->pull)
    composite_.emplace(model, system_->handles);  // which does not know what pulls at it
  follow_reference(state_);
}

/// Bodies far away or very fast leave nothing but rounding in their contact matrix.
void Simulation::require_sound(const ContactProblem& contacts) const {
  if (contacts.size() == 0) return;
  try {
    check(contacts, "contact problem");
  } catch (const std::invalid_argument& error) {
    throw SimulationBroke("simulation: at {} s: {}", state_.time, error.what());
  }
}

void Simulation::step(const ContactSolver& solver, const std::function<void(const Frame&)>& look) {
  const auto broke = [&] {
    return SimulationBroke("simulation: at {} s the bodies no longer move at finite speed",
                           state_.time);
  };
  if (!state_.q.allFinite() || !state_.u.allFinite()) throw broke();
  const Vector3d origin = kinematics_of(state_, Vector3d::Zero()).pose.front().p;
  const Kinematics here = kinematics_of(state_, origin);
  Frame frame{.number = number_,
              .state = state_,
              .kinematics = here,
              .points = {},
              .links = {},
              .contacts = {},
              .solution = {},
              .link_forces = {},
              .pulls = {},
              .before = last_};
  if (system_->pull) frame.pulls = system_->pull(state_.time, here);
  assemble(dynamics_, state_, here, frame.pulls, {});
  frame.points = contact_points(here);
  frame.points_found = static_cast<Index>(frame.points.size());
  pose_contacts(frame);
  require_sound(frame.contacts);
  solve(frame, solver);
  const VectorXd first_stage = dynamics_.disassemble(frame.link_forces).joints;
  if (look) look(frame);
  last_ = frame.points.empty() ? FrameSolutions{}
                               : accepted_solutions(frame.solution, frame.contacts.contacts);

  if (stepping_.scheme == Stepping::Scheme::paper) {
    move_by_runge_kutta(first_stage, origin, frame.link_forces);
  } else {
    state_.u += stepping_.dt * first_stage;
    state_.time += stepping_.dt;
    follow_reference(state_);  // before q moves: prescribed q is set, not integrated
    state_.q = moved(system_->model, state_.q, state_.u, stepping_.dt);
    follow_reference(state_);
  }
  ++number_;
}

ContactProblem Simulation::clean_contacts(const Frame& frame) const {
  const Kinematics& k = frame.kinematics;
  const auto problem = [&](const HandleDynamics& dynamics, const MatrixXd& A) {
    return contact_problem(frame.links, dynamics, A, stepping_.dt, stepping_.correction);
  };
  if (composite_)
    return problem(composite_->handle_dynamics(k, system_->gravity),
                   composite_->contact_factor(k, frame.links.J));
  return problem(dynamics_.handle_dynamics(), joint_space_.contact_factor(k, frame.links.J));
}

JointMotion Simulation::reference(double time) const {
  return system_->reference ? system_->reference(time) : JointMotion{};
}

void Simulation::follow_reference(State& state) const {
  const JointMotion motion = reference(state.time);
  Index next = 0;
  for (const Index i : system_->model.prescribed()) {
    state.q(system_->model.q_of(i)) = motion.angle(next);
    state.u(system_->model.u_of(i)) = motion.rate(next++);
  }
}

Kinematics Simulation::kinematics_of(const State& state, const Vector3d& origin) const {
  return kinematics(system_->model, state, origin, reference(state.time).acceleration);
}

std::vector<ContactPoint> Simulation::contact_points(const Kinematics& k) const {
  if (!system_->collide) return {};
  std::vector<ContactPoint> points = system_->collide(k);
  for (ContactPoint& point : points) {
    const Vector3d r = k.from_origin(point.position);
    point.normal_velocity = 0;
    for (const auto& [body, sign] : {std::pair(point.id.body1, 1.0), {point.id.body2, -1.0}})
      if (body > 0)
        point.normal_velocity += sign * point.normal.dot(velocity_at(r, k.velocity[body - 1]));
  }
  return points;
}

void Simulation::pose_contacts(Frame& frame) const {
  if (frame.points.empty()) return;
  if (stepping_.reduction.method != ReductionOptions::Method::none) {
    std::vector<ContactPoint> kept;
    for (const Index i : reduce_contacts(frame.points, stepping_.reduction))
      kept.push_back(frame.points[i]);
    frame.points = std::move(kept);
  }
  frame.links = link_contacts(frame.points, system_->mu, frame.kinematics, system_->handles);
  frame.contacts = stepping_.matrix == Stepping::Matrix::clean
                       ? clean_contacts(frame)
                       : contact_problem(frame.links, dynamics_.handle_dynamics(), stepping_.dt,
                                         stepping_.correction);
}

void Simulation::solve(Frame& frame, const ContactSolver& solver) const {
  frame.link_forces = VectorXd::Zero(6 * system_->handles.size());
  if (frame.points.empty()) return;
  frame.solution = solve_contacts(frame.contacts, stepping_.contact, solver, last_.frictional);
  frame.link_forces = frame.links.J.transpose() * frame.solution.forces;  // (12)
}

void Simulation::assemble(ForwardDynamics& dynamics, const State& state, const Kinematics& k,
                          const std::vector<PointForce>& pulls, std::vector<Vector6d> more) const {
  if (!pulls.empty()) more.resize(system_->model.size(), Vector6d::Zero());
  for (const PointForce& pull : pulls)
    more.at(pull.link) += force_at(k.from_origin(pull.position), pull.force);
  dynamics.assemble(k, damping_torques(system_->model, state.u), system_->gravity, more);
}

VectorXd Simulation::accelerations(const State& state, const Vector3d& origin,
                                   const VectorXd& forces) {
  const Kinematics k = kinematics_of(state, origin);
  std::vector<Vector6d> on_links(system_->model.size(), Vector6d::Zero());
  Index next = 0;
  for (const Index handle : system_->handles) on_links[handle] = forces.segment<6>(6 * next++);
  const auto pulls = system_->pull ? system_->pull(state.time, k) : std::vector<PointForce>();
  assemble(later_stages_, state, k, pulls, std::move(on_links));
  return later_stages_.disassemble(VectorXd(0)).joints;
}

void Simulation::move_by_runge_kutta(const VectorXd& first_stage, const Vector3d& origin,
                                     const VectorXd& forces) {
  const double dt = stepping_.dt;
  VectorXd u_rate = first_stage;
  VectorXd q_rate = coordinate_rates(system_->model, state_.q, state_.u);
  VectorXd u_sum = u_rate, q_sum = q_rate;
  for (const auto& [share, weight] : {std::pair(0.5, 2.0), {0.5, 2.0}, {1.0, 1.0}}) {
    State stage{state_.q + share * dt * q_rate, state_.u + share * dt * u_rate,
                state_.time + share * dt};
    normalise(system_->model, stage.q);
    follow_reference(stage);
    u_rate = accelerations(stage, origin, forces);
    q_rate = coordinate_rates(system_->model, stage.q, stage.u);
    u_sum += weight * u_rate;
    q_sum += weight * q_rate;
  }
  state_.u += dt / 6 * u_sum;
  state_.q += dt / 6 * q_sum;
  state_.time += dt;
  normalise(system_->model, state_.q);
  follow_reference(state_);
}

}  // namespace lcp
