#include "problems/rigid/simulation.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::solver_in_the_loop;
using Scheme = Stepping::Scheme;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Vector3d kEdges(0.2, 0.1, 0.1);

/// A box that stands on the floor.
System standing_box() {
  System system =
      cases::one_body(cases::free_box(2, kEdges),
                      cases::points_on_plane(cases::lower_corners(kEdges), Vector3d::UnitZ()), 0.5);
  system.start.q(2) = kEdges.z() / 2;
  return system;
}

/// A free link and an arm on a prescribed joint; nothing touches.
System waving_arm() {
  cases::Uniform uniform(71);
  Model model({cases::random_link(Link::world, JointKind::free, uniform),
               cases::random_link(0, JointKind::prescribed, uniform)});
  State start = state_at_zero(model);
  System system{.model = std::move(model), .start = std::move(start), .handles = {0}};
  system.reference = [](double t) {
    return JointMotion{VectorXd{{std::sin(3 * t)}}, VectorXd{{3 * std::cos(3 * t)}},
                       VectorXd{{-9 * std::sin(3 * t)}}};
  };
  return system;
}

TEST(Simulation, RefusesPrescribedJointsWithoutAReference) {
  System system = waving_arm();
  EXPECT_NO_THROW(Simulation(system, {}));
  system.reference = {};
  EXPECT_THROW(Simulation(system, {}), std::invalid_argument);
}

TEST(Simulation, RefusesStepsThatAreNoPositiveTime) {
  for (const double dt : {0.0, -1e-3, kNaN, kInfinity})
    EXPECT_THROW(Simulation(standing_box(), {.dt = dt}), std::invalid_argument) << dt;
}

TEST(Simulation, RefusesHandlesThatDoNotExistOrAreNotAscending) {
  for (const std::vector<Index>& handles :
       {std::vector<Index>{-1}, std::vector<Index>{1}, std::vector<Index>{0, 0}}) {
    System system = standing_box();
    system.handles = handles;
    EXPECT_THROW(Simulation(system, {}), std::invalid_argument);
  }
}

TEST(Simulation, RefusesAModelWithoutLinks) {
  const System system{.model = Model({}), .start = {}, .handles = {}};
  EXPECT_THROW(Simulation(system, {}), std::invalid_argument);
}

TEST(Simulation, RefusesAStartOfAnotherShapeOrThatIsNotFinite) {
  const auto start = [](auto spoil) {
    System system = standing_box();
    spoil(system.start);
    Simulation(system, {});
  };
  EXPECT_NO_THROW(start([](State&) {}));
  EXPECT_THROW(start([](State& s) { s.q.conservativeResize(6); }), std::invalid_argument);
  EXPECT_THROW(start([](State& s) { s.u.conservativeResize(7); }), std::invalid_argument);
  EXPECT_THROW(start([](State& s) { s.q(1) = kNaN; }), std::invalid_argument);
  EXPECT_THROW(start([](State& s) { s.u(5) = kInfinity; }), std::invalid_argument);
  EXPECT_THROW(start([](State& s) { s.time = kNaN; }), std::invalid_argument);
}

TEST(Simulation, RefusesContactsOfLinksThatAreNoHandles) {
  System system = standing_box();
  system.handles = {};
  Simulation simulation(system, {});
  EXPECT_THROW(simulation.step(solver_in_the_loop()), std::invalid_argument);
}

TEST(Simulation, SaysWhenBodiesNoLongerMoveAtFiniteSpeed) {
  System system = standing_box();
  system.start.u.head<3>() = Vector3d(1e200, 2e200, 3e200);
  system.start.time = 0.25;
  Simulation simulation(system, {});
  try {
    simulation.step(solver_in_the_loop());
    FAIL() << "the step was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("0.25 s"), std::string::npos) << error.what();
  }
}

TEST(Simulation, SaysSoWithoutAnyContactToo) {
  System system = waving_arm();
  system.start.u(5) = std::numeric_limits<double>::max();
  Simulation simulation(system, {.dt = 10});
  EXPECT_THROW(
      {
        for (int step = 0; step < 2; ++step) simulation.step(solver_in_the_loop());
      },
      SimulationBroke);
}

TEST(Simulation, ShowsEachFrameAsItIsBeforeItMovesTheBodies) {
  System system = standing_box();
  system.start.u(5) = -0.3;
  system.start.q(2) -= 1e-4;
  Simulation simulation(system, {});
  for (Index number = 0; number < 3; ++number) {
    const State before = simulation.state();
    bool seen = false;
    simulation.step(solver_in_the_loop(), [&](const Frame& frame) {
      seen = true;
      EXPECT_EQ(frame.number, number);
      EXPECT_EQ(frame.state.q, before.q);
      EXPECT_EQ(frame.state.u, before.u);
      ASSERT_EQ(frame.points.size(), 4u);
      EXPECT_EQ(frame.points_found, 4);
      const double sinking = before.u(5);
      for (Index i = 0; i < 4; ++i) {
        EXPECT_NEAR(frame.points[i].normal_velocity, sinking, 1e-12);
        EXPECT_NEAR(frame.links.depth(i), kEdges.z() / 2 - before.q(2), 1e-12);
        EXPECT_EQ(frame.contacts.contacts[i].mu, 0.5);
      }
      Vector3d sum = Vector3d::Zero();
      for (Index i = 0; i < 4; ++i) sum += frame.force(i);
      EXPECT_LE((frame.link_forces.tail<3>() - sum).norm(), 1e-9 * sum.norm());
    });
    EXPECT_TRUE(seen);
    EXPECT_NE(simulation.state().q, before.q);
    EXPECT_DOUBLE_EQ(simulation.state().time, before.time + 1e-3);
  }
}

TEST(Simulation, LeavesEmptyWhatAFrameWithoutContactsHasNot) {
  System system = standing_box();
  system.start.q(2) = 1;
  Simulation simulation(system, {});
  simulation.step(solver_in_the_loop(), [](const Frame& frame) {
    EXPECT_TRUE(frame.points.empty());
    EXPECT_EQ(frame.contacts.size(), 0);
    EXPECT_EQ(frame.link_forces, VectorXd::Zero(6).eval());
  });
  EXPECT_NEAR(simulation.state().u(5), -cases::kGravity * 1e-3, 1e-15);
}

TEST(Simulation, PrescribedJointsAreWhereTheReferenceSays) {
  for (const Scheme scheme : {Scheme::paper, Scheme::semi_implicit}) {
    const System system = waving_arm();
    Simulation simulation(system, {.scheme = scheme, .dt = 0.01});
    for (Index i = 0; i < 30; ++i) {
      const JointMotion expected = system.reference(simulation.state().time);
      EXPECT_EQ(simulation.state().q(7), expected.angle(0));
      EXPECT_EQ(simulation.state().u(6), expected.rate(0));
      simulation.step(solver_in_the_loop());
    }
  }
}

TEST(Simulation, AFreeFloatingSystemKeepsItsMomentumWhileAnArmIsWaved) {
  // Prescribed motion does work, but nothing pushes from outside. RK4: 1e-9 of the arm's momentum.
  System system = waving_arm();
  system.gravity.setZero();
  Simulation simulation(system, {.dt = 1e-3});
  const auto now = [&] {
    return momentum(system.model, kinematics(system.model, simulation.state()));
  };
  const Vector6d first = now();
  cases::run(simulation, 1, solver_in_the_loop());
  EXPECT_LE(cases::record("momentum", (now() - first).norm() / first.norm()), 1e-9);
}

TEST(Simulation, ReducesThePointsWhereAskedTo) {
  System system = standing_box();
  std::vector<Vector3d> points = cases::lower_corners(kEdges);
  points.push_back({0, 0, -kEdges.z() / 2});
  system.collide = cases::points_on_plane(points, Vector3d::UnitZ());
  Simulation simulation(system, {.reduction = {.method = ReductionOptions::Method::paper}});
  simulation.step(solver_in_the_loop(), [](const Frame& frame) {
    EXPECT_EQ(frame.points_found, 5);
    ASSERT_EQ(frame.points.size(), 4u);
    EXPECT_EQ(frame.contacts.size(), 4);
    for (const ContactPoint& point : frame.points) EXPECT_LT(point.id.feature, 4);
  });
}

/// Where a sliding, turning box is after 50 ms.
State after_a_while(Simulation& simulation) {
  cases::run(simulation, 0.05, solver_in_the_loop());
  return simulation.state();
}

System sliding_box() {
  System system = standing_box();
  system.start.u << 0, 0, 2, 0.5, 0.1, -0.2;
  return system;
}

TEST(Simulation, TakesTheSameStepsToTheBitEachTime) {
  Simulation first(sliding_box(), {}), second(sliding_box(), {});
  const State a = after_a_while(first), b = after_a_while(second);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.u, b.u);
}

TEST(Simulation, MayBeMovedToAnotherPlace) {
  Simulation stays(sliding_box(), {});
  auto original = std::make_unique<Simulation>(sliding_box(), Stepping{});
  Simulation moved_away(std::move(*original));
  original.reset();
  EXPECT_EQ(after_a_while(moved_away).q, after_a_while(stays).q);
}

TEST(Simulation, MovesAlikeOnCleanMatrices) {
  for (const JointKind joint : {JointKind::fixed, JointKind::ball}) {
    System system = sliding_box();
    cases::Uniform uniform(73);
    std::vector<Link> links = system.model.links();
    links.push_back(cases::random_link(0, joint, uniform));
    system.model = Model(links);
    system.start = state_at_zero(system.model);
    system.start.q.head<7>() = sliding_box().start.q;
    system.start.u.head<6>() = sliding_box().start.u;
    Simulation assembled(system, {}), clean(system, {.matrix = Stepping::Matrix::clean});
    EXPECT_EQ(clean.is_composite_body(), joint == JointKind::fixed);
    clean.step(solver_in_the_loop(), [&](const Frame& frame) {
      EXPECT_EQ(frame.contacts.W, clean.clean_contacts(frame).W);
    });
    assembled.step(solver_in_the_loop(), [&](const Frame& frame) {
      const ContactProblem twin = assembled.clean_contacts(frame);
      EXPECT_NE(frame.contacts.W, twin.W) << "is there nothing to compare?";
      EXPECT_LE(cases::relative_error(frame.contacts.W, twin.W), 1e-9);
      EXPECT_LE(cases::relative_error(frame.contacts.vbar, twin.vbar), 1e-9);
    });
    const State a = after_a_while(assembled), b = after_a_while(clean);
    EXPECT_LE((a.q - b.q).norm(), 1e-9);
    EXPECT_LE((a.u - b.u).norm(), 1e-9);
  }
}

TEST(Simulation, CleanMatricesComeWithWhatPullsAtTheBody) {
  System system = standing_box();
  system.pull = [](double, const Kinematics& k) {
    return std::vector<PointForce>{{0, k.pose[0].p, {0, 0, 30}}};
  };
  Simulation simulation(system, {.matrix = Stepping::Matrix::clean});
  EXPECT_FALSE(simulation.is_composite_body()) << "it does not know of pulls";
  Simulation assembled(system, {});
  VectorXd vbar;
  simulation.step(solver_in_the_loop(), [&](const Frame& frame) { vbar = frame.contacts.vbar; });
  assembled.step(solver_in_the_loop(),
                 [&](const Frame& frame) { EXPECT_EQ(frame.contacts.vbar, vbar); });
}

TEST(Simulation, WithoutAnAcceptedAnswerNothingHolds) {
  Simulation simulation(standing_box(), {});
  const ContactSolver refusing{solver_in_the_loop().solve,
                               [](const Problem&, const Result&) { return false; }};
  simulation.step(refusing);
  EXPECT_NEAR(simulation.state().u(5), -cases::kGravity * 1e-3, 1e-15);
}

}  // namespace
}  // namespace lcp
