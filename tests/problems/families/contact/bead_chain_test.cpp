#include "problems/families/contact/bead_chain.h"

#include <gtest/gtest.h>

#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

using Eigen::Vector3d;

/// Six links bent over a rod of 0.1 m, heavy at one end, twisted out of the plane, and moving.
BeadChain bent_chain() {
  cases::Uniform uniform(21);
  BeadChain chain;
  chain.link_length = 0.05;
  chain.bead_radius = 0.005;
  chain.bead_offset = 0.02;
  chain.axial_share = 0.1;
  chain.masses = VectorXd{{0.5, 0.1, 0.1, 0.1, 0.1, 0.2}};
  chain.head = Vector3d(-0.11, 0.01, 0.05);
  chain.axes.resize(3, 6);
  for (Index i = 0; i < 6; ++i)
    chain.axes.col(i) =
        Vector3d(std::sin(0.4 + 0.3 * double(i)), 0.1 * uniform(), std::cos(0.4 + 0.3 * double(i)))
            .normalized();
  chain.nu = VectorXd::NullaryExpr(36, [&uniform] { return uniform(); });
  chain.nu = joined_velocity(chain);
  return chain;
}

/// A margin wide enough that every bead of bent_chain() counts.
const FixedRod kRod{.radius = 0.1, .margin = 1, .mu = 0.3, .position_gain = 0};

Eigen::Matrix3d cross_matrix(const Vector3d& a) {
  Eigen::Matrix3d cross;
  cross << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return cross;
}

/// T (6 L x 3 + 3 L): nu from the head's velocity and the links' angular velocities, which is every
/// motion that the joints allow.
MatrixXd minimal_coordinates(const BeadChain& chain) {
  const Index links = chain.links();
  MatrixXd T = MatrixXd::Zero(6 * links, 3 + 3 * links);
  for (Index i = 0; i < links; ++i) {
    T.block<3, 3>(6 * i, 0).setIdentity();
    for (Index j = 0; j <= i; ++j) {
      const double lever = j < i ? chain.link_length : chain.link_length / 2;
      T.block<3, 3>(6 * i, 3 + 3 * j) = -cross_matrix(lever * chain.axes.col(j));
    }
    T.block<3, 3>(6 * i + 3, 3 + 3 * i).setIdentity();
  }
  return T;
}

MatrixXd mass_matrix(const BeadChain& chain) {
  MatrixXd M = MatrixXd::Zero(6 * chain.links(), 6 * chain.links());
  for (Index i = 0; i < chain.links(); ++i) {
    const double across = chain.masses(i) * chain.link_length * chain.link_length / 12;
    const Eigen::Matrix3d along = chain.axes.col(i) * chain.axes.col(i).transpose();
    M.block<3, 3>(6 * i, 6 * i) = chain.masses(i) * Eigen::Matrix3d::Identity();
    M.block<3, 3>(6 * i + 3, 6 * i + 3) =
        across * (Eigen::Matrix3d::Identity() - (1 - chain.axial_share) * along);
  }
  return M;
}

TEST(BeadChain, DelassusMatrixEqualsThatOfMinimalCoordinates) {
  const BeadChain chain = bent_chain();
  const ChainStep step(chain, kRod, 1e-3);
  ASSERT_EQ(step.contact_problem().size(), 12);
  const MatrixXd T = minimal_coordinates(chain);
  const MatrixXd H = T.transpose() * mass_matrix(chain) * T;
  const MatrixXd JT = step.contact_jacobian() * T;
  const MatrixXd expected = 1e-3 * JT * H.ldlt().solve(JT.transpose());
  const MatrixXd& W = step.contact_problem().W;
  EXPECT_LT((W - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
  EXPECT_EQ(W, W.transpose().eval());
}

TEST(BeadChain, JacobianGivesTheRateAtWhichTheGapsOpen) {
  const BeadChain chain = bent_chain();
  const ChainStep step(chain, kRod, 1e-3);
  const VectorXd velocity = step.contact_jacobian() * chain.nu;
  EXPECT_LT((velocity - step.contact_problem().v_before).norm(), 1e-12);
  const auto distance = [](const BeadChain& at, const ContactId& id) {
    const Vector3d centre = at.centres().col(id.body1 - 1) +
                            (id.feature == 0 ? -1 : 1) * at.bead_offset * at.axes.col(id.body1 - 1);
    return std::hypot(centre.x(), centre.z());
  };
  const double dt = 1e-7;
  BeadChain moved = chain;
  moved.advance(dt);
  for (Index i = 0; i < step.contact_problem().size(); ++i) {
    const ContactId id = step.contact_problem().contacts[i].id;
    EXPECT_NEAR(velocity(3 * i), (distance(moved, id) - distance(chain, id)) / dt, 1e-5) << i;
  }
}

TEST(BeadChain, ContactForcesAndWeightChangeTheMomentumOfTheWhole) {
  const BeadChain chain = bent_chain();
  const ChainStep step(chain, kRod, 1e-3);
  cases::Uniform uniform(22);
  const VectorXd forces = VectorXd::NullaryExpr(36, [&uniform] { return 10 * uniform(); });
  const VectorXd after = step.velocity_after(forces);
  Vector3d change = Vector3d::Zero();
  for (Index i = 0; i < chain.links(); ++i)
    change += chain.masses(i) * (after - chain.nu).segment<3>(6 * i);
  const MatrixXd axes = contact_axes(step.contact_problem().contacts);
  const Vector3d expected =
      1e-3 * (axes.transpose() * forces + Vector3d(0, 0, -9.81) * chain.masses.sum());
  EXPECT_LT((change - expected).norm(), 1e-12);
}

TEST(BeadChain, VelocityAfterAStepIsWhatTheContactProblemSays) {
  const BeadChain chain = bent_chain();
  const ChainStep step(chain, kRod, 1e-3);
  const ContactProblem& problem = step.contact_problem();
  const VectorXd forces = VectorXd::LinSpaced(36, -3, 5);
  EXPECT_LT(
      (step.contact_jacobian() * step.velocity_after(forces) - (problem.W * forces + problem.vbar))
          .norm(),
      1e-12);
}

TEST(BeadChain, VelocityAfterAStepKeepsTheJointsTogether) {
  const BeadChain chain = bent_chain();
  const ChainStep step(chain, kRod, 1e-3);
  const VectorXd after = step.velocity_after(VectorXd::LinSpaced(36, -3, 5));
  const MatrixXd T = minimal_coordinates(chain);
  const VectorXd y = T.colPivHouseholderQr().solve(after);
  EXPECT_LT((T * y - after).norm(), 1e-11);
}

TEST(BeadChain, PenetratingBeadsArePushedOutByAShareOfTheirDepth) {
  const BeadChain chain = bent_chain();
  const double dt = 1e-3;
  FixedRod thick = kRod;
  thick.radius = 0.2;  // deeper than any bead
  FixedRod pushing = thick;
  pushing.position_gain = 0.005;
  const ContactProblem plain = ChainStep(chain, thick, dt).contact_problem();
  const ContactProblem pushed = ChainStep(chain, pushing, dt).contact_problem();
  const Vector3d bead = chain.centres().col(0) - chain.bead_offset * chain.axes.col(0);
  const double gap = std::hypot(bead.x(), bead.z()) - 0.2 - chain.bead_radius;
  ASSERT_LT(gap, 0);
  EXPECT_NEAR(pushed.vbar(0) - plain.vbar(0), 0.005 * gap / dt, 1e-12);
  EXPECT_EQ(pushed.vbar(1), plain.vbar(1));
}

TEST(BeadChain, NormalsPointAwayFromTheRodAndTangentsRunAroundAndAlongIt) {
  const BeadChain chain = bent_chain();
  const ContactProblem problem = ChainStep(chain, kRod, 1e-3).contact_problem();
  const Vector3d bead = chain.centres().col(2) + chain.bead_offset * chain.axes.col(2);
  const Contact& contact = problem.contacts[5];
  EXPECT_EQ(contact.id, (ContactId{3, 0, 1}));
  EXPECT_LT((contact.n - Vector3d(bead.x(), 0, bead.z()).normalized()).norm(), 1e-14);
  EXPECT_LT((contact.t1 - Vector3d::UnitY().cross(contact.n)).norm(), 1e-14);
  EXPECT_NEAR(std::abs(contact.t2.y()), 1, 1e-14);
}

}  // namespace
}  // namespace lcp
