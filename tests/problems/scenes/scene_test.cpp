#include "problems/scenes/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "problems/scenes/humanoid/magnum.h"

namespace lcp {
namespace {

constexpr double degree = std::numbers::pi / 180;

Kinematics at(const System& system, double time) {
  State state = system.start;
  state.time = time;
  const JointMotion motion = system.reference(time);
  Index next = 0;
  for (const Index i : system.model.prescribed()) {
    state.q(system.model.q_of(i)) = motion.angle(next);
    state.u(system.model.u_of(i)) = motion.rate(next++);
  }
  return kinematics(system.model, state);
}

TEST(Scenes, AreSortedAndHaveOptionsWithDocs) {
  ASSERT_GE(scenes().size(), 2u);
  for (std::size_t i = 0; i < scenes().size(); ++i) {
    if (i > 0) {
      EXPECT_LT(scenes()[i - 1].info.name, scenes()[i].info.name);
    }
    EXPECT_FALSE(scenes()[i].info.summary.empty());
    EXPECT_FALSE(scenes()[i].info.source.empty());
    for (const Option& option : scenes()[i].make()->options()) EXPECT_FALSE(option.doc.empty());
  }
}

TEST(Scenes, SpellTheKnobsThatDifferFromTheirDefaults) {
  EXPECT_EQ(make_scene("squat").spelling, "squat");
  EXPECT_EQ(make_scene("squat:points=16").spelling, "squat");
  EXPECT_EQ(make_scene("squat:reduction=paper,points=8").spelling,
            "squat:points=8,reduction=paper");
}

TEST(Scenes, RefuseUnknownNamesAndKnobs) {
  EXPECT_THROW(make_scene("sqat"), std::invalid_argument);
  EXPECT_THROW(make_scene("squat:pints=8"), std::invalid_argument);
  EXPECT_THROW(make_scene("squat:drop=1"), std::invalid_argument) << "out of range";
}

/// Whether the detector finds `link` touching anything when it is put where another link is, or
/// lowered by 5 cm.
bool can_touch(const System& system, Index link) {
  const Kinematics start = kinematics(system.model, system.start);
  std::vector<Pose> places = start.pose;
  places[link].p.z() -= 0.05;
  for (const Pose& place : places) {
    Kinematics moved = start;
    moved.pose[link] = place;
    for (const ContactPoint& point : system.collide(moved))
      if (point.id.body1 == body_of(link) || point.id.body2 == body_of(link)) return true;
  }
  return false;
}

TEST(Scenes, HaveHandlesOnThoseLinksThatCanTouchSomethingAndOnNoOthers) {
  for (const SceneRow& row : scenes()) {
    const System system = make_scene(row.info.name).setup.system;
    for (Index link = 0; link < system.model.size(); ++link) {
      const bool is_handle = std::binary_search(system.handles.begin(), system.handles.end(), link);
      EXPECT_EQ(is_handle, can_touch(system, link))
          << row.info.name << ": " << system.model.link(link).name;
    }
  }
}

TEST(Squat, BendsTheKneesByMoreThan60Degrees) {
  const System system = make_scene("squat").setup.system;
  for (const magnum::Side side : {magnum::Side::left, magnum::Side::right}) {
    const Index knee = magnum::leg(side)[3];
    Index place = 0;
    while (system.model.prescribed()[place] != knee) ++place;
    EXPECT_GE(std::abs(system.reference(0.5).angle(place) - system.reference(0).angle(place)),
              60 * degree);
    EXPECT_NEAR(system.reference(1).angle(place), system.reference(0).angle(place), 1e-9);
  }
}

TEST(Squat, KeepsTheSolesInOnePlane) {
  const System system = make_scene("squat").setup.system;
  for (double time = 0; time <= 1; time += 0.013) {
    const Kinematics k = at(system, time);
    const Pose left = k.pose[magnum::foot(magnum::Side::left)] * magnum::sole(magnum::Side::left);
    const Pose right =
        k.pose[magnum::foot(magnum::Side::right)] * magnum::sole(magnum::Side::right);
    EXPECT_LT(left.R.col(2).cross(right.R.col(2)).norm(), 1e-6);
    EXPECT_LT(std::abs(left.R.col(2).dot(left.p - right.p)), 1e-6);
  }
}

/// Its motion takes long to plan.
const System& tap_dance() {
  static const System system = make_scene("tap-dance").setup.system;
  return system;
}

TEST(TapDance, TheReferenceStandsStillAtBothEnds) {
  const System& system = tap_dance();
  for (const double time : {0.0, 10.0}) {
    EXPECT_LT(system.reference(time).rate.norm(), 1e-9);
    EXPECT_LT(system.reference(time).acceleration.norm(), 1e-6);
  }
}

TEST(TapDance, TheReferenceIsTwiceContinuouslyDifferentiable) {
  const System& system = tap_dance();
  const double h = 1e-6;
  for (double time = 0.2; time < 1.4; time += 0.002) {  // at the splines' knots
    const JointMotion before = system.reference(time - h), after = system.reference(time + h);
    // Over 2 h rates change by 2 h times the acceleration, and accelerations by 2 h times at most
    // 1e5 rad/s^3; a jump would be as large as they are themselves.
    const double acceleration = before.acceleration.cwiseAbs().maxCoeff();
    EXPECT_LT((after.rate - before.rate).cwiseAbs().maxCoeff(), 3 * h * (acceleration + 1));
    EXPECT_LT((after.acceleration - before.acceleration).cwiseAbs().maxCoeff(), 1);
  }
}

TEST(TapDance, LimitsOfTheJointsAreKept) {
  const System& system = tap_dance();
  for (double time = 0; time < 10; time += 0.01)
    EXPECT_LT(system.reference(time).angle.cwiseAbs().maxCoeff(), 110 * degree);
}

}  // namespace
}  // namespace lcp
