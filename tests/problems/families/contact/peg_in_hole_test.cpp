#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/problems/families/contact/rigid_cases.h"

namespace lcp {
namespace {

using cases::first_of;
using Eigen::Vector3d;

/// The contacts of a hole about the z axis, from their places.
std::vector<PlacedContact> wall_contacts(const Eigen::Matrix3Xd& places) {
  std::vector<PlacedContact> contacts;
  for (const auto& place : places.colwise())
    contacts.push_back(
        {make_contact(Vector3d(-place.x(), -place.y(), 0), Vector3d::UnitZ(), 0.3, {1, 0, 0}),
         place});
  return contacts;
}

std::vector<Contact> frames(const Eigen::Matrix3Xd& places) {
  std::vector<Contact> contacts;
  for (const PlacedContact& placed : wall_contacts(places)) contacts.push_back(placed.contact);
  return contacts;
}

TEST(PegInHole, TouchesAllRoundAtThreeHeights) {
  const Instance instance = first_of("peg-in-hole");
  EXPECT_EQ(instance.problem.size(), 240);
  const FrictionBlocks& blocks = *instance.problem.friction;
  EXPECT_EQ(blocks.W, blocks.W.transpose().eval());
  EXPECT_EQ(cases::rank(blocks.W), 6);
  EXPECT_EQ(cases::rank(cases::normal_part(blocks)), 4);
  const Eigen::Matrix3Xd places = cases::positions(instance);
  for (Index i = 0; i < 24; ++i) {
    EXPECT_NEAR(places.col(i).head<2>().norm(), 0.01, 1e-15);
    EXPECT_NEAR(places(2, i), 0.02 * double(i / 8) - 0.02, 1e-15);
  }
}

TEST(PegInHole, DelassusMatrixIsWhatImpulsesDoToThePeg) {
  const Instance instance = first_of("peg-in-hole");
  const double across = 0.2 * (3 * 1e-4 + 16e-4) / 12, along = 0.2 * 1e-4 / 2;
  const RigidBody peg{.mass = 0.2, .inertia = {across, across, along}};
  const MatrixXd expected =
      cases::delassus_by_impulses({peg}, wall_contacts(cases::positions(instance)), 1e-3);
  EXPECT_LT((instance.problem.friction->W - expected).cwiseAbs().maxCoeff(),
            1e-12 * expected.cwiseAbs().maxCoeff());
}

TEST(PegInHole, FreeMotionIsInsertionFallAndPush) {
  // Axis 1 of every contact points up: it sees the axial motion alone.
  const VectorXd vbar =
      first_of("peg-in-hole:disturbance=0,push=0,press=3,speed=0.2").problem.friction->vbar;
  for (Index i = 0; i < 24; ++i) {
    EXPECT_NEAR(vbar(3 * i), 0, 1e-17);
    EXPECT_NEAR(vbar(3 * i + 1), -0.2 - 1e-3 * (9.81 + 3 / 0.2), 1e-15);
    EXPECT_NEAR(vbar(3 * i + 2), 0, 1e-17);
  }
}

TEST(PegInHole, FrictionlessForcesAreRadialAndBalanceThePush) {
  const Instance instance = first_of("peg-in-hole:mu=0,disturbance=0,push=7");
  EXPECT_EQ(instance.problem.size(), 24);
  const Eigen::Matrix3Xd places = cases::positions(instance);
  const VectorXd forces = cases::solved_forces(instance);
  const Eigen::Vector<double, 6> total =
      cases::total_wrench(frames(places), places, forces, Vector3d::Zero());
  EXPECT_NEAR(total.head<2>().norm(), 7, 1e-9);
  EXPECT_NEAR(total(2), 0, 1e-15);
  // The push acts at the upper end, 0.02 m above the centre; so must what balances it.
  const Vector3d moment = Vector3d(0, 0, 0.02).cross(total.head<3>());
  EXPECT_LT((total.tail<3>() - moment).norm(), 1e-10);
  for (Index i = 0; i < 24; ++i) EXPECT_EQ(forces.segment<2>(3 * i + 1).norm(), 0);
}

TEST(PegInHole, FrictionJamsAPegThatIsPushedAcrossHardEnough) {
  const auto axial_speed = [](const std::string& knobs) {
    const Instance instance =
        first_of("peg-in-hole:disturbance=0,speed=0,push=20,rings=2,per_ring=6," + knobs);
    const FrictionBlocks& blocks = *instance.problem.friction;
    return post_velocities(blocks, cases::solved_forces(instance))(1);
  };
  EXPECT_NEAR(axial_speed("mu=0"), -9.81e-3, 1e-12);
  EXPECT_NEAR(axial_speed("mu=1"), 0, 1e-9);
}

TEST(PegInHole, AtItsLargestTiltBothEndsTouchOnOppositeSides) {
  for (const Instance& instance :
       generate("peg-in-hole:clearance=1e-3,margin=1e-9", {.count = 5})) {
    const Eigen::Matrix3Xd places = cases::positions(instance);
    ASSERT_EQ(places.cols(), 2);
    EXPECT_NEAR(places.col(0).head<2>().norm(), 0.011, 1e-12);
    EXPECT_NEAR(places.col(1).head<2>().norm(), 0.011, 1e-12);
    EXPECT_LT((places.col(0) + places.col(1)).norm(), 1e-12);
  }
}

TEST(PegInHole, WithoutTiltOneSideTouchesAllAlong) {
  const MatrixXd places =
      cases::positions(first_of("peg-in-hole:clearance=1e-3,margin=1e-9,tilt=0,rings=5"));
  ASSERT_EQ(places.cols(), 5);
  for (Index i = 0; i < 5; ++i)
    EXPECT_LT((places.col(i).head<2>() - places.col(0).head<2>()).norm(), 1e-15);
}

TEST(PegInHole, TiltedContactsFollowThePegThatLeans) {
  // Two points on a peg of 0.01 m that leans by psi in a hole of 0.011 m: l sin psi + 2 r cos psi is
  // the hole's diameter, and the points are the diagonal of the peg's section apart.
  const Eigen::Matrix3Xd places =
      cases::positions(first_of("peg-in-hole:clearance=1e-3,margin=1e-9"));
  EXPECT_NEAR((places.col(0) - places.col(1)).norm(), std::hypot(0.04, 0.02), 1e-12);
}

TEST(PegInHole, DefaultInstancesAreSolved) {
  cases::expect_solved(generate("peg-in-hole", {.count = 4}));
}

TEST(PegInHole, IsTheSameTwiceAndDiffersBetweenSeeds) {
  cases::expect_seeds_to_matter("peg-in-hole:directions=2");
}

TEST(PegInHole, RefusesAHoleInWhichThePegTurnsOverInOneLine) {
  const std::string message = cases::refusal("peg-in-hole:clearance=0.02");
  EXPECT_TRUE(message.starts_with("peg-in-hole: clearance=0.02: the peg can turn over")) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_NE(cases::refusal("peg-in-hole:rings=1"), "");
}

}  // namespace
}  // namespace lcp
