#include <gtest/gtest.h>

#include <numbers>

#include "problems/decompositions.h"
#include "problems/scenes/humanoid/magnum.h"
#include "problems/scenes/scene.h"
#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::record;
using magnum::Side;

/// The robot as the reference says at a time, with the body where it is planned to start.
class Squat : public testing::Test {
 protected:
  SceneSetup setup_ = make_scene("squat").setup;
  const System& system_ = setup_.system;

  Kinematics planned(double time) const {
    State state = system_.start;
    const JointMotion motion = system_.reference(time);
    Index next = 0;
    for (const Index i : system_.model.prescribed()) {
      state.q(system_.model.q_of(i)) = motion.angle(next);
      state.u(system_.model.u_of(i)) = motion.rate(next++);
    }
    return kinematics(system_.model, state);
  }

  static Pose sole(const Kinematics& k, Side side) {
    return k.pose[magnum::foot(side)] * magnum::sole(side);
  }

  /// Height of the centre of mass over the left sole, along its normal.
  double height(double time) const {
    const Kinematics k = planned(time);
    const Pose ground = sole(k, Side::left);
    return ground.R.col(2).dot(centre_of_mass(system_.model, k) - ground.p);
  }
};

constexpr double kPeriod = 1;  // s

TEST_F(Squat, KneesBendPastSixtyDegreesAndReturn) {
  for (const char* name : {"left_knee_flexion", "right_knee_flexion"}) {
    const Index knee = system_.model.find(name);
    const auto bend = [&](double time) {  // degrees from the stretched leg
      const Kinematics k = planned(time);
      const Matrix3d turn =
          (k.pose[system_.model.link(knee).parent] * system_.model.link(knee).in_parent)
              .R.transpose() *
          k.pose[knee].R;
      return Eigen::AngleAxisd(turn).angle() * 180 / std::numbers::pi;
    };
    const double squatting = record(std::string(name) + " squatting", bend(kPeriod / 2));
    EXPECT_GE(squatting, 60);
    EXPECT_GE(squatting - record(std::string(name) + " standing", bend(0)), 30);
    EXPECT_NEAR(bend(kPeriod), bend(0), 1e-6);
  }
}

TEST_F(Squat, TheCentreOfMassGoesDownByFortyMillimetresAndReturns) {
  const double start = height(0), bottom = height(kPeriod / 2), end = height(kPeriod);
  EXPECT_GE(record("drop, mm", 1e3 * (start - bottom)), 40);
  EXPECT_NEAR(end, start, 1e-9);
  for (double t = 0; t <= kPeriod; t += 0.02) {
    EXPECT_GE(height(t), bottom - 1e-6) << t;
    EXPECT_LE(height(t), start + 1e-6) << t;
  }
}

TEST_F(Squat, TheCentreOfMassStaysOverTheSoles) {
  for (double t = 0; t <= kPeriod; t += 0.02) {
    const Kinematics k = planned(t);
    const Pose left = sole(k, Side::left), right = sole(k, Side::right);
    const Vector3d ahead =
        left.R.transpose() * (centre_of_mass(system_.model, k) - (left.p + right.p) / 2);
    EXPECT_GT(ahead.x(), magnum::sole_back) << t;
    EXPECT_LT(ahead.x(), magnum::sole_front) << t;
    EXPECT_NEAR(ahead.y(), 0, 0.01) << t;
  }
}

TEST_F(Squat, SolesStayInOnePlaneAndWhereTheyAreToOneAnother) {
  const Kinematics first = planned(0);
  const auto right_in_left = [](const Kinematics& k) {
    const Pose left = sole(k, Side::left), right = sole(k, Side::right);
    return Pose{left.R.transpose() * right.R, left.R.transpose() * (right.p - left.p)};
  };
  const Pose expected = right_in_left(first);
  EXPECT_NEAR(expected.p.z(), 0, 1e-9);
  EXPECT_LE((expected.R - Matrix3d::Identity()).norm(), 1e-9);
  double worst = 0;
  for (double t = 0; t <= kPeriod + 0.1; t += 0.0017) {  // between knots too
    const Pose now = right_in_left(planned(t));
    for (const Vector3d& point : magnum::sole_points(true))
      worst = std::max(worst, (now * point - expected * point).norm());
  }
  EXPECT_LE(record("apart, m", worst), 1e-6);
}

TEST_F(Squat, ItsContactMatrixHasRankSixAndItsNormalPartRankThree) {
  Simulation simulation(system_, setup_.stepping);
  Index frames = 0;
  cases::run(simulation, 0.03, cases::solver_in_the_loop(), [&](const Frame& frame) {
    if (frame.contacts.size() < 12 || frame.number % 5 != 0) return;
    ++frames;
    const ContactProblem clean = simulation.clean_contacts(frame);
    std::vector<Index> normals;
    for (Index i = 0; i < frame.contacts.size(); ++i) normals.push_back(3 * i);
    const auto rank = [](const MatrixXd& W) {
      const VectorXd values = small_singular_values(W);
      return (values.array() > 1e-9 * values(0)).count();
    };
    EXPECT_EQ(rank(frame.contacts.W), 6);
    EXPECT_EQ(rank(clean.W), 6);
    EXPECT_EQ(rank(frame.contacts.W(normals, normals)), 3);
    EXPECT_EQ(rank(clean.W(normals, normals)), 3);

    EXPECT_NE(frame.contacts.W, clean.W) << "assembled from its links it carries noise";
    EXPECT_LE(record("W", cases::relative_error(frame.contacts.W, clean.W)), 1e-9);
    EXPECT_LE(record("vbar", cases::relative_error(frame.contacts.vbar, clean.vbar)), 1e-9);
    // The noise stands where zeros belong, with either sign.
    const MatrixXd W = (frame.contacts.W + frame.contacts.W.transpose()) / 2;
    const VectorXd noisy = symmetric_eigen(W).values;
    const VectorXd smooth = symmetric_eigen(clean.W).values;
    record("least eigenvalue", noisy(0) / noisy.maxCoeff());
    record("least eigenvalue, composite", smooth(0) / smooth.maxCoeff());
    EXPECT_LT(noisy(0), smooth(0));
  });
  EXPECT_GE(frames, 3);
}

TEST_F(Squat, TheRobotStandsUpAgainOnItsFeetCarryingItsWeight) {
  // The first tenth of a second, in which it is nearly at rest: feet carry m g.
  setup_.stepping.scheme = Stepping::Scheme::paper;
  Simulation simulation(system_, setup_.stepping);
  const double weight = system_.model.mass() * cases::kGravity;
  double impulse = 0;
  const Index failures =
      cases::run(simulation, 0.06, cases::solver_in_the_loop(), [&](const Frame& frame) {
        double up = 0;
        for (std::size_t i = 0; i < frame.points.size(); ++i) up += frame.force(i).z();
        impulse += up * setup_.stepping.dt;
      });
  EXPECT_EQ(failures, 0);
  // What the feet gave beyond the weight is what the whole moves with.
  const Kinematics k = kinematics(system_.model, simulation.state());
  const double expected = weight * 0.06 + momentum(system_.model, k)(5);
  EXPECT_NEAR(record("impulse, N s", impulse), expected, 0.01 * expected);
  EXPECT_LE(simulation.state().u.head<3>().norm(), 0.2) << "it does not fall";
}

}  // namespace
}  // namespace lcp
