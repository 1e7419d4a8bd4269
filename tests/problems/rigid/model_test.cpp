#include "problems/rigid/model.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/problems/rigid/random_models.h"

namespace lcp {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A free link that carries a hinge; `spoil` changes the second.
Model two_links(const std::function<void(Link&)>& spoil = {}) {
  cases::Uniform uniform(51);
  std::vector<Link> links{cases::random_link(Link::world, JointKind::free, uniform),
                          cases::random_link(0, JointKind::revolute, uniform)};
  links[1].name = "shin";
  if (spoil) spoil(links[1]);
  return Model(links);
}

/// What the refusal says; nothing where there is none.
std::string refusal(const std::function<void(Link&)>& spoil) {
  try {
    two_links(spoil);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Model, NamesTheLinkItRefuses) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_NE(refusal([](Link& link) { link.mass = 0; }).find("link 1 'shin'"), std::string::npos);
}

TEST(Model, RefusesParentsThatDoNotComeFirst) {
  for (const Index parent : {1, 2, 7, -2})
    EXPECT_NE(refusal([=](Link& link) { link.parent = parent; }).find("parent"), std::string::npos)
        << parent;
}

TEST(Model, RefusesAFreeLinkWithAParent) {
  EXPECT_NE(refusal([](Link& link) { link.joint = JointKind::free; }), "");
}

TEST(Model, RefusesMassesThatAreNotPositive) {
  for (const double mass : {0.0, -1.0, kNaN, kInfinity})
    EXPECT_NE(refusal([=](Link& link) { link.mass = mass; }).find("mass"), std::string::npos)
        << mass;
}

TEST(Model, RefusesInertiasThatAreNotSymmetricAndPositiveDefinite) {
  const auto refused = [](auto change) {
    return refusal([=](Link& link) { change(link.inertia); }).find("inertia") != std::string::npos;
  };
  EXPECT_TRUE(refused([](Matrix3d& I) { I(0, 1) += 1e-6 * I.norm(); }));
  EXPECT_TRUE(refused([](Matrix3d& I) { I.setZero(); }));
  EXPECT_TRUE(refused([](Matrix3d& I) { I = -I; }));
  EXPECT_TRUE(refused([](Matrix3d& I) { I = Vector3d(1, 1, -1e-3).asDiagonal(); }));
  EXPECT_TRUE(refused([](Matrix3d& I) { I(2, 2) = kNaN; }));
  EXPECT_TRUE(refused([](Matrix3d& I) { I(0, 0) = kNaN; }));
  EXPECT_TRUE(refused([](Matrix3d& I) { I(0, 1) = kNaN; }));
  EXPECT_TRUE(refused([](Matrix3d& I) { I(1, 1) = kInfinity; }));
}

TEST(Model, RefusesAxesThatAreNotOfUnitLength) {
  for (const double length : {0.0, 1 - 1e-6, 2.0, kNaN})
    EXPECT_NE(refusal([=](Link& link) { link.axis *= length; }).find("axis"), std::string::npos)
        << length;
}

TEST(Model, RefusesPlacesThatAreNotFinite) {
  EXPECT_NE(refusal([](Link& link) { link.centre.y() = kNaN; }), "");
  EXPECT_NE(refusal([](Link& link) { link.in_parent.p.x() = kInfinity; }), "");
  EXPECT_NE(refusal([](Link& link) { link.in_parent.R(2, 1) = kNaN; }), "");
}

TEST(Model, RefusesALinkFrameThatIsNotARotation) {
  EXPECT_NE(refusal([](Link& link) { link.in_parent.R *= 1.001; }), "");
  EXPECT_NE(refusal([](Link& link) { link.in_parent.R.col(0) *= -1; }), "");
}

TEST(Model, KnowsWhereEachLinksCoordinatesBegin) {
  cases::Uniform uniform(52);
  using enum JointKind;
  std::vector<Link> links;
  for (const JointKind joint : {free, fixed, revolute, ball, prescribed, free})
    links.push_back(cases::random_link(
        joint == free ? Link::world : static_cast<Index>(links.size()) - 1, joint, uniform));
  for (std::size_t i = 0; i < links.size(); ++i) links[i].mass = 1.0 + static_cast<double>(i);
  const Model model(links);
  EXPECT_EQ(model.coordinates(), 7 + 0 + 1 + 4 + 1 + 7);
  EXPECT_EQ(model.velocities(), 6 + 0 + 1 + 3 + 1 + 6);
  EXPECT_EQ(model.q_of(2), 7);
  EXPECT_EQ(model.q_of(3), 8);
  EXPECT_EQ(model.q_of(4), 12);
  EXPECT_EQ(model.q_of(5), 13);
  EXPECT_EQ(model.u_of(5), 11);
  EXPECT_EQ(model.prescribed(), std::vector<Index>{4});
  EXPECT_EQ(model.mass(), 1 + 2 + 3 + 4 + 5 + 6);
}

TEST(Model, FindsLinksByNameAndRefusesUnknownNames) {
  const Model model = two_links();
  EXPECT_EQ(model.find("shin"), 1);
  EXPECT_THROW(model.find("tail"), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
