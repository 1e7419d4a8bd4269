#include "harness/studies/shrink/ddmin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace lcp {
namespace {

using Items = std::vector<Index>;

Items first(Index count) {
  Items items(count);
  std::iota(items.begin(), items.end(), Index{0});
  return items;
}

bool holds(const Items& items, Index item) {
  return std::find(items.begin(), items.end(), item) != items.end();
}

TEST(Ddmin, FindsTheOneItemThatMatters) {
  const auto keeps = [](const Items& items) { return holds(items, 37); };
  EXPECT_EQ(ddmin(first(100), keeps), Items{37});
}

TEST(Ddmin, FindsItemsThatMatterTogetherInTheirOrder) {
  const auto keeps = [](const Items& items) {
    return holds(items, 2) && holds(items, 50) && holds(items, 99);
  };
  EXPECT_EQ(ddmin(first(100), keeps), (Items{2, 50, 99}));
}

TEST(Ddmin, KeepsAllWhereEachMatters) {
  const auto keeps = [](const Items& items) { return items.size() == 9; };
  EXPECT_EQ(ddmin(first(9), keeps), first(9));
}

TEST(Ddmin, NeverAsksAboutNothing) {
  const auto keeps = [](const Items& items) {
    EXPECT_FALSE(items.empty());
    return true;
  };
  EXPECT_EQ(ddmin(first(5), keeps).size(), 1u);
  EXPECT_EQ(ddmin({}, keeps), Items{});
}

/// Whatever the test is, even one that is not monotone: no single item more can go.
TEST(Ddmin, EndsWhereNoSingleItemCanGo) {
  for (const Index modulus : {2, 3, 5, 7}) {
    const auto keeps = [modulus](const Items& items) {
      const Index sum = std::accumulate(items.begin(), items.end(), Index{0});
      return holds(items, 4) && sum % modulus == 1 % modulus;
    };
    Items all = first(17);
    while (!keeps(all)) all.pop_back();
    const Items left = ddmin(all, keeps);
    EXPECT_TRUE(keeps(left));
    for (std::size_t k = 0; k < left.size() && left.size() > 1; ++k) {
      Items fewer = left;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_FALSE(keeps(fewer)) << "without " << left[k] << " modulo " << modulus;
    }
  }
}

}  // namespace
}  // namespace lcp
