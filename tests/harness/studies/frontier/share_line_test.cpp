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

/// For tests whose columns cross twice, first: where two crossings were taken for one, the cells in
/// question would end before they begin, and this column throws where others may end the program.
void assert_that_two_crossings_are_several() {
  ASSERT_EQ(find_line(column({8, 0, 4, 8})).kind, Kind::several);
  ASSERT_EQ(find_line(column({0, 8, 4, 0})).kind, Kind::several);
}

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

TEST(SideOf, IsDecidedExactlyWhereTheIntervalLeavesOutAHalf) {
  EXPECT_EQ(side_of({0, 6, 7}), ShareSide::open);  // from 0.487
  EXPECT_EQ(side_of({0, 1, 7}), ShareSide::open);  // to 0.513
  for (Index n = 1; n <= 60; ++n)
    for (Index k = 0; k <= n; ++k)
      for (const double quantile : {normal_quantile, confirming_quantile}) {
        const Interval interval = wilson_interval(k, n, quantile);
        const ShareSide side = side_of({0, k, n}, quantile);
        EXPECT_EQ(side == ShareSide::above, interval.low > 0.5) << k << " of " << n;
        EXPECT_EQ(side == ShareSide::below, interval.high < 0.5) << k << " of " << n;
      }
}

TEST(MonotoneFit, IsTheSameWhetherEqualNeighboursArePooledOrNot) {
  // Shares of 1/3 in three cells; then one that pulls all of them along.
  EXPECT_EQ(monotone_fit({{0, 1, 3}, {1, 2, 6}, {2, 3, 9}}, true), std::vector<double>(3, 1.0 / 3));
  EXPECT_EQ(monotone_fit({{0, 1, 3}, {1, 2, 6}, {2, 0, 3}}, true), std::vector<double>(3, 0.25));
  EXPECT_EQ(monotone_fit({{0, 2, 3}, {1, 4, 6}, {2, 3, 3}}, false), std::vector<double>(3, 0.75));
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

TEST(FindLine, TakesTheDirectionThatFitsBetterDrawByDraw) {
  // 0.6 of 20, 0.4 of 20 and 1 of 1, all open. Falling pools the last two to 3/7: 20/21 0.6^2 = 0.34.
  // Rising pools the first two to 1/2: 20 0.1^2 + 20 0.1^2 = 0.4. Cell by cell it were 0.33 and 0.02.
  const ShareLine line = find_line({{0, 12, 20}, {1, 8, 20}, {2, 1, 1}});
  EXPECT_FALSE(line.rising);
  EXPECT_EQ(line.kind, Kind::crossing);
  EXPECT_DOUBLE_EQ(line.u, 0.1 / (0.6 - 3.0 / 7));
}

/// Where the line from v0 at 0 to v1 at 1 is 1/2.
double half_between(double v0, double v1) { return (v0 - 0.5) / (v0 - v1); }

TEST(FindLine, HasABandBetweenBoundsThatOtherCellsTighten) {
  // Falling: cell 2's lower bound holds in cell 1 too, where it is above that cell's own.
  const Interval all = wilson_interval(8, 8), more = wilson_interval(6, 8),
                 half = wilson_interval(4, 8), less = wilson_interval(2, 8),
                 none = wilson_interval(0, 8);
  ASSERT_GT(more.low, half.low);
  const ShareLine lower = find_line(column({8, 4, 6, 0}));
  EXPECT_EQ(lower.kind, Kind::crossing);
  EXPECT_DOUBLE_EQ(lower.low, half_between(all.low, more.low));
  EXPECT_DOUBLE_EQ(lower.high, 2 + half_between(half.high, none.high));
  // And cell 1's upper bound in cell 2.
  const ShareLine upper = find_line(column({8, 2, 4, 0}));
  EXPECT_EQ(upper.kind, Kind::crossing);
  EXPECT_DOUBLE_EQ(upper.low, half_between(all.low, half.low));
  EXPECT_DOUBLE_EQ(upper.high, 2 + half_between(less.high, none.high));
}

TEST(FindLine, HasABandFromTheLesserCrossingToTheGreaterWhereCellsContradict) {
  // 0 of 3, then 50 of 50: what the first bounds from above, the second does from below, so that the
  // upper curve crosses 1/2 before the lower one.
  const Interval few = wilson_interval(0, 3), all = wilson_interval(50, 50),
                 none = wilson_interval(0, 50);
  const double of_upper = 1 + half_between(few.high, none.high),
               of_lower = 1 + half_between(all.low, 0);
  ASSERT_LT(of_upper, of_lower);
  const ShareLine line = find_line({{0, 0, 3}, {1, 50, 50}, {2, 0, 50}});
  EXPECT_EQ(line.kind, Kind::crossing);
  EXPECT_DOUBLE_EQ(line.u, 1.5);
  EXPECT_DOUBLE_EQ(line.low, of_upper);
  EXPECT_DOUBLE_EQ(line.high, 1.5) << "widened to hold the line";
}

TEST(FindLine, AtAGridPointHasTheStepOnTheSideWhereMoreIsSolved) {
  const ShareLine falling = find_line({{0, 8, 8}, {1, 4, 8}, {3, 0, 8}});
  EXPECT_DOUBLE_EQ(falling.u, 1);
  EXPECT_EQ(falling.step, 1);
  const ShareLine rising = find_line({{0, 0, 8}, {1, 4, 8}, {3, 8, 8}});
  EXPECT_DOUBLE_EQ(rising.u, 1);
  EXPECT_EQ(rising.step, 2);
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
  ASSERT_NO_FATAL_FAILURE(assert_that_two_crossings_are_several());
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
  ASSERT_NO_FATAL_FAILURE(assert_that_two_crossings_are_several());
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

TEST(MoreWanted, LetsCellsInsideTheBandContradictTheFit) {
  // 3 and 5 of 8 are pooled to a half, with the line at 1.5: cell 1, to its left, has less than a half.
  const std::vector<SharePoint> points = column({8, 3, 5, 0});
  const ShareLine line = find_line(points);
  ASSERT_DOUBLE_EQ(line.u, 1.5);
  ASSERT_LT(line.low, 1);
  ASSERT_GT(line.high, 2);
  ASSERT_TRUE(settled(line, points, 3));
  EXPECT_EQ(more_wanted(line, points, 3), std::vector<bool>(4, false));
}

TEST(MoreWanted, AsksToConfirmWhatMakesAShareCrossSeveralTimes) {
  ASSERT_NO_FATAL_FAILURE(assert_that_two_crossings_are_several());
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
  ASSERT_NO_FATAL_FAILURE(assert_that_two_crossings_are_several());
  EXPECT_TRUE(samples_agree(column({8, 0, 8}), column({8, 1, 7})));
  EXPECT_FALSE(samples_agree(column({8, 0, 8, 0}), column({8, 0, 8})));
}

}  // namespace
}  // namespace lcp
