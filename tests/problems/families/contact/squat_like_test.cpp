#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/contact/friction_lcp.h"
#include "problems/registry.h"
#include "solvers/registry.h"
#include "tests/problems/contact/contact_cases.h"
#include "tests/problems/families/independent.h"

namespace lcp {
namespace {

Index rank(const MatrixXd& W) {
  const VectorXd values = independent::singular_values(W);
  return (values.array() > 1e-10 * values(0)).count();
}

int solved(const std::vector<Instance>& frames, const std::string& spelling) {
  const NamedSolver solver = make_solver(spelling);
  int count = 0;
  for (const Instance& frame : frames) {
    const Result result = solver.solver->solve(frame.problem);
    count +=
        result.claim == Claim::solved && cases::natural_residual(frame.problem, result.z) <= 1e-9;
  }
  return count;
}

TEST(SquatLike, HasSixteenCoplanarContactsOfOneRigidBody) {
  const std::vector<Instance> frames = generate("squat-like", {.count = 3});
  for (const Instance& frame : frames) {
    EXPECT_EQ(frame.problem.size(), 160);
    const MatrixXd& W = frame.problem.friction->W;
    EXPECT_EQ(W, W.transpose().eval());
    EXPECT_EQ(rank(W), 6);
  }
}

TEST(SquatLike, DelassusMatrixIsThatOfTheFreeRigidBody) {
  // Contact 0 is the front left corner of the left sole; at rest and without phase the centre of
  // mass stands 0.28 m above the middle. One step of 1 ms leans and sways it by A sin(2 pi f dt).
  const Instance frame = generate("squat-like:mass=7,dt=1e-3", {.count = 1}).front();
  const auto moved = [](double amplitude, double frequency) {
    return amplitude * std::sin(2 * std::numbers::pi * frequency * 1e-3);
  };
  const double drop = 0.06 * (1 - std::cos(2 * std::numbers::pi * 1e-3)) / 2;
  const Eigen::Vector3d r(moved(0.005, 0.6), moved(0.03, 0.8), 0.28 - drop);
  const Eigen::Vector3d arm = Eigen::Vector3d(0.06, 0.05 + 0.035, 0) - r;
  // A box of 0.15 x 0.20 x 0.50 m, 7 kg.
  const Eigen::Vector3d inertia = 7.0 / 12 * Eigen::Vector3d(0.29, 0.2725, 0.0625);
  const Eigen::Vector3d n = Eigen::Vector3d::UnitZ(), t1 = Eigen::Vector3d::UnitX();
  const auto response = [&](const Eigen::Vector3d& along, const Eigen::Vector3d& force) {
    const Eigen::Vector3d spin = arm.cross(force).cwiseQuotient(inertia);
    return 1e-3 * along.dot(force / 7 + spin.cross(arm));
  };
  const MatrixXd& W = frame.problem.friction->W;
  EXPECT_NEAR(W(0, 0), response(n, n), 1e-17);
  EXPECT_NEAR(W(1, 1), response(t1, t1), 1e-17);
  EXPECT_NEAR(W(1, 0), response(t1, n), 1e-17);
}

TEST(SquatLike, NormalForcesCarryTheWeightAndTheBob) {
  const double dt = 1e-3, mass = 7;
  const std::vector<Instance> frames = generate("squat-like:mass=7,dt=1e-3", {.count = 20});
  const auto bob_speed = [](double time) {
    const double rate = 2 * std::numbers::pi * 1.0;
    return -0.06 * rate * std::sin(rate * time) / 2;
  };
  const NamedSolver driver = make_solver("best-first");
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const VectorXd forces =
        contact_forces(*frames[k].problem.friction, driver.solver->solve(frames[k].problem).z);
    double total = 0;
    for (Index i = 0; i < 16; ++i) total += forces(3 * i);
    const double time = dt * static_cast<double>(k);
    const double acceleration = (bob_speed(time + dt) - bob_speed(time)) / dt;
    EXPECT_NEAR(total, mass * (9.81 + acceleration), 1e-9) << frames[k].name;
  }
}

TEST(SquatLike, EachFrameStartsFromTheOneBefore) {
  const std::vector<Instance> frames = generate("squat-like", {.count = 3});
  EXPECT_EQ(frames[0].provenance.at("start"), "feet at rest");
  for (std::size_t k = 1; k < frames.size(); ++k) {
    EXPECT_EQ(frames[k].provenance.at("predecessor"), frames[k - 1].name);
    EXPECT_TRUE(frames[k].provenance.at("driver").starts_with("best-first:"));
    EXPECT_EQ(frames[k].provenance.at("applied"), "frictional");
  }
  EXPECT_EQ(frames[2].active_contacts, 3);
}

TEST(SquatLike, IsTheSameTwiceAndDiffersBetweenSeeds) {
  const std::vector<Instance> once = generate("squat-like", {.count = 5, .seed = 2});
  const std::vector<Instance> again = generate("squat-like", {.count = 5, .seed = 2});
  const std::vector<Instance> other = generate("squat-like", {.count = 5, .seed = 3});
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_EQ(once[k].sha256, again[k].sha256);
    EXPECT_NE(once[k].sha256, other[k].sha256);
  }
}

TEST(SquatLike, SamplesTheEdgesOfTheSolesMoreDensely) {
  const Instance frame = generate("squat-like:contacts=64", {.count = 1}).front();
  EXPECT_EQ(frame.problem.size(), 640);
  EXPECT_EQ(frame.problem.friction->contacts(), 64);
}

TEST(SquatLike, WithoutFrictionHasNormalRowsOnly) {
  EXPECT_EQ(generate("squat-like:mu=0", {.count = 1}).front().problem.size(), 16);
}

TEST(SquatLike, BreaksLemkeButNotTheSearch) {
  const std::vector<Instance> frames = generate("squat-like", {.count = 20});
  EXPECT_LT(solved(frames, "lemke"), 10);
  EXPECT_EQ(solved(frames, "best-first"), 20);
}

TEST(SquatLike, RefusesWhatCannotBeStoodOn) {
  EXPECT_THROW(generate("squat-like:contacts=15", {.count = 1}), std::invalid_argument);
  EXPECT_THROW(generate("squat-like:contacts=130", {.count = 1}), std::invalid_argument);
  EXPECT_THROW(generate("squat-like:driver=nobody", {.count = 1}), std::invalid_argument);
  EXPECT_THROW(generate("squat-like:directions=7", {.count = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
