#include "harness/studies/frontier/share_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lcp {
namespace {

/// Cells at 0, 1, 2, ... of so many draws each.
std::vector<SharePoint> column(const std::vector<Index>& solved, Index counted = 8) {
  std::vector<SharePoint> points;
  for (const Index k : solved) points.push_back({static_cast<double>(points.size()), k, counted});
  return points;
}

using Kind = ShareLine::Kind;

TEST(WilsonInterval, IsThatOfNewcombesTable) {
  // R. G. Newcombe 1998, table I, method 3.
  const struct {
    Index solved, counted;
    double low, high;
  } published[] = {{81, 263, 0.2553, 0.3662},
                   {15, 148, 0.0624, 0.1605},
                   {0, 20, 0, 0.1611},
                   {1, 29, 0.0061, 0.1718}};
  for (const auto& each : published) {
    const Interval interval = wilson_interval(each.solved, each.counted);
    EXPECT_NEAR(interval.low, each.low, 5e-5);
    EXPECT_NEAR(interval.high, each.high, 5e-5);
  }
}

TEST(WilsonInterval, IsSymmetricAndTheWholeRangeWithoutDraws) {
  for (const Index k : {0, 3, 8}) {
    EXPECT_NEAR(wilson_interval(k, 8).low, 1 - wilson_interval(8 - k, 8).high, 1e-15);
  }
  EXPECT_EQ(wilson_interval(0, 0).low, 0);
  EXPECT_EQ(wilson_interval(0, 0).high, 1);
  EXPECT_EQ(wilson_interval(8, 8).high, 1);
}

TEST(SideOf, IsDecidedWhereTheIntervalLeavesOutAHalf) {
  EXPECT_EQ(side_of({0, 7, 8}), ShareSide::above);  // from 0.529
  EXPECT_EQ(side_of({0, 6, 8}), ShareSide::open);   // from 0.409
  EXPECT_EQ(side_of({0, 2, 8}), ShareSide::open);
  EXPECT_EQ(side_of({0, 1, 8}), ShareSide::below);
  EXPECT_EQ(side_of({0, 0, 0}), ShareSide::open);
}

TEST(MonotoneFit, PoolsViolatorsWeightedByTheirDraws) {
  EXPECT_EQ(monotone_fit(column({8, 2, 4, 0}), false), (std::vector<double>{1, 0.375, 0.375, 0}));
  EXPECT_EQ(monotone_fit(column({8, 6, 2}), false), (std::vector<double>{1, 0.75, 0.25}));
  EXPECT_EQ(monotone_fit(column({0, 8, 4}), true), (std::vector<double>{0, 0.75, 0.75}));
  // 2 of 4, then 12 of 16: 14 of 20. A later cell pulls the block below the one before it.
  EXPECT_EQ(monotone_fit({{0, 2, 4}, {1, 12, 16}}, false), (std::vector<double>{0.7, 0.7}));
  EXPECT_EQ(monotone_fit(column({6, 4, 8}), false), (std::vector<double>{0.75, 0.75, 0.75}));
}

TEST(FindLine, InterpolatesTheCrossingAndItsBand) {
  const ShareLine line = find_line(column({8, 0}));
  EXPECT_EQ(line.kind, Kind::crossing);
  EXPECT_FALSE(line.rising);
  EXPECT_DOUBLE_EQ(line.u, 0.5);
  EXPECT_EQ(line.step, 1);
  // Lower curve from 8 / (8 + z^2) = 0.67559 to 0, upper from 1 to 0.32441.
  EXPECT_NEAR(line.low, 0.17559 / 0.67559, 1e-4);
  EXPECT_NEAR(line.high, 0.5 / 0.67559, 1e-4);
}

TEST(FindLine, InterpolatesTheFit) {
  // 2 of 8 and 4 of 8 are pooled to 0.375: from 1 to it, a half is at 0.5 / 0.625.
  EXPECT_DOUBLE_EQ(find_line(column({8, 2, 4, 0})).u, 0.8);
}

TEST(FindLine, RisingIsFallingSeenFromTheOtherEnd) {
  const ShareLine falling = find_line(column({8, 7, 3, 0})),
                  rising = find_line(column({0, 3, 7, 8}));
  EXPECT_TRUE(rising.rising);
  EXPECT_DOUBLE_EQ(rising.u, 3 - falling.u);
  EXPECT_DOUBLE_EQ(rising.low, 3 - falling.high);
  EXPECT_DOUBLE_EQ(rising.high, 3 - falling.low);
}

TEST(FindLine, TakesTheMiddleOfAStretchAtAHalf) {
  EXPECT_DOUBLE_EQ(find_line(column({8, 4, 4, 0})).u, 1.5);
  EXPECT_DOUBLE_EQ(find_line(column({8, 4, 0})).u, 1);
}

TEST(FindLine, HasABandThatIsOpenWhereTheLastCellIs) {
  const ShareLine line = find_line(column({8, 3}));
  EXPECT_EQ(line.kind, Kind::crossing);
  EXPECT_DOUBLE_EQ(line.u, 0.8);
  EXPECT_GT(line.low, 0);
  EXPECT_EQ(line.high, INFINITY);
}

TEST(FindLine, NamesAColumnWithoutALine) {
  EXPECT_EQ(find_line(column({8, 7, 8})).kind, Kind::above);
  EXPECT_EQ(find_line(column({0, 1, 0})).kind, Kind::below);
  EXPECT_EQ(find_line(column({8, 4})).kind, Kind::above) << "a half is not less than a half";
  EXPECT_EQ(find_line({{0, 0, 0}, {1, 0, 0}}).kind, Kind::nothing);
  EXPECT_EQ(find_line({}).kind, Kind::nothing);
}

TEST(FindLine, LeavesOutCellsWithoutCountedDraws) {
  const ShareLine line = find_line({{0, 8, 8}, {1, 0, 0}, {2, 0, 8}});
  EXPECT_EQ(line.kind, Kind::crossing);
  EXPECT_DOUBLE_EQ(line.u, 1);
}

TEST(FindLine, NamesEveryCrossingOfAShareThatIsNotMonotone) {
  const ShareLine line = find_line(column({8, 0, 4, 8, 0}));
  EXPECT_EQ(line.kind, Kind::several);
  EXPECT_EQ(line.crossings, (std::vector<double>{0.5, 2, 3.5}));
}

TEST(FindLine, TakesADipThatNoiseExplainsForNoCrossing) {
  const ShareLine line = find_line(column({8, 3, 8, 0}));
  EXPECT_EQ(line.kind, Kind::crossing);
  EXPECT_DOUBLE_EQ(line.u, 2.5);
}

TEST(FindLine, DoesNotLetAnOpenCellOutvoteADecidedOne) {
  // Pooled with its neighbour, 41 of 100 would draw the fit below a half from the first cell on.
  const ShareLine line = find_line({{0, 41, 100}, {1, 8, 8}, {2, 0, 8}});
  EXPECT_EQ(line.kind, Kind::crossing);
  EXPECT_DOUBLE_EQ(line.u, 1.5);
}

TEST(FindLine, PutsTheLineInsideItsBandWhateverTheCounts) {
  for (Index a = 0; a <= 4; ++a)
    for (Index b = 0; b <= 12; b += 3)
      for (Index c = 0; c <= 8; ++c)
        for (Index d = 0; d <= 4; ++d) {
          const ShareLine line = find_line({{0, a, 4}, {1, b, 12}, {3, c, 8}, {4, d, 4}});
          if (line.kind != Kind::crossing) continue;
          EXPECT_LE(line.low, line.u);
          EXPECT_LE(line.u, line.high);
          EXPECT_GE(line.u, 0);
          EXPECT_LE(line.u, 4);
          EXPECT_GT(line.step, 0);
        }
}

TEST(MoreWanted, AsksForTheOpenCellsUntilTheBandIsNarrow) {
  const std::vector<SharePoint> wide = column({8, 5, 3, 0});
  const ShareLine line = find_line(wide);
  EXPECT_GT(line.high - line.low, 1);
  EXPECT_FALSE(settled(line, wide, 0));
  EXPECT_EQ(more_wanted(line, wide, 0), (std::vector<bool>{false, true, true, false}));
  EXPECT_TRUE(settled(line, wide, 3));
  EXPECT_EQ(more_wanted(line, wide, 3), std::vector<bool>(4, false));
}

TEST(MoreWanted, AsksForTheCellThatContradictsTheFit) {
  const std::vector<SharePoint> dip = column({8, 3, 8, 0});
  const ShareLine line = find_line(dip);
  EXPECT_TRUE(settled(line, dip, 0));
  EXPECT_EQ(more_wanted(line, dip, 0), (std::vector<bool>{false, true, false, false}));
}

TEST(MoreWanted, AsksToConfirmWhatMakesAShareCrossSeveralTimes) {
  // At 99.9 % 8 of 8 reach down to 8 / (8 + z^2) = 0.425, 16 of 16 to 0.596.
  const std::vector<SharePoint> few = column({8, 0, 8});
  EXPECT_EQ(find_line(few).kind, Kind::several);
  EXPECT_FALSE(settled(find_line(few), few, 0));
  EXPECT_EQ(more_wanted(find_line(few), few, 0), std::vector<bool>(3, true));
  const std::vector<SharePoint> many = column({16, 0, 16}, 16);
  EXPECT_TRUE(settled(find_line(many), many, 0));
  EXPECT_EQ(more_wanted(find_line(many), many, 0), std::vector<bool>(3, false));
}

TEST(MoreWanted, AsksForTheOpenCellsWhereThereIsNoLine) {
  const std::vector<SharePoint> points = column({8, 6});
  const ShareLine line = find_line(points);
  EXPECT_EQ(line.kind, Kind::above);
  EXPECT_FALSE(settled(line, points, 0));
  EXPECT_EQ(more_wanted(line, points, 0), (std::vector<bool>{false, true}));
  EXPECT_TRUE(settled(find_line(column({8, 7})), column({8, 7}), 0));
}

bool samples_agree(const std::vector<SharePoint>& a, const std::vector<SharePoint>& b) {
  return agree(find_line(a), a, find_line(b), b);
}

TEST(Agree, WantsBandsThatOverlapInTheSameDirection) {
  EXPECT_TRUE(samples_agree(column({8, 5, 0}), column({8, 3, 0})));
  EXPECT_FALSE(samples_agree(column({8, 0, 0, 0}), column({8, 8, 8, 0})));
  EXPECT_FALSE(samples_agree(column({8, 0}), column({0, 8})));
}

TEST(Agree, LetsOpenCellsBeEither) {
  EXPECT_TRUE(samples_agree(column({8, 3}), column({8, 6}))) << "a line and none, both open";
  EXPECT_FALSE(samples_agree(column({8, 0}), column({8, 8})));
  EXPECT_FALSE(samples_agree(column({8, 8}), column({0, 0})));
  EXPECT_TRUE(samples_agree(column({8, 8}), column({8, 7})));
}

TEST(Agree, CountsCrossings) {
  EXPECT_TRUE(samples_agree(column({8, 0, 8}), column({8, 1, 7})));
  EXPECT_FALSE(samples_agree(column({8, 0, 8, 0}), column({8, 0, 8})));
}

}  // namespace
}  // namespace lcp
