#include "problems/scenes/humanoid/magnum.h"

#include <gtest/gtest.h>

#include "problems/rigid/kinematics.h"

namespace lcp::magnum {
namespace {

/// The robot with all joints at zero, body upright at the origin.
Kinematics at_zero(const Model& robot) { return kinematics(robot, state_at_zero(robot)); }

Vector3d mirrored(const Vector3d& v) { return {v.x(), -v.y(), v.z()}; }

/// A link's partner on the other side; the body is its own.
Index partner(const Model& robot, Index link) {
  std::string name = robot.link(link).name;
  if (name.starts_with("left")) return robot.find("right" + name.substr(4));
  if (name.starts_with("right")) return robot.find("left" + name.substr(5));
  return link;
}

TEST(Magnum, WeighsWhatItsAuthorSaysOnTwentyPrescribedJoints) {
  const Model robot = model();
  EXPECT_NEAR(robot.mass(), 6.712, 5e-4);
  EXPECT_EQ(robot.size(), 21);
  EXPECT_EQ(robot.prescribed().size(), 20u);
  EXPECT_EQ(robot.velocities(), 26);
  EXPECT_EQ(robot.link(body).joint, JointKind::free);
}

TEST(Magnum, IsFiftyFiveCentimetresTall) {
  const Model robot = model();
  const Kinematics k = at_zero(robot);
  double low = 1, high = -1;
  for (const collision::Shape& box : link_boxes()) {
    const Vector3d half = std::get<collision::Box>(box.geometry).edges / 2;
    for (const double x : {-half.x(), half.x()})
      for (const double y : {-half.y(), half.y()})
        for (const double z : {-half.z(), half.z()}) {
          const double height = (k.pose[box.link] * box.in_link * Vector3d(x, y, z)).z();
          low = std::min(low, height);
          high = std::max(high, height);
        }
  }
  EXPECT_NEAR(high - low, 0.552, 0.01);
  EXPECT_NEAR((k.pose[foot(Side::left)] * sole(Side::left)).p.z(), low, 1e-3)
      << "it stands on its soles";
}

TEST(Magnum, StandsOnLevelSolesThatPointForwardAtZeroAngles) {
  const Model robot = model();
  const Kinematics k = at_zero(robot);
  for (const Side side : {Side::left, Side::right}) {
    const Pose at = k.pose[foot(side)] * sole(side);
    EXPECT_LE((at.R - Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_EQ(at.p.y() > 0, side == Side::left);
  }
  const Pose left = k.pose[foot(Side::left)] * sole(Side::left);
  const Pose right = k.pose[foot(Side::right)] * sole(Side::right);
  EXPECT_LE((mirrored(left.p) - right.p).norm(), 1e-12);
}

TEST(Magnum, IsTheSameOnTheLeftAndOnTheRight) {
  const Model robot = model();
  const Kinematics k = at_zero(robot);
  const Matrix3d mirror = Vector3d(1, -1, 1).asDiagonal();
  for (Index i = 1; i < robot.size(); ++i) {
    const Index j = partner(robot, i);
    ASSERT_NE(i, j) << robot.link(i).name;
    EXPECT_EQ(robot.link(i).mass, robot.link(j).mass) << robot.link(i).name;
    EXPECT_LE((mirrored(k.pose[i].p) - k.pose[j].p).norm(), 1e-9) << robot.link(i).name;
    EXPECT_LE(
        (mirrored(k.pose[i] * robot.link(i).centre) - k.pose[j] * robot.link(j).centre).norm(),
        1e-9)
        << robot.link(i).name;
    const auto in_world = [&](Index link) {
      return Matrix3d(k.pose[link].R * robot.link(link).inertia * k.pose[link].R.transpose());
    };
    EXPECT_LE((mirror * in_world(i) * mirror - in_world(j)).cwiseAbs().maxCoeff(),
              1e-9 * in_world(i).norm())
        << robot.link(i).name;
    // Angular velocities mirror as axial vectors; either sign of the axis is the same hinge.
    const Vector3d axis = k.S[i].col(0).head<3>(), other = k.S[j].col(0).head<3>();
    EXPECT_LE(std::min((mirrored(axis) - other).norm(), (mirrored(axis) + other).norm()), 1e-9)
        << robot.link(i).name;
  }
}

TEST(Magnum, HasLegsOfSixJointsThatEndInTheFeet) {
  const Model robot = model();
  for (const Side side : {Side::left, Side::right}) {
    const auto joints = leg(side);
    EXPECT_EQ(robot.link(joints[0]).parent, body);
    for (Index j = 1; j < 6; ++j) EXPECT_EQ(robot.link(joints[j]).parent, joints[j - 1]);
    EXPECT_EQ(robot.link(joints[0]).name.starts_with("left"), side == Side::left);
    EXPECT_EQ(foot(side), joints[5]);
  }
}

TEST(Magnum, LinksHaveInertiasThatSomeBodyCouldHave) {
  const Model robot = model();
  for (const Link& link : robot.links()) {
    const Vector3d moments = link.inertia.selfadjointView<Eigen::Lower>().eigenvalues();
    EXPECT_LT(moments(2), moments(0) + moments(1)) << link.name;
  }
}

TEST(Magnum, SolePointsAreCornersOneRoundAndTheMiddlesBetweenThem) {
  const std::vector<Vector3d> corners = sole_points(false), all = sole_points(true);
  ASSERT_EQ(corners.size(), 4u);
  ASSERT_EQ(all.size(), 8u);
  for (Index i = 0; i < 4; ++i) {
    EXPECT_EQ(all[2 * i], corners[i]);
    EXPECT_EQ(all[2 * i + 1], Vector3d((corners[i] + corners[(i + 1) % 4]) / 2));
    EXPECT_EQ(corners[i].z(), 0);
  }
  EXPECT_GT(corners[0].x(), corners[1].x());
  EXPECT_EQ(corners[0].y(), corners[1].y());
}

}  // namespace
}  // namespace lcp::magnum
