#pragma once

#include <functional>
#include <memory>

#include "problems/rigid/cubic_spline.h"
#include "problems/rigid/simulation.h"
#include "problems/scenes/humanoid/magnum.h"
#include "problems/scenes/smooth_step.h"
#include "problems/scenes/solid_bodies.h"

namespace lcp::magnum {

/// Where the robot should be at one moment, world axes. The body is upright.
struct Posture {
  Vector3d centre_of_mass = Vector3d::Zero();  ///< Of the whole robot, m.
  double yaw = 0;                              ///< Of the body, rad.
  Pose left_sole, right_sole;                  ///< Frames of the soles.
  double shoulder = 0;  ///< Flexion of both shoulders, rad, forward positive.
};

/// Joint angles over time that take the robot through postures.
struct MotionPlan {
  std::shared_ptr<const CubicSpline> joints;  ///< In the order of Model::prescribed().
  State start;                                ///< At time 0, at rest.

  JointMotion at(double time) const;
};

/// Finds the angles of the legs by Newton's method, and where the body stands by shifting it until
/// the centre of mass is where it should be, at knots `spacing` (s) apart until `duration`; a clamped
/// cubic spline joins them. Between knots the soles are where they should be up to the spline's error
/// (spacing^4). The motion should begin and end at rest.
///
/// The floating body is not prescribed: it follows from the contact forces in the simulation.
/// Throws std::runtime_error naming the time at which a posture is out of reach.
MotionPlan plan_motion(const Model& model, const std::function<Posture(double time)>& posture,
                       double duration, double spacing);

/// What a curve does at one end of a piece.
struct End {
  double value, rate, acceleration;
};

/// The quintic that goes from one end to the other in `duration` s, at `time` after its beginning.
double quintic(const End& from, const End& to, double duration, double time);

/// The robot on the floor z = 0, following a plan, with the corners of each sole to touch it, and the
/// middles of its edges where `mid_edges`; or with all 16 vertices of the triangles of each.
System on_the_floor(MotionPlan plan, bool mid_edges, Surfaces surfaces, double mu);

/// The robot's boxes and the floor, for pictures.
std::vector<collision::Shape> shapes_on_the_floor();

}  // namespace lcp::magnum
