// squat: a small humanoid bends its knees and stands up again, on a flat floor.
//
// What      The experiment of the paper's Section V-A, Table I and Fig. 2: 20 prescribed joints
//           (high-gain feedback), so that the robot moves as one body on its contacts; rank(W) = 6.
// Robot     UT-mu2 "magnum" (problems/scenes/humanoid/magnum.h).
// Motion    Ours. The feet stand still and parallel; the centre of mass stays over the middle of the
//           soles and goes down by `drop` and up again along quintics in the first `period`
//           seconds; arms swing forward by `swing` meanwhile, which makes the robot lean on its toes and
//           heels in turn. 10 ms between knots of the joint splines.
// Contacts  Corners and, with points=16, the middles of the edges of both soles.
// Two forms of Table I: `squat` (16 points, unreduced) and `squat:reduction=paper`.
// Source    K. Yamane, Y. Nakamura (2008), V-A. The floor's friction is not published.

#include <cmath>
#include <numbers>

#include "problems/scenes/humanoid/motion_plan.h"
#include "problems/scenes/scene.h"

namespace lcp {
namespace {

using namespace magnum;

struct SquatKnobs {
  Index points = 16;
  double drop = 0.058;
  double period = 1;
  double swing = 0.6;
  Surfaces surfaces = Surfaces::exact;
  SteppingKnobs stepping;
};

OptionTable knob_table(SquatKnobs& knobs) {
  OptionTable own = {
      count("points", knobs.points, 8, 16, "of both soles: 8 corners, or 16 with mid-edges"),
      real("drop", knobs.drop, 0, 0.07, "by which the centre of mass goes down, m"),
      real("period", knobs.period, 0.2, 100, "of going down and up, s"),
      real("swing", knobs.swing, 0, 1.5, "of the arms to the front, rad"),
      choice("surfaces", knobs.surfaces, "points of the soles, or all vertices of their triangles"),
  };
  return with_stepping_knobs(std::move(own), knobs.stepping);
}

constexpr double kStandingHeight = 0.300;  // m, of the centre of mass: knees slightly bent
constexpr double kStance = 0.09;           // m, between the centres of the soles
constexpr double kKnotSpacing = 0.005;     // s

Posture posture_at(double time, const SquatKnobs& knobs) {
  const double share = time / knobs.period;
  const double down = smooth_step(2 * share) - smooth_step(2 * share - 1);
  Posture posture;
  posture.centre_of_mass = {0, 0, kStandingHeight - knobs.drop * down};
  const double middle = (sole_front + sole_back) / 2;
  posture.left_sole.p = {-middle, kStance / 2, 0};
  posture.right_sole.p = {-middle, -kStance / 2, 0};
  posture.shoulder = knobs.swing * down;
  return posture;
}

SceneSetup set_up(const SquatKnobs& knobs) {
  SceneSetup setup{
      .system = on_the_floor(
          plan_motion(
              model(), [&](double t) { return posture_at(t, knobs); }, knobs.period, kKnotSpacing),
          knobs.points == 16, knobs.surfaces, knobs.stepping.mu),
      .stepping = knobs.stepping.stepping(),
      .length = height,
      .duration = 1,
      .shapes = shapes_on_the_floor()};
  return setup;
}

const SceneRegistration squat{
    {"squat", "a humanoid of 20 prescribed joints bends its knees and stands up: rank(W) = 6",
     "Yamane and Nakamura 2008, V-A, Table I, Fig. 2"},
    SquatKnobs{},
    knob_table,
    set_up};

}  // namespace
}  // namespace lcp
