// hoist, ring and net as they are set up, and their first steps.

#include <gtest/gtest.h>

#include <algorithm>

#include "problems/scenes/scene.h"
#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

Index joints(const Model& model, JointKind kind) {
  return std::count_if(model.links().begin(), model.links().end(),
                       [=](const Link& link) { return link.joint == kind; });
}

TEST(Hoist, IsAChainOf25BallJointsAboveRodAndFloor) {
  const SceneSetup setup = make_scene("hoist").setup;
  EXPECT_EQ(joints(setup.system.model, JointKind::ball), 25);
  EXPECT_EQ(joints(setup.system.model, JointKind::free), 1);
  const Kinematics k = kinematics(setup.system.model, setup.system.start);
  EXPECT_TRUE(setup.system.collide(k).empty());
  EXPECT_FALSE(make_scene("hoist:lift=0").setup.system.collide(k).size() > 1000);
  const Kinematics low =
      kinematics(setup.system.model, make_scene("hoist:lift=0").setup.system.start);
  EXPECT_GE(setup.system.collide(low).size(), 8u) << "the ends lie on the floor";
}

TEST(Hoist, GrowsWithItsKnobInProportion) {
  for (const Index links : {8, 25, 50, 100}) {
    const SceneSetup setup = make_scene(fmt::format("hoist:links={}", links)).setup;
    EXPECT_EQ(setup.system.model.size(), links);
    EXPECT_DOUBLE_EQ(setup.length, 0.1 * static_cast<double>(links));
    const auto& rod = std::get<collision::Cylinder>(setup.shapes[1].geometry);
    EXPECT_NEAR(rod.radius / setup.length, 0.09, 0.03);
    EXPECT_TRUE(setup.system.collide(kinematics(setup.system.model, setup.system.start)).empty());
  }
}

TEST(Hoist, IsPulledAwayFromTheRodAlongTheFloorAndNotBefore2s) {
  const SceneSetup setup = make_scene("hoist:lift=0").setup;
  const Kinematics k = kinematics(setup.system.model, setup.system.start);
  EXPECT_TRUE(setup.system.pull(1.9, k).empty());
  const std::vector<PointForce> held = setup.system.pull(3, k), pulled = setup.system.pull(8, k);
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].link, 25);
  EXPECT_NEAR(held[0].force.x(), 0, 1e-9);
  EXPECT_NEAR(pulled[0].force.x(), 500 * 0.12 * 2.6, 1e-6);
  EXPECT_NEAR(pulled[0].force.z(), 5, 15) << "only its speed, the toss, is held back";
}

TEST(Ring, LinksWiresOfFiveJointsWithFourPointsAtEachHook) {
  const SceneSetup setup = make_scene("ring:gap=0,tilt=0").setup;
  EXPECT_EQ(joints(setup.system.model, JointKind::ball), 7 * 5);
  EXPECT_EQ(joints(setup.system.model, JointKind::free), 7);
  State lowered = setup.system.start;
  std::vector<Index> count(8, 0);
  // Wires hang one below the other: each a little lower than the one above makes all hooks press.
  for (Index wire = 0; wire < 7; ++wire)
    lowered.q(setup.system.model.q_of(6 * wire) + 2) -= 1e-5 * static_cast<double>(wire + 1);
  const auto points = setup.system.collide(kinematics(setup.system.model, lowered));
  EXPECT_EQ(points.size(), 7u * 4);
  for (const ContactPoint& point : points) EXPECT_LT(point.depth, 2e-5);
}

TEST(Ring, WithoutAMultipleOfFourCornersIsRefused) {
  EXPECT_THROW(make_scene("ring:corners=6"), std::invalid_argument);
}

TEST(Net, IsFourStringsOfSixteenJointsClosedAtBothEnds) {
  const SceneSetup setup = make_scene("net").setup;
  EXPECT_EQ(joints(setup.system.model, JointKind::ball), 4 * 15);
  EXPECT_EQ(joints(setup.system.model, JointKind::free), 5);
  EXPECT_EQ(setup.system.model.loops().size(), 4u);
  const Kinematics k = kinematics(setup.system.model, setup.system.start);
  EXPECT_LE(largest_gap(k), 1e-14);
  EXPECT_TRUE(setup.system.collide(k).empty());
}

TEST(Net, WithAnOddNumberOfStringsIsRefused) {
  EXPECT_THROW(make_scene("net:strings=3"), std::invalid_argument);
}

class Chains : public testing::TestWithParam<const char*> {};

/// Twice the same, frame by frame, from nothing touching to the first contacts.
TEST_P(Chains, TouchInTheSameOrderEveryTime) {
  const SceneSetup setup = make_scene(GetParam()).setup;
  const auto first_contacts = [&] {
    Simulation simulation(setup.system, setup.stepping);
    std::string ids;
    for (int i = 0; i < 15; ++i)
      simulation.step(cases::solver_in_the_loop(), [&](const Frame& frame) {
        ids += spell_ids(frame.contacts.contacts) + "\n";
        for (const ContactPoint& point : frame.points) ids += fmt::format("{:a} ", point.depth);
      });
    return ids;
  };
  const std::string ids = first_contacts();
  EXPECT_GT(ids.size(), 200u) << "nothing touched";
  EXPECT_EQ(ids, first_contacts());
}

INSTANTIATE_TEST_SUITE_P(Scenes, Chains,
                         testing::Values("hoist:lift=0.0003,toss=0", "ring", "net:gap=0.001",
                                         "net:gap=0.001,surfaces=mesh",
                                         "hoist:lift=0.0003,toss=0,surfaces=mesh"),
                         [](const auto& each) {
                           std::string name;
                           for (const char c : std::string(each.param))
                             if (std::isalnum(c)) name += c;
                           return name;
                         });

}  // namespace
}  // namespace lcp
