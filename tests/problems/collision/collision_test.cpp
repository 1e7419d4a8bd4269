#include "problems/collision/collision.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "problems/rigid/simulation.h"
#include "tests/problems/collision/collision_cases.h"

namespace lcp {
namespace {

using namespace collision;

using cases::links_at;
using cases::Uniform;

bool same_bits(const std::vector<ContactPoint>& a, const std::vector<ContactPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ContactPoint& x, const ContactPoint& y) {
                      return x.position == y.position && x.normal == y.normal &&
                             x.depth == y.depth && x.id == y.id;
                    });
}

/// Two of each kind, crowded; the floor and a rod stand still.
struct Crowd {
  std::vector<Shape> shapes = {{HalfSpace{}, Link::world, {Matrix3d::Identity(), {0, 0, -0.05}}},
                               {Cylinder{0.03, 0.4}, Link::world,
                                cases::turned_about(Vector3d::UnitX(), 1.5, Vector3d::Zero())}};
  Kinematics kinematics;

  explicit Crowd(bool meshes) {
    Uniform uniform(12);
    const Ring ring = cases::round_ring(0.05, 0.008, 64);
    std::vector<Geometry> geometries;
    for (const char* kind : {"sphere", "capsule", "box", "cylinder"})
      for (int i = 0; i < 2; ++i) geometries.push_back(cases::random_geometry(kind, uniform));
    for (int i = 0; i < 2; ++i) {
      if (meshes) geometries.emplace_back(mesh_of(ring, 8));
      if (!meshes) geometries.emplace_back(ring);
    }
    for (std::size_t i = 0; i < geometries.size(); ++i) {
      shapes.push_back({geometries[i], static_cast<Index>(i)});
      kinematics.pose.push_back(
          {cases::random_turn(uniform).toRotationMatrix(), 0.06 * cases::random_vector(uniform)});
    }
  }
};

class Worlds : public testing::TestWithParam<bool> {};

TEST_P(Worlds, GiveTheSameBitsTwiceAndFromCopies) {
  const Crowd crowd(GetParam());
  World world(crowd.shapes);
  const auto points = world.contacts(crowd.kinematics);
  EXPECT_GT(points.size(), 20);
  World copy = world;
  EXPECT_TRUE(same_bits(points, copy.contacts(crowd.kinematics)));
  // Elsewhere in between, so that nothing is left of the last frame.
  Kinematics elsewhere = crowd.kinematics;
  for (Pose& pose : elsewhere.pose) pose.p *= 2;
  EXPECT_FALSE(same_bits(points, world.contacts(elsewhere)));
  EXPECT_TRUE(same_bits(points, world.contacts(crowd.kinematics)));
}

TEST_P(Worlds, GiveTheSamePointsWhateverTheOrderOfTheShapes) {
  const Crowd crowd(GetParam());
  World world(crowd.shapes);
  const auto points = world.contacts(crowd.kinematics);
  auto shapes = crowd.shapes;
  for (int turn = 0; turn < 5; ++turn) {
    std::rotate(shapes.begin(), shapes.begin() + 3, shapes.end());
    if (turn % 2) std::swap(shapes[1], shapes[4]);
    World permuted(shapes);
    auto again = permuted.contacts(crowd.kinematics);
    ASSERT_EQ(again.size(), points.size());
    // Two shapes stand in the world: which of them comes first, their features say.
    for (std::size_t i = 0; i < points.size(); ++i) {
      again[i].id.feature %= features_per_pair;
      EXPECT_EQ(again[i].id.body1, points[i].id.body1);
      EXPECT_EQ(again[i].id.body2, points[i].id.body2);
      EXPECT_EQ(again[i].id.feature, points[i].id.feature % features_per_pair);
      EXPECT_EQ(again[i].position, points[i].position);
      EXPECT_EQ(again[i].normal, points[i].normal);
      EXPECT_EQ(again[i].depth, points[i].depth);
    }
  }
}

TEST_P(Worlds, OrderPointsByBodiesThenDepthThenPlace) {
  const Crowd crowd(GetParam());
  World world(crowd.shapes);
  const auto points = world.contacts(crowd.kinematics);
  const std::vector<Index> order =
      reduce_contacts(points, {.method = ReductionOptions::Method::none});
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(order[i], static_cast<Index>(i));
    EXPECT_GT(points[i].id.body1, points[i].id.body2);
    EXPECT_GE(points[i].depth, 0);
  }
}

TEST_P(Worlds, GiveTheSameInOtherThreads) {
  const Crowd crowd(GetParam());
  World world(crowd.shapes);
  const auto points = world.contacts(crowd.kinematics);
  std::vector<World> copies(2, world);
  std::array<bool, 2> same = {false, false};
  std::vector<std::thread> threads;
  for (int i : {0, 1})
    threads.emplace_back([&, i] {
      same[i] = true;
      for (int k = 0; k < 20; ++k)
        same[i] = same[i] && same_bits(points, copies[i].contacts(crowd.kinematics));
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(same[0] && same[1]);
}

INSTANTIATE_TEST_SUITE_P(Of, Worlds, testing::Bool(), [](const auto& kinds) {
  return std::string(kinds.param ? "solids_and_meshes" : "solids_and_rings");
});

/// Spheres of 1 cm, one on each link, all in one place; two more in the world.
std::vector<Shape> spheres(Index links) {
  std::vector<Shape> shapes = {{Sphere{0.01}}, {Sphere{0.01}}};
  for (Index i = 0; i < links; ++i) shapes.push_back({Sphere{0.01}, i});
  return shapes;
}

Kinematics all_near_the_origin(Index links) {
  Kinematics kinematics;
  for (Index i = 0; i < links; ++i)
    kinematics.pose.push_back({Matrix3d::Identity(), {0.001 * static_cast<double>(i + 1), 0, 0}});
  return kinematics;
}

std::set<LinkPair> pairs_of(const std::vector<ContactPoint>& points) {
  std::set<LinkPair> pairs;
  for (const ContactPoint& point : points) pairs.emplace(point.id.body2, point.id.body1);
  return pairs;
}

TEST(World, CollidesAllDifferentLinksButNotWhatStandsStill) {
  World world(spheres(3));
  const auto points = world.contacts(all_near_the_origin(3));
  EXPECT_EQ(points.size(), 3 * 2 + 3);
  EXPECT_EQ(pairs_of(points), (std::set<LinkPair>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
}

TEST(World, LeavesOutShapesOfOneLink) {
  World world({{Sphere{0.01}, 0}, {Sphere{0.01}, 0}, {Capsule{0.01, 0.02}, 0}});
  EXPECT_TRUE(world.contacts(all_near_the_origin(1)).empty());
}

TEST(World, LeavesOutExcludedPairsInEitherOrder) {
  World world(spheres(3), {{2, 1}, {Link::world, 0}, {1, Link::world}});
  EXPECT_EQ(pairs_of(world.contacts(all_near_the_origin(3))),
            (std::set<LinkPair>{{0, 3}, {1, 2}, {1, 3}}));
}

TEST(World, KnowsNeighboursOfAModel) {
  Uniform uniform(3);
  const Model model =
      cases::random_model({.links = 3, .joints = {JointKind::ball}, .chain = true}, uniform);
  EXPECT_EQ(neighbours(model), (std::vector<LinkPair>{{Link::world, 0}, {0, 1}, {1, 2}}));
}

TEST(World, TellsFeaturesOfSeveralShapesOnOneLinkApart) {
  World world({{HalfSpace{}}, {Box{{0.1, 0.1, 0.1}}, 0}, {Box{{0.2, 0.05, 0.1}}, 0}});
  const auto points = world.contacts(links_at({{Matrix3d::Identity(), {0, 0, 0.049}}}));
  std::set<Index> features;
  for (const ContactPoint& point : points) features.insert(point.id.feature);
  EXPECT_EQ(points.size(), 8);
  EXPECT_EQ(features.size(), 8);
}

TEST(World, PutsShapesWhereTheirFramesAreInTheirLinks) {
  Uniform uniform(8);
  const Pose link = cases::random_pose(uniform), in_link = cases::random_pose(uniform);
  const Pose whole = link * in_link;
  const Vector3d up = whole.R.col(2);
  World world({{Capsule{0.01, 0.1}, 0, in_link},
               {Sphere{0.02}, Link::world, {Matrix3d::Identity(), whole.p + 0.0795 * up}}});
  const auto points = world.contacts(links_at({link}));
  ASSERT_EQ(points.size(), 1);
  EXPECT_NEAR(points[0].depth, 5e-4, 1e-12);
  EXPECT_LE((points[0].normal + up).norm(), 1e-9);
}

TEST(World, ServesASystemAndItsCopies) {
  const Crowd crowd(false);
  World world(crowd.shapes);
  decltype(System::collide) collide = [world](const Kinematics& k) mutable {
    return world.contacts(k);
  };
  const auto copy = collide;
  EXPECT_TRUE(same_bits(copy(crowd.kinematics), world.contacts(crowd.kinematics)));
}

TEST(World, RefusesPairsWithoutARuleUnlessExcluded) {
  const Ring ring = cases::round_ring(0.02, 0.001, 8);
  const std::vector<Shape> shapes = {{ring, 0}, {mesh_of(ring, 4), 1}};
  EXPECT_THROW(World{shapes}, std::invalid_argument);
  EXPECT_NO_THROW(World(shapes, {{0, 1}}));
  EXPECT_THROW(World({{HalfSpace{}}, {HalfSpace{}, 0}}), std::invalid_argument);
  EXPECT_NO_THROW(World({{HalfSpace{}}, {HalfSpace{}}}));
}

TEST(World, RefusesLinksThatDoNotExist) {
  World world(spheres(2));
  EXPECT_THROW(world.contacts(all_near_the_origin(1)), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
