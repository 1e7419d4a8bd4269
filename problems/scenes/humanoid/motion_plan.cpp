#include "problems/scenes/humanoid/motion_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lcp::magnum {

namespace {

constexpr double kReached = 1e-11;       // m and rad: a posture is met
constexpr int kMostIterations = 200;     // a few suffice; beyond, the posture is out of reach
constexpr double kLargestTurn = 0.3;     // rad, of a joint in one iteration
constexpr double kBentKnee = 0.6;        // rad, first guess: a stretched leg is singular
constexpr double kElbow = 0.5;           // rad, elbows stay bent
constexpr double kSoleThickness = 0.01;  // m, where soles are triangles,
constexpr Index kSoleDivisions = 3;      // of their faces each way

Vector3d rotation_vector(const Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

class PostureSolver {
 public:
  explicit PostureSolver(const Model& model) : model_(model), state_(state_at_zero(model)) {
    for (const Side side : {Side::left, Side::right}) {
      angle(leg(side)[0]) = kBentKnee / 2;
      angle(leg(side)[3]) = kBentKnee;
      angle(leg(side)[4]) = kBentKnee / 2;
    }
    angle(model.find("left_elbow_flexion")) = kElbow;
    angle(model.find("right_elbow_flexion")) = kElbow;
    state_.q(2) = 0.3;
  }

  /// Moves the state to a posture, from where it is.
  void solve(const Posture& wanted, double time) {
    for (const char* shoulder : {"left_shoulder_flexion", "right_shoulder_flexion"})
      angle(model_.find(shoulder)) = wanted.shoulder;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(wanted.yaw, Vector3d::UnitZ()));
    state_.q.segment<4>(3) = turn.coeffs();
    double off = 0;
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      const Kinematics k = kinematics(model_, state_);
      const Vector3d shift = wanted.centre_of_mass - centre_of_mass(model_, k);
      off = shift.norm();
      off = std::max(off, step_leg(Side::left, wanted.left_sole, k));
      off = std::max(off, step_leg(Side::right, wanted.right_sole, k));
      if (off <= kReached) return;
      state_.q.head<3>() += shift;
    }
    throw std::runtime_error(
        fmt::format("reference motion: at {} s the posture is out of reach by {:.2g}", time, off));
  }

  const State& state() const { return state_; }

 private:
  double& angle(Index link) { return state_.q(model_.q_of(link)); }

  /// One Newton step of a leg towards a place of its sole; how far it was (m or rad).
  double step_leg(Side side, const Pose& wanted, const Kinematics& k) {
    const auto joints = leg(side);
    const Pose now = k.pose[joints.back()] * sole(side);
    Vector6d error = stack(rotation_vector(wanted.R * now.R.transpose()), wanted.p - now.p);
    Matrix6d jacobian;
    for (Index j = 0; j < 6; ++j) {
      const Vector6d S = k.S[joints[j]].col(0);
      jacobian.col(j) = stack(S.head<3>(), velocity_at(k.from_origin(now.p), S));
    }
    Vector6d turn = jacobian.partialPivLu().solve(error);
    const double largest = turn.cwiseAbs().maxCoeff();
    if (largest > kLargestTurn) turn *= kLargestTurn / largest;
    for (Index j = 0; j < 6; ++j) angle(joints[j]) += turn(j);
    return std::max(error.head<3>().norm(), error.tail<3>().norm());
  }

  const Model& model_;
  State state_;
};

VectorXd joint_angles(const Model& model, const State& state) {
  VectorXd angles(model.prescribed().size());
  Index next = 0;
  for (const Index i : model.prescribed()) angles(next++) = state.q(model.q_of(i));
  return angles;
}

/// Those of the points of both soles that are not above the floor.
std::function<std::vector<ContactPoint>(const Kinematics&)> soles_touching(
    std::vector<Vector3d> points) {
  return [points = std::move(points)](const Kinematics& k) {
    std::vector<ContactPoint> found;
    for (const Side side : {Side::left, Side::right}) {
      const Pose at = k.pose[foot(side)] * sole(side);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3d position = at * points[i];
        if (position.z() <= 0)
          found.push_back({.position = position,
                           .normal = Vector3d::UnitZ(),
                           .depth = -position.z(),
                           .id = {body_of(foot(side)), 0, static_cast<Index>(i)}});
      }
    }
    return found;
  };
}

/// Soles as plates.
std::vector<collision::Shape> soles_and_floor() {
  const Vector3d edges(sole_front - sole_back, 2 * sole_half_width, kSoleThickness);
  const Pose plate{Matrix3d::Identity(), {(sole_front + sole_back) / 2, 0, kSoleThickness / 2}};
  std::vector<collision::Shape> shapes = {{collision::HalfSpace{}}};
  for (const Side side : {Side::left, Side::right})
    shapes.push_back({collision::Box{edges}, foot(side), sole(side) * plate});
  return shapes;
}

}  // namespace

JointMotion MotionPlan::at(double time) const {
  CubicSpline::Point point = joints->at(time);
  return {std::move(point.value), std::move(point.rate), std::move(point.acceleration)};
}

MotionPlan plan_motion(const Model& model, const std::function<Posture(double)>& posture,
                       double duration, double spacing) {
  const Index knots = static_cast<Index>(std::ceil(duration / spacing)) + 2;
  MatrixXd angles(model.prescribed().size(), knots);
  PostureSolver solver(model);
  MotionPlan plan;
  for (Index k = 0; k < knots; ++k) {
    const double time = spacing * static_cast<double>(k);
    solver.solve(posture(time), time);
    angles.col(k) = joint_angles(model, solver.state());
    if (k == 0) plan.start = solver.state();
  }
  plan.joints = std::make_shared<CubicSpline>(std::move(angles), spacing);
  return plan;
}

double quintic(const End& from, const End& to, double duration, double time) {
  const double T = duration, s = time / T;
  // As a cubic of the start's derivatives plus what the end adds, in powers of s from s^3.
  const double start = from.value + s * T * (from.rate + s * T * from.acceleration / 2);
  const double value = to.value - from.value - T * (from.rate + T * from.acceleration / 2);
  const double rate = T * (to.rate - from.rate - T * from.acceleration);
  const double bend = T * T * (to.acceleration - from.acceleration);
  const double third = 10 * value - 4 * rate + bend / 2;
  const double fourth = -15 * value + 7 * rate - bend;
  const double fifth = 6 * value - 3 * rate + bend / 2;
  return start + s * s * s * (third + s * (fourth + s * fifth));
}

System on_the_floor(MotionPlan plan, bool mid_edges, Surfaces surfaces, double mu) {
  System system{.model = model(), .start = plan.start, .handles = {}, .collide = {}};
  system.handles = {foot(Side::left), foot(Side::right)};
  system.reference = [plan](double time) { return plan.at(time); };
  system.mu = mu;
  system.collide = surfaces == Surfaces::exact
                       ? soles_touching(sole_points(mid_edges))
                       : touching(soles_and_floor(), {}, surfaces, kSoleDivisions);
  return system;
}

std::vector<collision::Shape> shapes_on_the_floor() {
  std::vector<collision::Shape> shapes = link_boxes();
  shapes.push_back({.geometry = collision::HalfSpace{}});
  return shapes;
}

}  // namespace lcp::magnum
