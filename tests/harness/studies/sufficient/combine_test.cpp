#include "harness/studies/sufficient/combine.h"

#include <gtest/gtest.h>

#include <vector>

namespace lcp {
namespace {

constexpr double kNoise = 0.05;

/// Answers for combinations of three axes, and what was asked.
struct Models {
  std::vector<SingleRung> singles;
  std::function<Worth(const Rungs&)> worth;
  std::vector<Rungs> asked = {};

  std::vector<Rungs> tried() {
    combine(3, singles, kNoise, [this](const Rungs& rungs) {
      asked.push_back(rungs);
      return worth(rungs);
    });
    return asked;
  }
};

SingleRung passing(std::size_t axis, std::size_t rung, double saved) {
  return {axis, rung, {true, saved}};
}

/// What is left of the time is the product of what single rungs leave of it.
double saved_together(const std::vector<SingleRung>& singles, const Rungs& rungs) {
  double left = 1;
  for (const SingleRung& single : singles)
    if (rungs[single.axis] == single.rung) left *= 1 - single.worth.saved;
  return 1 - left;
}

TEST(Combine, TakesTheBestOfEveryAxisTogetherAndIsDoneWhereItPasses) {
  const std::vector<SingleRung> singles = {passing(0, 1, 0.2), passing(0, 2, 0.4),
                                           passing(1, 1, 0.3), passing(2, 1, 0.1)};
  Models models{singles, [&](const Rungs& r) { return Worth{true, saved_together(singles, r)}; }};
  EXPECT_EQ(models.tried(), (std::vector<Rungs>{{2, 1, 1}}));
}

TEST(Combine, TriesARicherRungBeforeItLeavesAnAxisOut) {
  const std::vector<SingleRung> singles = {passing(0, 1, 0.5), passing(1, 1, 0.3),
                                           passing(1, 2, 0.4), passing(2, 1, 0.2)};
  Models models{singles, [&](const Rungs& r) {
                  return Worth{r[1] != 2, saved_together(singles, r)};  // The roughest fails.
                }};
  EXPECT_EQ(models.tried(), (std::vector<Rungs>{{1, 2, 1}, {1, 2, 0}, {1, 1, 0}, {1, 1, 1}}));
}

TEST(Combine, DoesNotKeepWhatSavesNothingBesideTheRest) {
  const std::vector<SingleRung> singles = {passing(0, 1, 0.5), passing(1, 1, 0.3),
                                           passing(2, 1, 0.2)};
  Models models{singles, [&](const Rungs& r) {
                  return Worth{r != Rungs{1, 1, 1}, r[2] == 1 ? 0.6 : 0.51};
                }};
  // 0.51 after 0.5 is within the noise.
  EXPECT_EQ(models.tried(), (std::vector<Rungs>{{1, 1, 1}, {1, 1, 0}, {1, 0, 1}}));
}

TEST(Combine, ARungThatAloneSavesNothingMaySaveBesideOthers) {
  const std::vector<SingleRung> singles = {passing(0, 1, 0.5), passing(1, 1, -0.04),
                                           passing(2, 1, -0.06)};
  Models models{singles, [&](const Rungs&) { return Worth{true, 0.7}; }};
  EXPECT_EQ(models.tried(), (std::vector<Rungs>{{1, 1, 0}})) << "-0.06 is beyond the noise";
}

TEST(Combine, WhatFailsAloneIsNotTried) {
  const auto none = [](const Rungs&) { return Worth{}; };
  EXPECT_TRUE((Models{{}, none}.tried().empty()));
  EXPECT_TRUE((Models{{{0, 1, {false, 0.9}}, {1, 1, {false, 0.5}}}, none}.tried().empty()));
  EXPECT_TRUE((Models{{passing(0, 1, 0.4), {1, 1, {false, 0.5}}}, none}.tried().empty()));
  EXPECT_TRUE((Models{{passing(0, 1, 0.4), passing(0, 2, 0.5)}, none}.tried().empty()));
}

}  // namespace
}  // namespace lcp
