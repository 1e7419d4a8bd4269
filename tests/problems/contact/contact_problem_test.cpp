#include "problems/contact/contact_problem.h"

#include <gtest/gtest.h>

#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

using Eigen::Vector3d;

TEST(ContactProblem, FrameIsRightHandedWithItsFirstTangentAlongTheGivenDirection) {
  const Contact contact = make_contact({0, 0, 2}, {3, 0, 5}, 0.4, {7, 8, 9});
  EXPECT_EQ(contact.n, Vector3d(0, 0, 1));
  EXPECT_EQ(contact.t1, Vector3d(1, 0, 0));
  EXPECT_EQ(contact.t2, Vector3d(0, 1, 0));
  EXPECT_EQ(contact.mu, 0.4);
  EXPECT_EQ(contact.id, (ContactId{7, 8, 9}));
}

TEST(ContactProblem, FrameNeedsADirectionAcrossTheNormal) {
  EXPECT_THROW(make_contact(Vector3d::Zero(), Vector3d::UnitX(), 0, {}), std::invalid_argument);
  EXPECT_THROW(make_contact(Vector3d::UnitZ(), -3 * Vector3d::UnitZ(), 0, {}),
               std::invalid_argument);
}

TEST(ContactProblem, AxesAreRowsWithTheNormalFirst) {
  const MatrixXd axes = contact_axes(cases::floor_contacts({0.5, 0.5}));
  MatrixXd expected(6, 3);
  expected << 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_EQ(axes, expected);
}

TEST(ContactProblem, DelassusMatrixIsSymmetricToTheLastBit) {
  cases::Uniform uniform(1);
  const MatrixXd A = MatrixXd::NullaryExpr(6, 9, [&uniform] { return uniform(); });
  const MatrixXd W = delassus_matrix(A, 0.5);
  EXPECT_LT((W - 0.5 * A.transpose() * A).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(W, W.transpose().eval());
  EXPECT_EQ(delassus_matrix(MatrixXd(6, 0), 0.5).size(), 0);
}

/// The message of what check() refuses, or "accepted".
std::string verdict(const ContactProblem& problem) {
  try {
    check(problem, "here");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ContactProblem, RefusalsNameTheFieldAndTheOffendingValue) {
  const ContactProblem good = cases::particle(0.5, {-1, 0, 0});
  EXPECT_EQ(verdict(good), "accepted");

  ContactProblem bad = good;
  bad.W(0, 2) = 0.25;
  EXPECT_EQ(verdict(bad), "here: W(2, 0) is 0 but W(0, 2) is 0.25, expected a symmetric W");
  bad = good;
  bad.W.resize(2, 3);
  EXPECT_EQ(verdict(bad), "here: W is 2 x 3, expected 3 x 3");
  bad = good;
  bad.vbar.resize(2);
  EXPECT_EQ(verdict(bad), "here: vbar has 2 entries, expected 3");
  bad = good;
  bad.v_before = Vector3d(0, NAN, 0);
  EXPECT_EQ(verdict(bad), "here: v_before(1) is nan, expected a finite number");
  bad = good;
  bad.contacts[0].mu = -0.1;
  EXPECT_EQ(verdict(bad), "here: mu of contact 0 is -0.1, expected 0 or more");
  bad = good;
  bad.dt = 0;
  EXPECT_EQ(verdict(bad), "here: dt is 0, expected a positive time");
}

}  // namespace
}  // namespace lcp
