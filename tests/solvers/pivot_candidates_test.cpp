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

std::vector<PivotCandidate> found(const Column& column, const Pricing& pricing = kPricing) {
  VectorXd ratios;
  std::vector<PivotCandidate> candidates;
  find_candidates(column.q, column.m, blocks, pricing, ratios, candidates);
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

TEST(PivotCandidates, ACleanOneWithALargeRatioHasItsPrice) {
  // Ratios 0.1 and 0.1001, twice. Pivoting on row 0 leaves 0.1 in all three rows, which earns
  // 1 - exp(-0.1) in units of 1e-6; the others leave a 0. Nothing is negative at either ratio.
  const Column column{VectorXd{{1e-9, 100.1, 100.1}}, VectorXd{{-1e-8, -1000, -1000}}};
  const std::vector<PivotCandidate> candidates = found(column);
  ASSERT_EQ(candidates.size(), 3U);
  EXPECT_EQ(candidates[0].cost, std::llround((std::exp(-0.1) - 1) / kPricing.grid));
  EXPECT_EQ(candidates[1].cost, 0);
  EXPECT_EQ(candidates[2].cost, 0);
}

/// Rows 0 and 1, where pivoting on row 0 takes row 1 to -epsilon, give or take a rounding.
Column at_the_limit(double epsilon, unsigned seed) {
  std::mt19937_64 random(seed);
  const double theta = 1 + static_cast<double>(random()) * 0x1p-62;  // all its bits in use
  const double m = -3 - 2 * static_cast<double>(random() % 6);
  const double off = 1 + (static_cast<double>(random() % 5) - 2) * 0x1p-53;
  return {VectorXd{{theta, (-epsilon - m * theta) * off}}, VectorXd{{-1, m}}};
}

TEST(PivotCandidates, StayAboveMinusEpsilonToTheLastBit) {
  // A power of two, so that q' may be -epsilon itself, which is not above it.
  const Pricing pricing{.epsilon = 0x1p-10, .grid = 1e-6};
  Index kept = 0, dropped = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const Column column = at_the_limit(pricing.epsilon, seed);
    const std::vector<PivotCandidate> candidates = found(column, pricing);
    for (const PivotCandidate& candidate : candidates) {
      const Index other = 1 - candidate.row;
      EXPECT_GT(column.q(other) + candidate.ratio * column.m(other), -pricing.epsilon) << seed;
    }
    (candidates.size() == 2 ? kept : dropped) += 1;
  }
  EXPECT_GT(kept, 100);
  EXPECT_GT(dropped, 100);
}

TEST(Pricing, CleanPivotsAreFreeWhereAskedForAndElseEarnWhatTheyLeave) {
  Pricing pricing{.epsilon = kEpsilon, .grid = 1e-6};
  EXPECT_EQ(pricing.cost(0.1), std::llround((std::exp(-0.1) - 1) / 1e-6));
  EXPECT_LT(pricing.cost(0.1), 0);
  const std::int64_t dirty = pricing.cost(-1e-4);
  pricing.clean_is_free = true;
  for (const double clean : {0.1, 1e-9, 0.0, -4e-7}) EXPECT_EQ(pricing.cost(clean), 0) << clean;
  EXPECT_EQ(pricing.cost(-1e-4), dirty);
  EXPECT_EQ(dirty, 100);
}

TEST(Pricing, ItsShortSeriesIsExpm1) {
  const Pricing fine{.epsilon = 1, .grid = 1e-15};
  for (const double q_min : {-9e-9, -1e-12, 0.0, 3e-10, 9e-9})
    EXPECT_EQ(fine.cost(q_min), std::llround(std::expm1(-q_min) / 1e-15)) << q_min;
}

}  // namespace
}  // namespace lcp
