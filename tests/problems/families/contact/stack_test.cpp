#include <gtest/gtest.h>

#include "problems/features.h"
#include "tests/problems/families/contact/rigid_cases.h"

namespace lcp {
namespace {

using cases::first_of;
using Eigen::Vector3d;

TEST(Stack, HasFourContactsAtEachOfFourInterfaces) {
  const Instance instance = first_of("stack");
  EXPECT_EQ(instance.problem.size(), 160);
  EXPECT_EQ(instance.provenance.at("contact_ids"),
            "1-0-0 1-0-1 1-0-2 1-0-3 2-1-0 2-1-1 2-1-2 2-1-3 3-2-0 3-2-1 3-2-2 3-2-3 4-3-0 4-3-1 "
            "4-3-2 4-3-3");
  EXPECT_EQ(cases::rank(instance.problem.friction->W), 24);
}

TEST(Stack, OnlyInterfacesThatShareABoxInfluenceOneAnother) {
  const MatrixXd W = first_of("stack").problem.friction->W;
  EXPECT_EQ(W, W.transpose().eval());
  for (Index a = 0; a < 4; ++a) {
    for (Index b = 0; b < 4; ++b) {
      const auto block = W.block<12, 12>(12 * a, 12 * b);
      if (std::abs(a - b) > 1)
        EXPECT_TRUE(block.isZero(0)) << a << ", " << b;
      else
        EXPECT_GT(block.norm(), 1e-8) << a << ", " << b;
    }
  }
}

/// Boxes without shifts, whose geometry is known.
const char* const kStraight = "stack:offset=0,disturbance=0,bodies=3,mass_ratio=5";

TEST(Stack, DelassusMatrixIsWhatImpulsesDoToTheBoxes) {
  const Instance instance = first_of(kStraight);
  const Eigen::Matrix3Xd places = cases::positions(instance);
  std::vector<RigidBody> boxes;
  for (const double mass : {1.0, 5.0, 25.0})
    boxes.push_back({.mass = mass,
                     .inertia = box_inertia(mass, {0.2, 0.15, 0.1}),
                     .centre = {0, 0, 0.05 + 0.1 * double(boxes.size())}});
  std::vector<PlacedContact> contacts;
  for (Index i = 0; i < 12; ++i) {
    contacts.push_back(
        {make_contact(Vector3d::UnitZ(), Vector3d::UnitX(), 0.5, {i / 4 + 1, i / 4, 0}),
         places.col(i)});
    const Vector3d corner(0.1, 0.075, 0.1 * double(i / 4));
    EXPECT_LT((places.col(i).cwiseAbs() - corner).norm(), 1e-15) << i;
  }
  const MatrixXd expected = cases::delassus_by_impulses(boxes, contacts, 1e-3);
  EXPECT_LT((instance.problem.friction->W - expected).cwiseAbs().maxCoeff(),
            1e-13 * expected.cwiseAbs().maxCoeff());
}

TEST(Stack, FallsAsOneWithoutContactForces) {
  const VectorXd vbar = first_of(kStraight).problem.friction->vbar;
  for (Index i = 0; i < 12; ++i)
    EXPECT_LT((vbar.segment<3>(3 * i) - Vector3d(i < 4 ? -9.81e-3 : 0, 0, 0)).norm(), 1e-17) << i;
}

TEST(Stack, EachInterfaceCarriesTheWeightAboveIt) {
  const Instance instance = first_of("stack:disturbance=0,bodies=3,mass_ratio=5");
  const VectorXd forces = cases::solved_forces(instance);
  const double weights[] = {31 * 9.81, 30 * 9.81, 25 * 9.81};
  for (Index interface = 0; interface < 3; ++interface) {
    double total = 0;
    for (Index i = 0; i < 4; ++i) total += forces(12 * interface + 3 * i);
    EXPECT_NEAR(total, weights[interface], 1e-8) << interface;
  }
}

TEST(Stack, TheTopBoxRestsWithoutMoment) {
  // Without shifts its centre stands over the middle of its four corners.
  const Instance instance = first_of(kStraight);
  const VectorXd forces = cases::solved_forces(instance);
  const std::vector<Contact> upright(4, make_contact(Vector3d::UnitZ(), Vector3d::UnitX(), 0, {}));
  const Eigen::Vector<double, 6> total = cases::total_wrench(
      upright, cases::positions(instance).rightCols(4), forces.tail(12), {0, 0, 0.25});
  Eigen::Vector<double, 6> expected = Eigen::Vector<double, 6>::Zero();
  expected(2) = 25 * 9.81;
  EXPECT_LT((total - expected).norm(), 1e-8);
}

TEST(Stack, ConditionGrowsWithTheMassRatio) {
  const auto condition = [](const char* family) {
    return *features(first_of(family).problem).condition;
  };
  const double equal = condition("stack:mass_ratio=1"), ten = condition("stack"),
               thirty = condition("stack:mass_ratio=30");
  EXPECT_GT(ten, 100 * equal);
  EXPECT_GT(thirty, 10 * ten);
}

TEST(Stack, DefaultInstancesAreSolved) { cases::expect_solved(generate("stack", {.count = 5})); }

TEST(Stack, IsTheSameTwiceAndDiffersBetweenSeeds) { cases::expect_seeds_to_matter("stack"); }

TEST(Stack, RefusesBoxesThatMissOneAnotherInOneLine) {
  EXPECT_EQ(cases::refusal("stack:offset=0.08"),
            "stack: offset=0.08: neighbours may miss one another; expected less than half the "
            "shorter edge, 0.075");
  EXPECT_NE(cases::refusal("stack:per_interface=2"), "");
}

}  // namespace
}  // namespace lcp
