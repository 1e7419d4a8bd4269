// The ratio test of the search, against the definition written out row by row.

#include "solvers/linalg/pivot_candidates.h"

#include <gtest/gtest.h>

#include <random>

namespace lcp {
namespace {

constexpr double kEpsilon = 1e-3;
constexpr Pricing kPricing{.epsilon = kEpsilon, .grid = 1e-6};
constexpr double kPivot = 1e-9;

bool blocks(double m) { return m < -kPivot; }

struct Column {
  VectorXd q, m;
};

/// Entries of few values, so that ratios tie and zeros are frequent; q' >= 0 but for some noise.
Column draw(Index n, unsigned seed) {
  std::mt19937 random(seed);
  const auto pick = [&](std::initializer_list<double> values) {
    return values.begin()[random() % values.size()];
  };
  Column column{VectorXd(n), VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    column.q(i) = pick({0, 0, 0, 1, 2, 0.5, 1e-5, -5e-4});
    column.m(i) = pick({0, 1, -1, -2, -0.5, 3, -1e-12});
  }
  return column;
}

/// q_min after a pivot in row i: its own row holds the entering variable then.
double q_min(const Column& column, Index i) {
  const double theta = -column.q(i) / column.m(i);
  double least = theta;
  for (Index k = 0; k < column.q.size(); ++k)
    if (k != i) least = std::min(least, column.q(k) + theta * column.m(k));
  return least;
}

std::vector<PivotCandidate> by_definition(const Column& column) {
  std::vector<PivotCandidate> candidates;
  for (Index i = 0; i < column.q.size(); ++i) {
    if (!blocks(column.m(i)) || !(q_min(column, i) > -kEpsilon)) continue;
    candidates.push_back({i, -column.q(i) / column.m(i), kPricing.cost(q_min(column, i))});
  }
  return candidates;
}

std::vector<PivotCandidate> found(const Column& column) {
  VectorXd ratios;
  std::vector<PivotCandidate> candidates;
  find_candidates(column.q, column.m, blocks, kPricing, ratios, candidates);
  return candidates;
}

TEST(PivotCandidates, AreThoseOfTheDefinitionWithTheirCosts) {
  Index seen = 0;
  for (Index n = 1; n <= 13; ++n) {  // with and without rows left over by fours and pairs
    for (unsigned seed = 0; seed < 400; ++seed) {
      const Column column = draw(n, seed);
      const std::vector<PivotCandidate> expected = by_definition(column), actual = found(column);
      ASSERT_EQ(actual.size(), expected.size()) << "n = " << n << ", seed " << seed;
      for (std::size_t c = 0; c < actual.size(); ++c) {
        EXPECT_EQ(actual[c].row, expected[c].row) << "n = " << n << ", seed " << seed;
        EXPECT_DOUBLE_EQ(actual[c].ratio, expected[c].ratio);
        EXPECT_EQ(actual[c].cost, expected[c].cost);
      }
      seen += static_cast<Index>(actual.size());
    }
  }
  EXPECT_GT(seen, 2000);
}

TEST(PivotCandidates, ARowThatIsNegativeAndDoesNotMoveLeavesNone) {
  EXPECT_EQ(found({VectorXd{{0, 1, 2}}, VectorXd{{-1, -1, 0}}}).size(), 1U);
  EXPECT_TRUE(found({VectorXd{{0, 1, -2}}, VectorXd{{-1, -1, 0}}}).empty());
}

TEST(PivotCandidates, ManyThatTieAtZeroCostNothing) {
  const std::vector<PivotCandidate> tied = found({VectorXd::Zero(9), VectorXd::Constant(9, -1)});
  ASSERT_EQ(tied.size(), 9U);
  for (const PivotCandidate& candidate : tied) EXPECT_EQ(candidate.cost, 0);
}

TEST(Pricing, ItsShortSeriesIsExpm1) {
  const Pricing fine{.epsilon = 1, .grid = 1e-15};
  for (const double q_min : {-9e-9, -1e-12, 0.0, 3e-10, 9e-9})
    EXPECT_EQ(fine.cost(q_min), std::llround(std::expm1(-q_min) / 1e-15)) << q_min;
}

}  // namespace
}  // namespace lcp
