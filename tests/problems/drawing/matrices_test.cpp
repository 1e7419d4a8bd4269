#include "problems/drawing/matrices.h"

#include <gtest/gtest.h>

#include "tests/problems/families/independent.h"

namespace lcp {
namespace {

TEST(DrawnMatrices, OrthonormalColumnsAre) {
  Random random(1);
  const MatrixXd Q = orthonormal_columns(9, 4, random);
  EXPECT_LT((Q.transpose() * Q - MatrixXd::Identity(4, 4)).norm(), 1e-14);
}

TEST(DrawnMatrices, SpectrumTakesBothEndsAndStaysBetweenThem) {
  Random random(1);
  for (const Index size : {2, 3, 50}) {
    const VectorXd values = spread_spectrum(size, 1e4, random);
    EXPECT_EQ(values.maxCoeff(), 1);
    EXPECT_EQ(values.minCoeff(), 1e-4);
  }
  EXPECT_EQ(spread_spectrum(1, 1e4, random), VectorXd::Ones(1));
}

TEST(DrawnMatrices, SkewMatrixIsSkewToTheBitAndOfNormOne) {
  Random random(1);
  for (const Index n : {2, 5, 8}) {
    const MatrixXd K = skew_matrix(n, random);
    EXPECT_EQ(K, (-K.transpose()).eval());
    EXPECT_NEAR(independent::singular_values(K)(0), 1, 1e-14);
  }
  EXPECT_EQ(skew_matrix(1, random), MatrixXd::Zero(1, 1));
}

TEST(DrawnMatrices, GramMatrixIsSymmetricToTheBit) {
  Random random(1);
  const MatrixXd A = uniform_matrix(7, 3, random), S = gram_matrix(A);
  EXPECT_EQ(S, S.transpose().eval());
  EXPECT_LT((S - A * A.transpose()).norm(), 1e-14);
}

}  // namespace
}  // namespace lcp
