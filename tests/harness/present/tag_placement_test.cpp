#include "harness/present/tag_placement.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lcp {
namespace {

bool apart(Pixels a, Pixels b, Pixels size) {
  return std::abs(a.x - b.x) >= size.x || std::abs(a.y - b.y) >= size.y;
}

TEST(TagPlacement, TagsOfEqualPointsStandApartAndInside) {
  const Pixels area = {300, 200}, tag = {17, 13};
  const std::vector<Pixels> tags =
      place_tags(std::vector<Pixels>(12, Pixels{295, 4}), {}, area, tag);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    EXPECT_GE(tags[i].x, tag.x / 2);
    EXPECT_LE(tags[i].x, area.x - tag.x / 2);
    EXPECT_GE(tags[i].y, tag.y / 2);
    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(apart(tags[i], tags[j], tag)) << i << ' ' << j;
  }
}

TEST(TagPlacement, ALonelyPointHasItsTagNearby) {
  const Pixels tag = place_tags({{100, 100}}, {}, {300, 200}, {17, 13}).front();
  EXPECT_NEAR(std::hypot(tag.x - 100, tag.y - 100), nearest_tag_distance(), 1e-9);
}

}  // namespace
}  // namespace lcp
