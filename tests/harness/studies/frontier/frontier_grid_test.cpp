#include "harness/studies/frontier/frontier_grid.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "problems/registry.h"

namespace lcp {
namespace {

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

void expect_axis_refused(const std::string& text, const std::string& why) {
  const std::string said = refusal([&] { parse_axis(text, "--x"); });
  EXPECT_NE(said.find("--x " + text), std::string::npos) << said;
  EXPECT_NE(said.find(why), std::string::npos) << said;
}

TEST(KnobAxis, IsAListOfValues) {
  const KnobAxis axis = parse_axis("contacts=4,8,16", "--x");
  EXPECT_EQ(axis.knob, "contacts");
  EXPECT_EQ(axis.values, (std::vector<double>{4, 8, 16}));
  EXPECT_FALSE(axis.geometric);
  EXPECT_EQ(axis.position(1), 8);
  EXPECT_EQ(to_string(axis), "contacts=4,8,16");
}

TEST(KnobAxis, IsARangeRoundedToThreeDigits) {
  EXPECT_EQ(parse_axis("mu=0..1/4", "--x").values, (std::vector<double>{0, 0.333, 0.667, 1}));
  const KnobAxis axis = parse_axis("mass_ratio=1..1000/7,log", "--x");
  EXPECT_EQ(axis.values, (std::vector<double>{1, 3.16, 10, 31.6, 100, 316, 1000}));
  EXPECT_TRUE(axis.geometric);
  EXPECT_DOUBLE_EQ(axis.position(2), 1);
  EXPECT_DOUBLE_EQ(axis.value_at(2), 100);
  EXPECT_EQ(parse_axis(to_string(axis), "--x").values, axis.values);
}

TEST(KnobAxis, RefusesWhatIsNone) {
  expect_axis_refused("n", "no knob with values");
  expect_axis_refused("=1,2", "no knob with values");
  expect_axis_refused("n=3", "one value makes no axis");
  expect_axis_refused("n=log", "one value makes no axis");
  expect_axis_refused("n=3,x", "'x' is no number");
  expect_axis_refused("n=3,,4", "'' is no number");
  expect_axis_refused("n=3,inf", "'inf' is no number");
  expect_axis_refused("n=4,3", "values must ascend");
  expect_axis_refused("n=3,3", "values must ascend");
  expect_axis_refused("n=0,3,log", "log takes positive values");
  expect_axis_refused("n=0..3/4,log", "log takes positive values");
  expect_axis_refused("n=1..3", "does not say how many values");
  expect_axis_refused("n=1..3/1", "an integer in [2, 1000]");
  expect_axis_refused("n=1..3/2.5", "an integer in [2, 1000]");
}

TEST(CheckKnobs, WantsTwoKnobsOfTheFamilyThatItsSpellingLeavesOpen) {
  const auto refused = [](const std::string& family, const char* x, const char* y) {
    return refusal([&] { check_knobs({family, parse_axis(x, "--x"), parse_axis(y, "--y")}); });
  };
  EXPECT_EQ(refused("fathi", "variant=1,2", "n=3,4"), "accepted");
  EXPECT_NE(refused("fathy", "variant=1,2", "n=3,4").find("unknown family 'fathy', known are: "),
            std::string::npos);
  EXPECT_NE(
      refused("fathi", "variant=1,2", "m=3,4").find("fathi has no knob 'm', it has: variant, n"),
      std::string::npos);
  EXPECT_NE(refused("fathi", "n=3,5", "n=3,4").find("both 'n'"), std::string::npos);
  EXPECT_NE(refused("fathi:n=3", "variant=1,2", "n=3,4").find("both an axis and set"),
            std::string::npos);
}

TEST(DrawOfCell, IsTheFirstInstanceOfItsSeedAndSaysSo) {
  const FrontierGrid grid{"semidefinite:n=6", parse_axis("degenerate=0,1", "--x"),
                          parse_axis("condition=1,10,log", "--y")};
  EXPECT_EQ(cell_spelling(grid, 1, 0), "semidefinite:n=6,degenerate=1,condition=1");
  const Instance drawn = draw_of_cell(grid, 1, 1, 3, 7);
  EXPECT_EQ(drawn.name, "semidefinite:n=6,condition=10,degenerate=1/3007");
  EXPECT_EQ(draw_number(drawn.name), 7);
  EXPECT_FALSE(draw_number("semidefinite/7a").has_value());
  const Instance again =
      generate("semidefinite:n=6,degenerate=1,condition=10", {.count = 1, .seed = 3007}).at(0);
  EXPECT_EQ(drawn.sha256, again.sha256);
  EXPECT_NE(drawn.sha256, draw_of_cell(grid, 1, 1, 3, 8).sha256);
  EXPECT_THROW(draw_of_cell(grid, 0, 0, 1, most_draws), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
