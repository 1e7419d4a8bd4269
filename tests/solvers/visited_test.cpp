#include "solvers/linalg/visited.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace lcp {
namespace {

TEST(BasisKey, FollowedPivotByPivotIsThatOfTheBasis) {
  Labels labels(70, {});
  BasisKey followed(labels, -1);
  std::mt19937 random(1);
  for (int step = 0; step < 500; ++step) {
    const Index row = static_cast<Index>(random() % 70);
    const Variable leaving = labels.basic(row);
    const Variable entering = static_cast<Variable>(random() % 141);
    if (labels.is_basic(entering) || leaving == labels.z0()) continue;
    const Variable next = labels.complement(leaving);
    labels.exchange({row, entering});
    followed.follow(labels, entering, leaving, next);
    const BasisKey afresh(labels, next);
    ASSERT_EQ(followed.hash, afresh.hash) << "step " << step;
    ASSERT_EQ(followed.z_basic, afresh.z_basic);
    ASSERT_EQ(followed.entering, afresh.entering);
  }
}

TEST(Visited, KnowsWhatWasInsertedAndGivesItBack) {
  const Index n = 8;
  Visited visited;
  std::vector<BasisKey> inserted;
  for (unsigned subset = 0; subset < 256; ++subset) {  // past several doublings of the table
    std::vector<Index> alpha;
    for (Index i = 0; i < n; ++i)
      if (subset >> i & 1) alpha.push_back(i);
    for (const Variable entering : {0, 3}) inserted.emplace_back(Labels(n, alpha), entering);
  }
  for (const BasisKey& key : inserted) EXPECT_TRUE(visited.insert(key));
  for (const BasisKey& key : inserted) EXPECT_FALSE(visited.insert(key));
  ASSERT_EQ(visited.size(), 512);
  BasisKey copy = inserted[0];
  for (Index number = 0; number < 512; ++number) {
    visited.copy_key(number, copy);
    EXPECT_EQ(copy.z_basic, inserted[number].z_basic);
    EXPECT_EQ(copy.entering, inserted[number].entering);
    EXPECT_EQ(copy.hash, inserted[number].hash);
  }
}

TEST(Visited, OfEqualHashesTellsTheBasesApart) {
  BasisKey one(Labels(4, {0}), 1), other(Labels(4, {2}), 1);
  other.hash = one.hash;
  Visited visited;
  EXPECT_TRUE(visited.insert(one));
  EXPECT_TRUE(visited.insert(other));
  EXPECT_FALSE(visited.insert(one));
  EXPECT_FALSE(visited.insert(other));
}

}  // namespace
}  // namespace lcp
