#include "problems/contact/friction_lcp.h"

#include <gtest/gtest.h>

#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

using Eigen::Vector3d;

TEST(FrictionLcp, OfAParticleIsEquation25WrittenOut) {
  // W = I / 2, vbar = (-1, 0.3, 0), mu = 0.5, directions +t1, +t2, -t1, -t2.
  const Problem problem = friction_lcp(cases::particle(0.5, {-1, 0.3, 0}), {.directions = 4});
  MatrixXd M(6, 6);
  M << 0.5, 0, 0, 0, 0, 0,    //
      0, 0.5, 0, -0.5, 0, 1,  //
      0, 0, 0.5, 0, -0.5, 1,  //
      0, -0.5, 0, 0.5, 0, 1,  //
      0, 0, -0.5, 0, 0.5, 1,  //
      0.5, -1, -1, -1, -1, 0;
  EXPECT_EQ(problem.M, M);
  EXPECT_EQ(problem.q, (VectorXd{{-1, 0.3, 0, -0.3, 0, 0}}));
  // v* = 1 m/s, f* = 1 / 0.5 N.
  EXPECT_EQ(problem.s_z, (VectorXd{{2, 2, 2, 2, 2, 1}}));
  EXPECT_EQ(problem.s_w, (VectorXd{{1, 1, 1, 1, 1, 2}}));
}

TEST(FrictionLcp, OfAStickingParticleIsSolvedByTheForceThatStopsIt) {
  // f = -vbar / 0.5 = (2, -0.6, 0), inside the cone since 0.6 < 0.5 * 2.
  const Problem problem = friction_lcp(cases::particle(0.5, {-1, 0.3, 0}), {.directions = 4});
  const VectorXd z{{2, 0, 0, 0.6, 0, 0}};
  EXPECT_NEAR(cases::natural_residual(problem, z), 0, 1e-15);
  const VectorXd forces = contact_forces(*problem.friction, z);
  EXPECT_EQ(forces, Vector3d(2, -0.6, 0));
  EXPECT_NEAR(post_velocities(*problem.friction, forces).norm(), 0, 1e-15);
}

TEST(FrictionLcp, OfASlidingParticleHasItsSlipSpeedInLambda) {
  // f_n = 2, friction 0.2 * 2 against +t1: slip 3 - 0.4 / 2 = 2.8 m/s.
  const Problem problem = friction_lcp(cases::particle(0.2, {-1, 3, 0}), {.directions = 4});
  const VectorXd z{{2, 0, 0, 0.4, 0, 2.8}};
  EXPECT_NEAR(cases::natural_residual(problem, z), 0, 1e-15);
}

TEST(FrictionLcp, IsAssembledAgainFromItsBlocksWithUnknownsWhereTheySay) {
  cases::Uniform uniform(3);
  const Problem problem =
      friction_lcp(cases::random_contacts({0.3, 0, 0.8}, 100, uniform), {.directions = 4});
  EXPECT_EQ(assemble_friction_lcp(*problem.friction).M, problem.M);
  EXPECT_EQ(assemble_friction_lcp(*problem.friction).s_z, problem.s_z);

  FrictionBlocks moved = *problem.friction;  // [a | lambda | b] instead of [a | b | lambda]
  moved.cone_row = {3, -1, 4};
  moved.friction_row = {5, -1, 9};
  const Problem other = assemble_friction_lcp(moved);
  const std::vector<Index> rows = {0, 1, 2, 11, 12, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(other.M, MatrixXd(problem.M(rows, rows)));
  EXPECT_EQ(other.q, VectorXd(problem.q(rows)));
  EXPECT_EQ(other.s_z, VectorXd(problem.s_z(rows)));
  EXPECT_EQ(other.s_w, VectorXd(problem.s_w(rows)));
}

TEST(FrictionLcp, BlocksAreThoseOfEquation25AndFrictionlessContactsHaveNoRowsInThem) {
  cases::Uniform uniform(3);
  const ContactProblem contacts = cases::random_contacts({0.3, 0, 0.8}, 100, uniform);
  const Index m = 6;
  const Problem problem = friction_lcp(contacts, {.directions = m});
  ASSERT_EQ(problem.size(), 3 + 2 * (m + 1));
  const FrictionBlocks& blocks = *problem.friction;
  EXPECT_EQ(blocks.normal_row, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(blocks.friction_row, (std::vector<Index>{3, -1, 9}));
  EXPECT_EQ(blocks.cone_row, (std::vector<Index>{15, -1, 16}));

  MatrixXd N = MatrixXd::Zero(9, 3), C = MatrixXd::Zero(9, 2 * m), E = MatrixXd::Zero(2, 2 * m);
  MatrixXd mu = MatrixXd::Zero(2, 3);
  for (Index i = 0; i < 3; ++i) N(3 * i, i) = 1;
  C.block(1, 0, 2, m) = blocks.directions.leftCols(m);
  C.block(7, m, 2, m) = blocks.directions.rightCols(m);
  E.row(0).head(m).setOnes();
  E.row(1).tail(m).setOnes();
  mu(0, 0) = 0.3;
  mu(1, 2) = 0.8;
  MatrixXd M(17, 17);
  const MatrixXd& W = contacts.W;
  M << N.transpose() * W * N, N.transpose() * W * C, MatrixXd::Zero(3, 2),  //
      C.transpose() * W * N, C.transpose() * W * C, E.transpose(),          //
      mu, -E, MatrixXd::Zero(2, 2);
  VectorXd q(17);
  q << N.transpose() * contacts.vbar, C.transpose() * contacts.vbar, 0, 0;
  EXPECT_LT((problem.M - M).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT((problem.q - q).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(FrictionLcp, OppositeDirectionsGiveOppositeRowsAndColumnsToTheLastBit) {
  cases::Uniform uniform(4);
  const Problem problem =
      friction_lcp(cases::random_contacts({0.3, 0.5, 0.8}, 100, uniform), {.directions = 8});
  const Index velocity_rows = 3 + 3 * 8;
  const MatrixXd velocity = problem.M.topLeftCorner(velocity_rows, velocity_rows);
  for (const Index first : problem.friction->friction_row) {
    EXPECT_EQ(velocity.middleRows(first, 4), -velocity.middleRows(first + 4, 4));
    EXPECT_EQ(velocity.middleCols(first, 4), -velocity.middleCols(first + 4, 4));
  }
}

TEST(FrictionLcp, IsTheSameInMetresAndInMillimetresOnceScaled) {
  cases::Uniform uniform(5);
  ContactProblem contacts = cases::random_contacts({0.3, 0.5}, 100, uniform);
  const Problem metres = friction_lcp(contacts);
  contacts.W *= 1000;
  contacts.vbar *= 1000;
  const Problem millimetres = friction_lcp(contacts);

  for (Index i = 0; i < metres.size(); ++i) {
    const bool cone = i >= 2 + 2 * 8;
    EXPECT_NEAR(millimetres.s_z(i) / metres.s_z(i), cone ? 1000 : 1, cone ? 1e-12 : 1e-15);
    EXPECT_NEAR(millimetres.s_w(i) / metres.s_w(i), cone ? 1 : 1000, cone ? 1e-15 : 1e-12);
  }
  const auto scaled = [](const Problem& problem) -> MatrixXd {
    return problem.s_w.cwiseInverse().asDiagonal() * problem.M * problem.s_z.asDiagonal();
  };
  EXPECT_LT((scaled(metres) - scaled(millimetres)).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((metres.q.cwiseQuotient(metres.s_w) - millimetres.q.cwiseQuotient(millimetres.s_w))
                .cwiseAbs()
                .maxCoeff(),
            1e-15);
}

/// v* in all rows' w and f* in their z, but the other way round in the rows of lambda.
void expect_scales(const Problem& problem, double v, double f) {
  VectorXd s_z = VectorXd::Constant(problem.size(), f);
  VectorXd s_w = VectorXd::Constant(problem.size(), v);
  for (const Index row : problem.friction->cone_row) {
    if (row < 0) continue;
    s_z(row) = v;
    s_w(row) = f;
  }
  ASSERT_EQ(problem.s_z.size(), problem.size());
  ASSERT_EQ(problem.s_w.size(), problem.size());
  for (Index i = 0; i < problem.size(); ++i) {
    EXPECT_DOUBLE_EQ(problem.s_z(i), s_z(i)) << "row " << i;
    EXPECT_DOUBLE_EQ(problem.s_w(i), s_w(i)) << "row " << i;
  }
}

TEST(FrictionLcp, ScalesAreTheLargestSpeedAndWhatForceGivesItAtTheMeanNormalMobility) {
  // Two contacts; the largest |vbar| is tangential, negative and of the second. The normal mobilities
  // are 1 and 3, so that 2 is their mean.
  ContactProblem contacts;
  contacts.contacts = cases::floor_contacts({0.5, 0});
  contacts.W = VectorXd{{1, 20, 30, 3, 40, 50}}.asDiagonal();
  contacts.vbar = VectorXd{{-1, 2, 0, 3, 0, -8}};
  const Problem problem = friction_lcp(contacts, {.directions = 4});
  expect_scales(problem, 8, 8 / 2.0);
  contacts.vbar(5) = 0;  // now it is a normal one, 3
  expect_scales(friction_lcp(contacts), 3, 3 / 2.0);
}

TEST(FrictionLcp, ScalesOfManyContactsFollowTheSameRule) {
  for (const Index seed : {10, 11, 12}) {
    cases::Uniform uniform(seed);
    const ContactProblem contacts = cases::random_contacts({0.3, 0, 0.8, 0.5}, 1000, uniform);
    double mobility = 0;
    for (Index i = 0; i < 4; ++i) mobility += contacts.W(3 * i, 3 * i) / 4;
    const double v = contacts.vbar.lpNorm<Eigen::Infinity>();
    expect_scales(friction_lcp(contacts), v, v / mobility);
    expect_scales(frictionless_lcp(contacts), v, v / mobility);
  }
}

TEST(FrictionLcp, ScalesStayPositiveWithoutMotionOrMobility) {
  ContactProblem still = cases::particle(0.5, {0, 0, 0});
  EXPECT_EQ(friction_lcp(still).s_w(0), 1);
  EXPECT_EQ(friction_lcp(still).s_z(0), 2);
  still.W.setZero();
  EXPECT_EQ(friction_lcp(still).s_z(0), 1);
}

TEST(FrictionLcp, WithoutFrictionIsTheNormalBlock) {
  cases::Uniform uniform(6);
  const ContactProblem contacts = cases::random_contacts({0.3, 0.5}, 100, uniform);
  const Problem problem = frictionless_lcp(contacts);
  ASSERT_EQ(problem.size(), 2);
  EXPECT_EQ(problem.M(0, 1), contacts.W(0, 3));
  EXPECT_EQ(problem.M(1, 1), contacts.W(3, 3));
  EXPECT_EQ(problem.q(1), contacts.vbar(3));
  EXPECT_EQ(contact_forces(*problem.friction, VectorXd{{2, 3}}), (VectorXd{{2, 0, 0, 3, 0, 0}}));
}

void expect_same_blocks(const FrictionBlocks& got, const FrictionBlocks& want) {
  EXPECT_EQ(got.W, want.W);
  EXPECT_EQ(got.vbar, want.vbar);
  EXPECT_EQ(got.mu, want.mu);
  EXPECT_EQ(got.directions, want.directions);
  EXPECT_EQ(got.directions_per_contact, want.directions_per_contact);
  EXPECT_EQ(got.normal_row, want.normal_row);
  EXPECT_EQ(got.friction_row, want.friction_row);
  EXPECT_EQ(got.cone_row, want.cone_row);
}

TEST(FrictionlessPart, IsTheFrictionlessLcpOfTheSameContactsBitForBit) {
  for (const std::vector<double>& mu :
       {std::vector<double>{0.3, 0.5, 0.8}, {0, 0.5, 0}, {0, 0}, {}}) {
    cases::Uniform uniform(8);
    const ContactProblem contacts = cases::random_contacts(mu, 1e6, uniform);
    const Problem part = frictionless_part(friction_lcp(contacts));
    const Problem expected = frictionless_lcp(contacts);
    EXPECT_EQ(part.M, expected.M);
    EXPECT_EQ(part.q, expected.q);
    EXPECT_EQ(part.s_z, expected.s_z);
    EXPECT_EQ(part.s_w, expected.s_w);
    EXPECT_EQ(part.c.size(), 0);
    EXPECT_EQ(part.pivot_limit, expected.pivot_limit);
    expect_same_blocks(*part.friction, *expected.friction);
  }
}

TEST(FrictionlessPart, FollowsTheContactsWhereverTheirRowsStandAndKeepsScales) {
  cases::Uniform uniform(9);
  Problem problem = friction_lcp(cases::random_contacts({0.3, 0}, 10, uniform), {.directions = 2});
  problem.s_z = VectorXd::LinSpaced(5, 1, 5);
  problem.s_w = VectorXd::LinSpaced(5, 6, 10);
  problem.c = VectorXd::LinSpaced(5, 11, 15);
  problem.pivot_limit = 77;
  // Rows in reverse: contact 0 has normal row 4, contact 1 row 3.
  const std::vector<Index> reversed = {4, 3, 2, 1, 0};
  problem.M = MatrixXd(problem.M(reversed, reversed));
  problem.q = VectorXd(problem.q(reversed));
  problem.friction->normal_row = {4, 3};
  const Problem part = frictionless_part(problem);
  ASSERT_EQ(part.size(), 2);
  for (const VectorXd* rows : {&part.s_z, &part.s_w, &part.c}) ASSERT_EQ(rows->size(), 2);
  EXPECT_EQ(part.M(0, 1), problem.M(4, 3));
  EXPECT_EQ(part.q, (VectorXd{{problem.q(4), problem.q(3)}}));
  EXPECT_EQ(part.s_z, (VectorXd{{5, 4}}));
  EXPECT_EQ(part.s_w, (VectorXd{{10, 9}}));
  EXPECT_EQ(part.c, (VectorXd{{15, 14}}));
  EXPECT_EQ(part.pivot_limit, 77);
  EXPECT_EQ(part.friction->normal_row, (std::vector<Index>{0, 1}));
}

TEST(FrictionlessPart, NeedsFrictionBlocks) {
  Problem plain;
  EXPECT_THROW(frictionless_part(plain), std::invalid_argument);
  EXPECT_FALSE(has_friction(plain));
  EXPECT_FALSE(has_friction(frictionless_lcp(cases::particle(0.5, {-1, 0, 0}))));
  EXPECT_TRUE(has_friction(friction_lcp(cases::particle(0.5, {-1, 0, 0}))));
}

TEST(FrictionLcp, MapsForcesBackAsNormalAndCombinedDirections) {
  cases::Uniform uniform(7);
  const Problem problem = friction_lcp(cases::random_contacts({0, 0.5}, 10, uniform));
  VectorXd z = VectorXd::Zero(problem.size());
  z(0) = 4;
  z(1) = 5;
  z(2) = 3;        // b_1 of contact 1, along t1
  z(2 + 2) = 1.5;  // b_3, along t2
  const VectorXd forces = contact_forces(*problem.friction, z);
  EXPECT_EQ(forces, (VectorXd{{4, 0, 0, 5, 3, 1.5}}));
  const VectorXd velocity = problem.friction->W * forces + problem.friction->vbar;
  EXPECT_EQ(post_velocities(*problem.friction, forces), velocity);
  EXPECT_THROW(contact_forces(*problem.friction, z.head(4)), std::invalid_argument);
  EXPECT_THROW(post_velocities(*problem.friction, forces.head(3)), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
