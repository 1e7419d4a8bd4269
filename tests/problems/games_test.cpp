#include "problems/games.h"

#include <gtest/gtest.h>

namespace lcp {
namespace {

TEST(Games, SumsStandOnceAsInequalities) {
  const Problem lcp = game_lcp(MatrixXd{{1, 2}}, MatrixXd{{3, 4}}, 1, 1);
  const MatrixXd M{{0, 1, 2, 1, -1, 0, 0}, {3, 0, 0, 0, 0, 1, -1}, {4, 0, 0, 0, 0, 1, -1},
                   {-1, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0},  {0, -1, -1, 0, 0, 0, 0},
                   {0, 1, 1, 0, 0, 0, 0}};
  EXPECT_EQ(lcp.M, M);
  EXPECT_EQ(lcp.q, (VectorXd{{0, 0, 0, 1, -1, 1, -1}}));
}

TEST(Games, SumsMayBeRepeated) {
  const Problem lcp = game_lcp(MatrixXd{{1}}, MatrixXd{{2}}, 1, 2);
  const MatrixXd M{{0, 1, 1, -1, 0, 0, 0, 0}, {2, 0, 0, 0, 1, 1, -1, -1}, {-1, 0, 0, 0, 0, 0, 0, 0},
                   {1, 0, 0, 0, 0, 0, 0, 0},  {0, -1, 0, 0, 0, 0, 0, 0},  {0, -1, 0, 0, 0, 0, 0, 0},
                   {0, 1, 0, 0, 0, 0, 0, 0},  {0, 1, 0, 0, 0, 0, 0, 0}};
  EXPECT_EQ(lcp.M, M);
  EXPECT_EQ(lcp.q, (VectorXd{{0, 0, 1, -1, 1, 1, -1, -1}}));
}

TEST(Games, LemkeHowsonFormHoldsNothingButCosts) {
  const Problem lcp = lemke_howson_lcp(MatrixXd{{1, 2}}, MatrixXd{{3, 4}});
  EXPECT_EQ(lcp.M, (MatrixXd{{0, 1, 2}, {3, 0, 0}, {4, 0, 0}}));
  EXPECT_EQ(lcp.q, (VectorXd{{-1, -1, -1}}));
}

}  // namespace
}  // namespace lcp
