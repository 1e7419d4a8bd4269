#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/problems/families/contact/rigid_cases.h"

namespace lcp {
namespace {

using cases::first_of;
using Eigen::Vector3d;

/// The default box over the origin, at rest.
RigidBody default_box() {
  return {.mass = 1, .inertia = box_inertia(1, {0.2, 0.15, 0.1}), .centre = {0, 0, 0.05}};
}

std::vector<PlacedContact> placed_on_plane(const Eigen::Matrix3Xd& places) {
  std::vector<PlacedContact> contacts;
  for (const auto& place : places.colwise())
    contacts.push_back({make_contact(Vector3d::UnitZ(), Vector3d::UnitX(), 0.5, {1, 0, 0}), place});
  return contacts;
}

TEST(BodyOnPlane, HasSixteenCoplanarContactsOfRankSix) {
  const Instance instance = first_of("body-on-plane");
  EXPECT_EQ(instance.problem.size(), 160);
  const FrictionBlocks& blocks = *instance.problem.friction;
  EXPECT_EQ(blocks.W, blocks.W.transpose().eval());
  EXPECT_EQ(cases::rank(blocks.W), 6);
  EXPECT_EQ(cases::rank(cases::normal_part(blocks)), 3);
  EXPECT_LE(*instance.active_contacts, 3);
}

TEST(BodyOnPlane, DelassusMatrixIsWhatImpulsesDoToTheBox) {
  for (const char* family : {"body-on-plane:patch=disc", "body-on-plane:layout=duplicated"}) {
    const Instance instance = first_of(family);
    const MatrixXd expected = cases::delassus_by_impulses(
        {default_box()}, placed_on_plane(cases::positions(instance)), 1e-3);
    EXPECT_LT((instance.problem.friction->W - expected).cwiseAbs().maxCoeff(),
              1e-13 * expected.cwiseAbs().maxCoeff());
  }
}

TEST(BodyOnPlane, PointsSurroundTheFootOfTheCentreOfMassInsideTheirPatch) {
  for (const char* family :
       {"body-on-plane:contacts=4,mu=0,patch=disc", "body-on-plane:contacts=4,mu=0"}) {
    for (const Instance& instance : generate(family, {.count = 50})) {
      const Eigen::Matrix3Xd places = cases::positions(instance);
      std::vector<double> angles;
      for (const auto& place : places.colwise()) {
        angles.push_back(std::atan2(place.y(), place.x()));
        EXPECT_LE(std::abs(place.x()), 0.1);
        EXPECT_LE(std::abs(place.y()), 0.075);
        if (std::string(family).ends_with("disc")) {
          EXPECT_LE(place.norm(), 0.075);
        }
      }
      std::sort(angles.begin(), angles.end());
      for (std::size_t k = 0; k < 4; ++k) {
        const double next = k < 3 ? angles[k + 1] : angles[0] + 2 * std::numbers::pi;
        EXPECT_LT(next - angles[k], std::numbers::pi) << instance.name;
      }
    }
  }
}

TEST(BodyOnPlane, CollinearContactsLeaveTheTurnAboutTheirLineFree) {
  const Instance instance = first_of("body-on-plane:layout=collinear");
  const Eigen::Matrix3Xd places = cases::positions(instance);
  EXPECT_EQ(cases::rank(places), 1);  // the line runs through the origin
  EXPECT_EQ(cases::rank(instance.problem.friction->W), 5);
  EXPECT_EQ(cases::rank(cases::normal_part(*instance.problem.friction)), 2);
}

TEST(BodyOnPlane, DuplicatedContactsShareColumnsToTheBit) {
  const Instance instance = first_of("body-on-plane:layout=duplicated,contacts=20,copies=4");
  const FrictionBlocks& blocks = *instance.problem.friction;
  ASSERT_EQ(blocks.contacts(), 20);
  for (Index i = 0; i < 20; ++i) {
    Index alike = 0;
    for (Index j = 0; j < 20; ++j)
      alike += blocks.W.middleCols<3>(3 * i) == blocks.W.middleCols<3>(3 * j) &&
               blocks.vbar.segment<3>(3 * i) == blocks.vbar.segment<3>(3 * j);
    EXPECT_EQ(alike, 4) << i;
  }
  EXPECT_EQ(cases::rank(blocks.W), 6);
}

TEST(BodyOnPlane, NoiseLiftsTheNormalPartToFullRank) {
  const Instance noisy = first_of("body-on-plane:layout=noisy,noise=1e-3");
  EXPECT_EQ(cases::rank(noisy.problem.friction->W), 6);
  EXPECT_EQ(cases::rank(cases::normal_part(*noisy.problem.friction)), 6);
  const VectorXd heights = cases::positions(noisy).row(2);
  EXPECT_LE(heights.cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_GT(heights.cwiseAbs().maxCoeff(), 1e-4);
  const Instance clean = first_of("body-on-plane:layout=noisy,noise=0,normal_noise=0");
  EXPECT_EQ(cases::rank(cases::normal_part(*clean.problem.friction)), 3);
}

TEST(BodyOnPlane, FreeMotionIsTheFallAndTheSlide) {
  const VectorXd resting = first_of("body-on-plane:disturbance=0,dt=2e-3").problem.friction->vbar;
  const VectorXd sliding = first_of("body-on-plane:disturbance=0,dt=2e-3,motion=sliding,speed=0.7")
                               .problem.friction->vbar;
  for (Index i = 0; i < 16; ++i) {
    EXPECT_NEAR(resting(3 * i), -9.81 * 2e-3, 1e-16);
    EXPECT_EQ(resting.segment<2>(3 * i + 1).norm(), 0);
    EXPECT_NEAR(sliding(3 * i), -9.81 * 2e-3, 1e-16);
    EXPECT_NEAR(sliding.segment<2>(3 * i + 1).norm(), 0.7, 1e-15);
  }
}

TEST(BodyOnPlane, RestingContactsCarryTheWeightWithoutMoment) {
  for (const char* family :
       {"body-on-plane:disturbance=0", "body-on-plane:disturbance=0,patch=disc",
        "body-on-plane:disturbance=0,layout=collinear",
        "body-on-plane:disturbance=0,layout=duplicated", "body-on-plane:disturbance=0,contacts=4",
        "body-on-plane:disturbance=0,contacts=30,reduction=paper"}) {
    const Instance instance = first_of(family);
    const Eigen::Matrix3Xd places = cases::positions(instance);
    std::vector<Contact> contacts;
    for (const PlacedContact& placed : placed_on_plane(places)) contacts.push_back(placed.contact);
    const Eigen::Vector<double, 6> total =
        cases::total_wrench(contacts, places, cases::solved_forces(instance), default_box().centre);
    Eigen::Vector<double, 6> expected = Eigen::Vector<double, 6>::Zero();
    expected(2) = 9.81;
    EXPECT_LT((total - expected).norm(), 1e-9) << family;
  }
}

TEST(BodyOnPlane, SlidingFrictionOpposesTheMotionWithTheWholePolygon) {
  const Instance instance = first_of("body-on-plane:motion=sliding,disturbance=0,mu=0.4");
  const FrictionBlocks& blocks = *instance.problem.friction;
  const VectorXd forces = cases::solved_forces(instance);
  const VectorXd velocities = post_velocities(blocks, forces);
  const double apothem = std::cos(std::numbers::pi / 8);
  int pressing = 0;
  for (Index i = 0; i < 16; ++i) {
    const double bound = 0.4 * forces(3 * i);
    if (bound <= 1e-9) continue;
    ++pressing;
    const Eigen::Vector2d friction = forces.segment<2>(3 * i + 1);
    const Eigen::Vector2d slip = velocities.segment<2>(3 * i + 1);
    EXPECT_LE(friction.norm(), bound * (1 + 1e-9));
    EXPECT_GE(friction.norm(), bound * apothem * (1 - 1e-9));
    EXPECT_LE(friction.dot(slip.normalized()), -bound * apothem * (1 - 1e-9));
  }
  EXPECT_GE(pressing, 3);
}

TEST(BodyOnPlane, ReductionDropsContactsButNotTheMotionThatTheyAllow) {
  const std::string family = "body-on-plane:contacts=40,mu=0,disturbance=0";
  const Instance all = first_of(family), reduced = first_of(family + ",reduction=paper");
  EXPECT_EQ(all.problem.size(), 40);
  EXPECT_LT(reduced.problem.size(), 25);
  EXPECT_EQ(reduced.provenance.at("points_found"), "40");
  const auto after = [](const Instance& instance) {
    return post_velocities(*instance.problem.friction, cases::solved_forces(instance));
  };
  const VectorXd of_all = after(all), of_kept = after(reduced);
  const Eigen::Matrix3Xd everywhere = cases::positions(all), kept = cases::positions(reduced);
  for (Index i = 0; i < kept.cols(); ++i) {
    Index same = 0;
    while (everywhere.col(same) != kept.col(i)) ASSERT_LT(++same, 40);
    EXPECT_NEAR(of_kept(3 * i), of_all(3 * same), 1e-12);
  }
}

TEST(BodyOnPlane, SeparatingPointsSurviveAReductionUnlessTheyAreTreatedAsOthers) {
  const auto contacts = [](const std::string& separating) {
    return first_of("body-on-plane:contacts=64,mu=0,reduction=paper,separating=" + separating)
        .problem.size();
  };
  EXPECT_GT(contacts("keep"), contacts("as-others"));
  EXPECT_GT(contacts("as-others"), contacts("drop"));
}

TEST(BodyOnPlane, DeepestFourAreFour) {
  const Instance instance = first_of("body-on-plane:contacts=64,layout=noisy,reduction=deepest-4");
  EXPECT_EQ(instance.problem.size(), 40);
  // Of 64 heights in +-0.1 mm the four lowest are near the bottom.
  EXPECT_LT(cases::positions(instance).row(2).maxCoeff(), -0.7e-4);
}

TEST(BodyOnPlane, TakesUpToTwoHundredAndFiftySixContacts) {
  const Instance instance = first_of("body-on-plane:contacts=256,mu=0");
  EXPECT_EQ(instance.problem.size(), 256);
  EXPECT_EQ(instance.problem.friction->W.rows(), 768);
}

TEST(BodyOnPlane, MassSizeAndInertiaActOnTheDelassusMatrix) {
  const auto W = [](const char* family) { return first_of(family).problem.friction->W; };
  EXPECT_LT((W("body-on-plane:mass=2") - 0.5 * W("body-on-plane")).norm(),
            1e-15 * W("body-on-plane").norm());
  // What turns little falls like a particle: every normal response is dt / m.
  const MatrixXd stiff = W("body-on-plane:inertia=1000");
  EXPECT_NEAR(stiff(0, 0), 1e-3, 1e-2 * 1e-3);
  EXPECT_NEAR(stiff(0, 3), 1e-3, 1e-2 * 1e-3);
}

TEST(BodyOnPlane, DefaultInstancesAreSolved) {
  cases::expect_solved(generate("body-on-plane", {.count = 5}));
}

TEST(BodyOnPlane, IsTheSameTwiceAndDiffersBetweenSeeds) {
  cases::expect_seeds_to_matter("body-on-plane:directions=2");
}

TEST(BodyOnPlane, RefusesKnobsThatContradictOneAnotherInOneLine) {
  const std::string message = cases::refusal("body-on-plane:layout=duplicated,contacts=15");
  EXPECT_EQ(message, "body-on-plane: contacts=15: expected a multiple of copies=2");
  EXPECT_NE(cases::refusal("body-on-plane:contacts=2"), "");
  EXPECT_NE(cases::refusal("body-on-plane:contacts=257"), "");
  EXPECT_NE(cases::refusal("body-on-plane:directions=7"), "");
}

}  // namespace
}  // namespace lcp
