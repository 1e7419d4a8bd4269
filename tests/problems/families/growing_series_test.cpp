#include "problems/families/growing_series.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/problems/io/files.h"

namespace lcp {
namespace {

/// Every entry of M tells its row and column, every q its row.
ClassicLcp numbered(Index n) {
  const VectorXd places = VectorXd::LinSpaced(n, 0, double(n - 1));
  return {.M = MatrixXd::NullaryExpr(n, n, [](Index i, Index j) { return double(1000 * i + j); }),
          .q = places,
          .solution = -places,
          .pivot_limit = 7 * n,
          .source = "numbered"};
}

std::vector<Index> order_of(const Instance& instance) {
  std::vector<Index> order;
  for (const double place : instance.problem.q) order.push_back(static_cast<Index>(place));
  return order;
}

TEST(GrowingSeries, AddsOneRowFromInstanceToInstance) {
  const std::vector<Instance> series =
      growing_series({.n = 3}, 9, {.count = 4, .corpus = "some:n=3"}, numbered);
  ASSERT_EQ(series.size(), 4u);
  for (Index k = 0; k < 4; ++k) {
    const Instance& instance = series[static_cast<std::size_t>(k)];
    EXPECT_EQ(instance.name, "some:n=3/000" + std::to_string(k));
    EXPECT_EQ(instance.problem.M, numbered(3 + k).M);
    EXPECT_EQ(instance.problem.q, numbered(3 + k).q);
    EXPECT_EQ(*instance.known_solution, numbered(3 + k).solution);
    EXPECT_EQ(instance.problem.pivot_limit, 7 * (3 + k));
    EXPECT_EQ(instance.provenance.at("source"), "numbered");
  }
}

TEST(GrowingSeries, PermutingRelabelsTheSameProblem) {
  const std::vector<Instance> series =
      growing_series({.n = 8, .permute = true}, 9, {.count = 2}, numbered);
  for (const Instance& instance : series) {
    const Index n = instance.problem.size();
    const std::vector<Index> p = order_of(instance);
    std::vector<Index> sorted = p;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_NE(p, sorted);
    for (Index i = 0; i < n; ++i) {
      EXPECT_EQ(sorted[i], i);
      EXPECT_EQ((*instance.known_solution)(i), -double(p[i]));
      for (Index j = 0; j < n; ++j) EXPECT_EQ(instance.problem.M(i, j), double(1000 * p[i] + p[j]));
    }
  }
}

TEST(GrowingSeries, SeedDecidesThePermutationAndNothingElse) {
  const auto drawn = [](bool permute, std::uint64_t seed) {
    return growing_series({.n = 8, .permute = permute}, 8, {.count = 1, .seed = seed}, numbered)
        .front();
  };
  EXPECT_EQ(drawn(true, 1).sha256, drawn(true, 1).sha256);
  EXPECT_NE(drawn(true, 1).sha256, drawn(true, 2).sha256);
  EXPECT_EQ(drawn(false, 1).sha256, drawn(false, 2).sha256);
}

TEST(GrowingSeries, RefusesToGrowBeyondItsLargest) {
  EXPECT_EQ(growing_series({.n = 3}, 5, {.count = 3}, numbered).size(), 3u);
  EXPECT_EQ(
      files::message_of<std::invalid_argument>(
          [] { growing_series({.n = 3}, 5, {.count = 4, .corpus = "some"}, numbered); }),
      "some: 4 instances from n=3 on end at n=6: expected at most 5, so fewer or a smaller n");
}

}  // namespace
}  // namespace lcp
