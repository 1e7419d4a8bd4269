// A box on ever more points: single forces are no longer unique; what they do to the box is.

#include <gtest/gtest.h>

#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::kGravity;
using cases::record;

const Vector3d kEdges(0.3, 0.2, 0.1);
constexpr double kMass = 2, kMu = 0.5, kTimeStep = 1e-3;
/// Of a corner, when all friction turns the box: generous.
constexpr double kMostDeceleration = 10 * kMu * kGravity;

/// Points of a regular grid on the lower face: 4, 8, 16 or 64.
std::vector<Vector3d> grid(Index count) {
  const Index along_x = count == 4 ? 2 : count == 64 ? 8 : 4, along_y = count / along_x;
  const auto share = [](Index i, Index n) { return static_cast<double>(i) / double(n - 1) - 0.5; };
  std::vector<Vector3d> points;
  for (Index i = 0; i < along_x; ++i)
    for (Index j = 0; j < along_y; ++j)
      points.push_back(
          {kEdges.x() * share(i, along_x), kEdges.y() * share(j, along_y), -kEdges.z() / 2});
  return points;
}

Simulation box_on(Index points, const VectorXd& velocity, Index directions = 8) {
  System system =
      cases::one_body(cases::free_box(kMass, kEdges),
                      cases::points_on_plane(grid(points), Vector3d::UnitZ(), 1e-6), kMu);
  system.start.q(2) = kEdges.z() / 2;
  system.start.u = velocity;
  return Simulation(system, {.scheme = Stepping::Scheme::semi_implicit,
                             .contact = {.friction = {.directions = directions}}});
}

class BoxOnPoints : public testing::TestWithParam<Index> {};

TEST_P(BoxOnPoints, RestsWithNormalForcesThatCarryItsWeightAndMomentsThatBalance) {
  Simulation simulation = box_on(GetParam(), VectorXd::Zero(6));
  double weight_error = 0, moment = 0;
  const Index failures =
      cases::run(simulation, 0.02, cases::solver_in_the_loop(), [&](const Frame& frame) {
        ASSERT_EQ(frame.contacts.size(), GetParam());
        double normal = 0;
        for (Index i = 0; i < GetParam(); ++i) normal += frame.solution.forces(3 * i);
        weight_error = std::max(weight_error, std::abs(normal - kMass * kGravity));
        // The link's forces are taken at its frame, the centre of mass.
        moment = std::max(moment, frame.link_forces.head<3>().norm());
      });
  EXPECT_EQ(failures, 0);
  EXPECT_LE(record("sum of normals - m g, N", weight_error), 1e-9 * kMass * kGravity);
  EXPECT_LE(record("moment, N m", moment), 1e-9 * kMass * kGravity * kEdges.x());
  EXPECT_LE(record("speed", simulation.state().u.norm()), 1e-12);
}

TEST_P(BoxOnPoints, SlidesWithNormalForcesThatCarryItsWeight) {
  const VectorXd sliding{{0, 0, 0, 0.5, 0.2, 0}};
  Simulation simulation = box_on(GetParam(), sliding);
  const Index failures =
      cases::run(simulation, 0.02, cases::solver_in_the_loop(), [&](const Frame& frame) {
        double normal = 0;
        for (Index i = 0; i < GetParam(); ++i) normal += frame.solution.forces(3 * i);
        EXPECT_NEAR(normal, kMass * kGravity, 1e-9 * kMass * kGravity);
      });
  EXPECT_EQ(failures, 0);
}

/// What the forces of a frame do, however they are spread.
struct Effect {
  VectorXd velocity;  ///< v+ of all contacts: the rows w_a, and w_b - lambda.
  double power = 0;   ///< Of the contact forces at v+, W.
  Vector6d wrench;    ///< On the box.
  double residual = 0;
};

/// That of the first frame, by each solver that solves it, best-first first.
std::vector<Effect> effects(Index points, const VectorXd& velocity) {
  std::vector<Effect> found;
  for (const char* name : {"best-first", "lexicographic-revised"}) {
    Simulation simulation = box_on(points, velocity);
    simulation.step(cases::solver_in_the_loop(name), [&](const Frame& frame) {
      if (frame.solution.applied != Applied::frictional) return;
      const VectorXd& forces = frame.solution.forces;
      const VectorXd after = frame.contacts.W * forces + frame.contacts.vbar;
      found.push_back(
          {after, forces.dot(after), frame.link_forces,
           cases::natural_residual(frame.solution.frictional, frame.solution.with_friction.z)});
    });
  }
  record("solved by", static_cast<double>(found.size()));
  return found;
}

TEST_P(BoxOnPoints, SolversAgreeOnVelocitiesWrenchAndPowerAtRestAndSlidingStraight) {
  for (const VectorXd& velocity : {VectorXd(VectorXd::Zero(6)), VectorXd{{0, 0, 0, 0.5, 0.2, 0}}}) {
    const std::vector<Effect> found = effects(GetParam(), velocity);
    ASSERT_EQ(found.size(), 2u);
    const Effect &a = found[0], &b = found[1];
    EXPECT_LE(record("power", std::abs(a.power - b.power)), 1e-9 * (1 + std::abs(a.power)));
    EXPECT_LE(record("wrench", (a.wrench - b.wrench).norm()), 1e-9 * a.wrench.norm());
    EXPECT_LE(record("v+", (a.velocity - b.velocity).cwiseAbs().maxCoeff()), 1e-9);
  }
}

TEST_P(BoxOnPoints, WhereItTurnsAsItSlidesAnswersMayDifferInVelocityButEachIsOne) {
  // Friction against a turn depends on where the load stands, which four points leave open.
  const std::vector<Effect> found = effects(GetParam(), VectorXd{{0, 0, 2, 0.5, 0.2, 0}});
  ASSERT_GE(found.size(), 1u);
  for (const Effect& effect : found) {
    EXPECT_LE(effect.residual, 1e-9);
    EXPECT_NEAR(effect.wrench(5), kMass * kGravity, 1e-9 * kMass * kGravity);
    EXPECT_LT(effect.power, 0) << "friction takes energy";
    EXPECT_LE(record("v+", (effect.velocity - found[0].velocity).cwiseAbs().maxCoeff()),
              kTimeStep * kMostDeceleration);
  }
}

INSTANTIATE_TEST_SUITE_P(FourToSixtyFour, BoxOnPoints, testing::Values(4, 8, 16, 64),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace lcp
