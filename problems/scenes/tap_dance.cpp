// tap-dance: a small humanoid hops on a flat floor, kicks with one foot in turn, and turns round.
//
// What      The experiment of the paper's Section V-B, Table II and Fig. 3: as `squat`, with frequent
//           collisions besides resting contact.
// Robot     UT-mu2 "magnum" (problems/scenes/humanoid/magnum.h).
// Motion    Ours. Every `period` seconds the robot pushes itself off at `push` m/s, draws up its legs and
//           lands flat on both feet; one foot, left and right in turn, is drawn up higher by `kick`. In
//           the air the feet turn ahead on a circle about the middle between them, and while they
//           stand the body turns after them, by `turn` in all. The centre of mass stays over that
//           middle; the arms swing as the legs stretch, which takes up the legs' angular momentum in
//           the air. All pieces are quintics, so that joints are twice continuously differentiable;
//           2 ms between knots of the joint splines.
// Balance   Nothing is fed back. Landing flat takes all speed from what is one rigid body. A foot that
//           struck alone at v would kick it into a roll at v / stance about the other sole's edge,
//           which nothing dampens: taps of single feet (tried, at 0.12 m/s) leave the robot rocking on
//           one or two corners most of the time, with 1.5 to 2.2 contacts on average.
// Contacts  Corners of both soles, and the middles of their edges with points=16.
// Source    K. Yamane, Y. Nakamura (2008), V-B; motion and friction are not published.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/scenes/humanoid/motion_plan.h"
#include "problems/scenes/scene.h"

namespace lcp {
namespace {

using namespace magnum;

struct TapDanceKnobs {
  Index points = 8;
  double push = 0.2;
  double kick = 0.004;
  double swing = 35;
  double period = 0.5;
  double turn = 70;
  double stance = 0.1;
  double height = 0.25;
  Surfaces surfaces = Surfaces::exact;
  SteppingKnobs stepping;
};

OptionTable knob_table(TapDanceKnobs& knobs) {
  OptionTable own = {
      count("points", knobs.points, 8, 16, "of both soles: 8 corners, or 16 with mid-edges"),
      real("push", knobs.push, 0, 1, "speed at which the robot pushes itself off, m/s"),
      real("kick", knobs.kick, 0, 0.03, "by which one foot is drawn up higher in the air, m"),
      real("swing", knobs.swing, -200, 200, "of the arms as the legs stretch, rad/m"),
      real("period", knobs.period, 0.3, 2, "from landing to landing, s"),
      real("turn", knobs.turn, -120, 120, "of the robot, degrees"),
      real("stance", knobs.stance, 0.08, 0.2, "between the middles of the soles, m"),
      real("height", knobs.height, 0.2, 0.27, "of the centre of mass, m"),
      choice("surfaces", knobs.surfaces, "points of the soles, or all vertices of their triangles"),
  };
  return with_stepping_knobs(std::move(own), knobs.stepping);
}

constexpr double kKnotSpacing = 0.002;  // s
constexpr double kDuration = 10;        // s
constexpr double kArms = 0.3;           // rad, of the shoulders at rest
constexpr double kStill = 0.2;          // s, at both ends
constexpr double kPushing = 0.1;        // s, from rest to take-off
constexpr double kDrawing = 0.055;      // s, in which the legs are drawn up again

class Dance {
 public:
  explicit Dance(const TapDanceKnobs& knobs)
      : knobs_(knobs), hops_(static_cast<int>((kDuration - 2 * kStill) / knobs.period)) {}

  /// Relative to the middle between the feet where they stand: how the robot moves in the world
  /// while it is in the air is the simulation's to find.
  Posture at(double time) const {
    const double beat = std::clamp((time - kStill) / knobs_.period, 0.0, double(hops_));
    const int hop = std::min(static_cast<int>(beat), hops_ - 1);
    const double within = (beat - hop) * knobs_.period;
    const double in_air = (within - kPushing) / kDrawing;  // share of the time of drawing up
    const double feet =
        yaw_before(hop) + smooth_step(in_air) * (yaw_before(hop + 1) - yaw_before(hop));
    const double standing =
        (within - kPushing - 2 * kDrawing) / (knobs_.period - kPushing - 2 * kDrawing);
    Posture posture;
    posture.centre_of_mass = {0, 0, knobs_.height + stretch(within)};
    posture.shoulder = kArms + knobs_.swing * stretch(within);
    posture.yaw = yaw_before(hop) + smooth_step(standing) * (yaw_before(hop + 1) - yaw_before(hop));
    const double kick = knobs_.kick * (smooth_step(2 * in_air) - smooth_step(2 * in_air - 1));
    posture.left_sole = sole_at(Side::left, feet, hop % 2 == 0 ? kick : 0);
    posture.right_sole = sole_at(Side::right, feet, hop % 2 == 1 ? kick : 0);
    return posture;
  }

 private:
  double yaw_before(int hop) const {
    return knobs_.turn * std::numbers::pi / 180 * smooth_step(hop / double(hops_));
  }

  /// By how much the legs are longer than at rest.
  double stretch(double time) const {
    const double rise = 0.45 * knobs_.push * kPushing;
    if (time < kPushing) return quintic({0, 0, 0}, {rise, knobs_.push, 0}, kPushing, time);
    if (time < kPushing + kDrawing)
      return quintic({rise, knobs_.push, 0}, {0, 0, 0}, kDrawing, time - kPushing);
    return 0;
  }

  Pose sole_at(Side side, double yaw, double height) const {
    Pose pose{Eigen::AngleAxisd(yaw, Vector3d::UnitZ()).toRotationMatrix(), Vector3d::Zero()};
    const double across = (side == Side::left ? 0.5 : -0.5) * knobs_.stance;
    pose.p = pose.R * Vector3d(-(sole_front + sole_back) / 2, across, 0);
    pose.p.z() = height;
    return pose;
  }

  TapDanceKnobs knobs_;
  int hops_;
};

SceneSetup set_up(const TapDanceKnobs& knobs) {
  const Dance dance(knobs);
  return {.system = on_the_floor(
              plan_motion(
                  model(), [&](double t) { return dance.at(t); }, kDuration, kKnotSpacing),
              knobs.points == 16, knobs.surfaces, knobs.stepping.mu),
          .stepping = knobs.stepping.stepping(),
          .length = magnum::height,
          .duration = kDuration,
          .shapes = shapes_on_the_floor()};
}

const SceneRegistration tap_dance{
    {"tap-dance", "the humanoid of squat hops, lands on both feet and turns: collisions",
     "Yamane and Nakamura 2008, V-B, Table II, Fig. 3"},
    TapDanceKnobs{.stepping = {.reduction = ReductionOptions::Method::paper}},
    knob_table,
    set_up};

}  // namespace
}  // namespace lcp
