#include "problems/drawing/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lcp {
namespace {

TEST(Random, GivesTheNumbersOfTheStandardGenerator) {
  // The C++ standard states the 10000th number that mt19937_64 gives from its default seed 5489.
  Random random(5489);
  for (int i = 1; i < 10000; ++i) random.integer(0, 1);
  EXPECT_EQ(random.integer(0, 999'999'999'999), 9981545732273789042U % 1'000'000'000'000U);
}

TEST(Random, StaysWithinItsBoundsAndReachesThem) {
  Random random(1);
  std::vector<int> seen(5, 0);
  double least = 1, largest = -1;
  for (int i = 0; i < 1000; ++i) {
    ++seen.at(static_cast<std::size_t>(random.integer(-2, 2) + 2));
    const double x = random.between(-1, 0.5);
    least = std::min(least, x);
    largest = std::max(largest, x);
  }
  // 200 expected of each; 5 standard deviations are 63.
  for (const int times : seen) EXPECT_NEAR(times, 200, 63);
  EXPECT_GE(least, -1);
  EXPECT_LT(least, -0.98);
  EXPECT_LT(largest, 0.5);
  EXPECT_GT(largest, 0.48);
}

TEST(Random, PermutationHoldsEveryNumberOnceAndAllOrdersComeUp) {
  Random random(1);
  std::vector<std::vector<Index>> orders;
  for (int i = 0; i < 200; ++i) orders.push_back(random.permutation(3));
  std::sort(orders.begin(), orders.end());
  orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
  EXPECT_EQ(orders.size(), 6u);
  EXPECT_EQ(orders.front(), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(orders.back(), (std::vector<Index>{2, 1, 0}));
}

}  // namespace
}  // namespace lcp
