// The adapters of outside solvers. Tests of a peer that is not built in are skipped, and say so.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "solvers/peers/outside_call.h"
#include "tests/solvers/cases.h"

namespace lcp {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// Every peer there may be, whatever this build has.
const std::vector<std::string>& all_peers() {
  static const std::vector<std::string> names = {"bullet-dantzig",
                                                 "bullet-lemke",
                                                 "dart-dantzig",
                                                 "dart-lemke",
                                                 "dart-pgs",
                                                 "siconos-cao-ferris",
                                                 "siconos-lexicographic-lemke",
                                                 "siconos-murty",
                                                 "siconos-newton-fb",
                                                 "siconos-newton-min",
                                                 "siconos-newton-minfb",
                                                 "siconos-pathsearch",
                                                 "siconos-rpgs"};
  return names;
}

/// Why a peer cannot be tested here, or nothing.
std::string absence(const std::string& name) {
  for (const AbsentPeer& peer : absent_peers())
    if (peer.name == name) return name + " is not built in: it needs " + peer.package;
  return "";
}

bool needs_symmetry(const std::string& name) {
  return name.ends_with("-dantzig") || name == "dart-pgs";
}

bool takes_points(const std::string& name) {
  return name == "siconos-newton-fb" || name == "siconos-newton-minfb" ||
         name == "siconos-pathsearch" || name == "siconos-rpgs";
}

/// M = JJ', J n x 6, in doubles, with a solution z of which half is positive: rank-deficient, as in
/// contact.
Problem rank_six(Index n, unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&] { return static_cast<double>(random()) / 0x1p31 - 1; };
  const MatrixXd J = MatrixXd::NullaryExpr(n, 6, draw);
  const MatrixXd M = J * J.transpose();
  VectorXd z = VectorXd::NullaryExpr(n, draw), w = z;
  z = z.cwiseMax(0.0);
  w = (-w).cwiseMax(0.0);
  return cases::plain(M, w - M * z);
}

class EveryPeer : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const std::string why = absence(GetParam());
    if (!why.empty()) GTEST_SKIP() << why;
  }

  Result solve(const Problem& problem, const Call& call = {}) const {
    return cases::solve(GetParam(), problem, call);
  }
};

TEST_P(EveryPeer, SaysWhatItIs) {
  const RowInfo& info = find_row(GetParam()).info;
  EXPECT_TRUE(info.peer());
  EXPECT_NE(info.outside_library.find_first_of("0123456789"), std::string::npos) << info.outside_library;
  EXPECT_FALSE(info.supports.empty());
  EXPECT_FALSE(info.outside_constants.empty());
}

TEST_P(EveryPeer, SolvesTwoRows) {
  for (const char* scale : {"on", "off"}) {
    const Problem problem = cases::plain(Matrix2d{{2, 1}, {1, 2}}, Vector2d(-4, -5));
    const Result result = cases::solve(GetParam() + ":scale=" + scale, problem);
    ASSERT_EQ(result.claim, Claim::solved) << result.message;
    EXPECT_NEAR(result.z(0), 1, 1e-6);
    EXPECT_NEAR(result.z(1), 2, 1e-6);
    if (result.w.size() > 0) {
      EXPECT_LT((result.w - problem.M * result.z - problem.q).norm(), 1e-6);
    }
  }
}

TEST_P(EveryPeer, MeansTheSameSignOfQ) {
  const Result result = solve(cases::plain(Matrix2d{{1, 0}, {0, 1}}, Vector2d(1, -1)));
  ASSERT_EQ(result.claim, Claim::solved) << result.message;
  EXPECT_NEAR(result.z(0), 0, 1e-6);
  EXPECT_NEAR(result.z(1), 1, 1e-6);
}

TEST_P(EveryPeer, MeansMAndNotItsTransposeOrDoesNotSupportIt) {
  const Problem problem = cases::plain(Matrix2d{{2, 1}, {-1, 2}}, Vector2d(-4, -3));
  const Result result = solve(problem);
  if (needs_symmetry(GetParam())) {
    EXPECT_EQ(result.claim, Claim::unsupported);
    EXPECT_NE(result.message.find("symmetric"), std::string::npos) << result.message;
    return;
  }
  ASSERT_EQ(result.claim, Claim::solved) << result.message;
  EXPECT_NEAR(result.z(0), 1, 1e-6);
  EXPECT_NEAR(result.z(1), 2, 1e-6);
}

TEST_P(EveryPeer, RowsOfALargerMatrixAreNotMixedUp) {  // padding, leading dimensions
  for (const Index n : {3, 4, 5, 7}) {
    MatrixXd M = MatrixXd::Identity(n, n) * 4;
    for (Index i = 0; i + 1 < n; ++i) M(i, i + 1) = M(i + 1, i) = 1 + 0.1 * static_cast<double>(i);
    const VectorXd z = VectorXd::LinSpaced(n, 1, static_cast<double>(n));
    const Result result = solve(cases::plain(M, -M * z));
    ASSERT_EQ(result.claim, Claim::solved) << result.message;
    EXPECT_LT((result.z - z).norm(), 1e-5) << n;
  }
}

TEST_P(EveryPeer, SolvesTheEmptyProblemAndOneRow) {
  const Result empty = solve(cases::plain(MatrixXd(0, 0), VectorXd(0)));
  EXPECT_EQ(empty.claim, Claim::solved);
  EXPECT_EQ(empty.z.size(), 0);
  for (const double q : {-4.0, 3.0}) {
    const Result one = solve(cases::plain(MatrixXd::Constant(1, 1, 2), VectorXd::Constant(1, q)));
    ASSERT_EQ(one.claim, Claim::solved) << q << ' ' << one.message;
    EXPECT_NEAR(one.z(0), std::max(0.0, -q / 2), 1e-6);
  }
}

TEST_P(EveryPeer, NeverClaimsSuccessWithoutFiniteNumbers) {
  for (const Index n : {16, 32, 48})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Result result = solve(rank_six(n, seed));
      ASSERT_EQ(result.z.size(), n);
      EXPECT_TRUE(result.z.allFinite()) << to_string(result.claim);
      EXPECT_TRUE(result.w.allFinite());
    }
}

TEST_P(EveryPeer, IsSilent) {
  const Problem problem = rank_six(24, 1);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::printf("ours ");  // Still in the buffer when the library is called.
  solve(problem);
  std::printf("too");
  std::fprintf(stderr, "and this");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "ours too");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "and this");
}

TEST_P(EveryPeer, GivesTheSameBitsAgain) {
  const Problem problem = rank_six(32, 3);
  const Result first = solve(problem), second = solve(problem);
  EXPECT_EQ(first.claim, second.claim);
  EXPECT_EQ(first.z, second.z);
  EXPECT_EQ(first.w, second.w);
  EXPECT_EQ(first.work.pivots, second.work.pivots);
  EXPECT_EQ(first.work.sweeps, second.work.sweeps);
}

TEST_P(EveryPeer, StartsFromAPointOrSaysThatItDoesNot) {
  const Problem problem = cases::plain(Matrix2d{{2, 1}, {1, 2}}, Vector2d(-4, -5));
  Call call;
  call.start = Start{{0, 1}, VectorXd()};
  EXPECT_EQ(solve(problem, call).claim, Claim::unsupported);
  call.start->z = Vector2d(1.1, 1.9);  // Not the solution itself: path search fails there.
  const Result result = solve(problem, call);
  if (!takes_points(GetParam())) {
    EXPECT_EQ(result.claim, Claim::unsupported);
    EXPECT_EQ(result.message, "takes no starting point");
    return;
  }
  ASSERT_EQ(result.claim, Claim::solved) << result.message;
  EXPECT_LT((result.z - Vector2d(1, 2)).norm(), 1e-6);
  EXPECT_LE(result.work.sweeps, solve(problem).work.sweeps);
}

TEST_P(EveryPeer, WhatNeedsAPositiveDiagonalSaysSo) {
  const Result result = solve(cases::plain(Matrix2d{{1, 1}, {1, 0}}, Vector2d(-1, -1)));
  if (GetParam() == "dart-pgs" || GetParam() == "siconos-newton-min") {
    EXPECT_EQ(result.claim, Claim::unsupported);
    EXPECT_NE(result.message.find("diagonal"), std::string::npos) << result.message;
  } else {
    EXPECT_NE(result.claim, Claim::unsupported) << result.message;
  }
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Peers, EveryPeer, testing::ValuesIn(all_peers()), test_name);

TEST(Peers, AreAllListedHere) {
  std::vector<std::string> known;
  for (const Row& row : registry())
    if (row.info.peer()) known.push_back(row.info.name);
  for (const AbsentPeer& peer : absent_peers()) known.push_back(peer.name);
  std::sort(known.begin(), known.end());
  EXPECT_EQ(known, all_peers());
}

// What these libraries get wrong, as they are in Debian 12. A newer one that does better fails here,
// and then this page and the README have something to say.

#define NEEDS(name) \
  if (!absence(name).empty()) GTEST_SKIP() << absence(name)

/// Claims of success on rank-deficient problems whose residual is above 1e-6, and of those that the
/// adapter refused because z was not finite.
std::pair<int, int> false_claims(const std::string& solver) {
  int wrong = 0, not_finite = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Problem problem = rank_six(32, seed);
    const Result result = cases::solve(solver, problem);
    if (result.claim == Claim::solved && !(cases::residual(problem, result) <= 1e-6)) ++wrong;
    if (result.message.find("not finite") != std::string::npos) ++not_finite;
  }
  return {wrong, not_finite};
}

TEST(KnownOfPeers, SiconosNewtonMinReportsSuccessWithNan) {
  NEEDS("siconos-newton-min");
  EXPECT_GT(false_claims("siconos-newton-min").second, 0);
}

TEST(KnownOfPeers, SiconosAnswersOneRowWithANegativeZ) {
  NEEDS("siconos-newton-fb");
  const Result result = cases::solve(
      "siconos-newton-fb", cases::plain(-MatrixXd::Ones(1, 1), VectorXd::Constant(1, -1)));
  EXPECT_EQ(result.claim, Claim::solved);
  EXPECT_EQ(result.z(0), -1);
}

TEST(KnownOfPeers, DartDantzigWithoutEarlyTerminationAlwaysReportsSuccess) {
  NEEDS("dart-dantzig");
  EXPECT_GT(false_claims("dart-dantzig:early=off").first, 0);
  EXPECT_EQ(false_claims("dart-dantzig").first, 0);
}

TEST(KnownOfPeers, DartDantzigSolvesRankDeficientProblemsWithSomethingOnTheDiagonal) {
  NEEDS("dart-dantzig");
  const Problem problem = rank_six(32, 1);
  const Result result = cases::solve("dart-dantzig:cfm=1e-9", problem);
  EXPECT_EQ(result.claim, Claim::solved) << result.message;
  EXPECT_LT(cases::residual(problem, result), 1e-6);
}

TEST(KnownOfPeers, BulletLemkeReportsSuccessWhereThereIsNone) {
  NEEDS("bullet-lemke");
  const auto [wrong, not_finite] = false_claims("bullet-lemke");
  EXPECT_GT(wrong + not_finite, 0);
}

TEST(KnownOfPeers, MurtysRuleNeedsAllPivotsOnTheUpperTriangularFamilyAndTellsTheLimit) {
  NEEDS("siconos-murty");
  const Index n = 10;
  MatrixXd M = MatrixXd::Identity(n, n);
  for (Index i = 0; i < n; ++i) M.row(i).tail(n - i - 1).setConstant(2);
  Problem problem = cases::plain(M, VectorXd::Constant(n, -1));
  problem.pivot_limit = 2000;
  EXPECT_EQ(cases::solve("siconos-murty", problem).claim, Claim::solved);
  problem.pivot_limit = 10;
  const Result cut_short = cases::solve("siconos-murty", problem);
  EXPECT_EQ(cut_short.claim, Claim::limit) << cut_short.message;
}

TEST(OutsideCalls, ThatAbortLeaveALineOnTheRealStderr) {
  EXPECT_DEATH(
      {
        const OutsideCall under_way("some-row");
        std::abort();
      },
      "some-row: the outside library aborted the process");
}

TEST(OutsideCalls, ThatExitLeaveALineOnTheRealStderr) {
  EXPECT_EXIT(
      {
        const OutsideCall under_way("some-row");
        std::exit(3);
      },
      testing::ExitedWithCode(3), "some-row: the outside library ended the process with exit");
}

TEST(OutsideCalls, SilencedForGoodPrintNothingAndStillLeaveThatLine) {
  EXPECT_DEATH(
      {
        silence_outside_calls();
        for (int call = 0; call < 2; ++call) {
          const OutsideCall under_way("some-row");
          std::fprintf(stderr, "chatter\n");
          std::fflush(stderr);
          if (call == 1) std::abort();
        }
      },
      "^some-row: the outside library aborted the process\n$");
}

TEST(OutsideCalls, LeaveOtherEndsOfTheProcessAlone) {
  EXPECT_EXIT(
      {
        { const OutsideCall under_way("some-row"); }
        std::fprintf(stderr, "only this\n");
        std::exit(0);
      },
      testing::ExitedWithCode(0), "^only this\n$");
}

}  // namespace
}  // namespace lcp
