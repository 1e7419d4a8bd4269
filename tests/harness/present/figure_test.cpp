#include "harness/present/figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>

#include "problems/io/errors.h"
#include "problems/io/text/read_text.h"
#include "solvers/registry.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

std::size_t how_often(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// A series of every kind, in two panels of one page.
Figure one_of_every_kind() {
  using Kind = Series::Kind;
  const Look a = look_at(0), b = look_at(1), c = look_at(2);
  Figure figure{.title = "Every kind of series",
                .caption = "A caption that says what is seen: " + std::string(200, 'x') + " end.",
                .width = 700,
                .height = 360};
  Panel chart{.area = {70, 260, 60, 220}, .title = "chart", .x = {.label = "cost (ms)"}};
  chart.x = {.label = "cost (ms)", .low = 0.1, .high = 100, .scale = Axis::Scale::log};
  chart.y = {.label = "residual", .low = 1e-12, .high = 1, .scale = Axis::Scale::log};
  chart.series = {
      {.kind = Kind::line,
       .marks = {{.x = 0.2, .y = 1e-3, .look = a},
                 {.x = 2, .y = 1e-3},
                 {},
                 {.x = 2, .y = 1e-9},
                 {.x = 50, .y = 1e-9}},
       .size = 2},
      {.kind = Kind::points,
       .marks = {{.x = 1, .y = 1e-4, .x_low = 0.5, .x_high = 3, .look = a},
                 {.x = 4, .y = 1e-6, .y_low = 1e-7, .y_high = 1e-4, .look = b, .filled = false},
                 {.x = NAN, .y = 1e-6, .look = c}}},
      {.kind = Kind::text,
       .marks = {{.x = 1, .y = 1e-2, .text = "left", .look = {black}}},
       .align = Series::Align::left}};
  Panel bars{.area = {440, 220, 60, 220}, .title = "bars"};
  bars.x = {.label = "share", .low = 0, .high = 10};
  bars.y = {.low = 3, .high = -0.5, .ticks = {{0, "first"}, {1, "second"}, {2, "third"}}};
  bars.series = {{.kind = Kind::boxes,
                  .marks = {{.x_low = 0, .x_high = 6, .y_low = -0.3, .y_high = 0.3, .look = a},
                            {.x_low = 2, .x_high = 9, .y_low = 0.7, .y_high = 1.3, .look = b}},
                  .opacity = 0.5},
                 {.kind = Kind::area,
                  .marks = {{.x = 1, .y = 1.7, .look = c},
                            {.x = 5, .y = 1.7, .look = c},
                            {.x = 3, .y = 2.4, .look = c},
                            {},
                            {.x = 6, .y = 1.7, .look = b},
                            {.x = 9, .y = 1.7, .look = b},
                            {.x = 8, .y = 2.4, .look = b}}}};
  figure.panels = {chart, bars};
  figure.legend = {{.name = "solver a", .look = a, .line = true},
                   {.name = "solver b", .look = b, .filled = false}};
  figure.legend_area = {70, 600, 28, 20};
  return figure;
}

class Figures : public testing::Test {
 protected:
  std::string drawn(const Figure& figure) {
    draw_figure(directory_.file("f.svg"), figure);
    const std::string svg = text("f.svg");
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    return svg;
  }
  std::string text(const char* name) {
    return read_text(directory_.file(name), "a figure", 1 << 22);
  }
  TemporaryDirectory directory_;
};

TEST_F(Figures, DrawEveryKindOfSeries) {
  const std::string svg = drawn(one_of_every_kind());
  for (const char* words :
       {"Every kind of series", "chart", "bars", "cost (ms)", "residual", "first", "third",
        "solver a", "solver b", "left", "A caption that says", "end."})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  EXPECT_GT(how_often(svg, "<path"), 10u);
  const std::string data = text("f.dat");
  EXPECT_NE(data.find("2 0.001\n\n2 1e-09"), std::string::npos)
      << "a line breaks where a mark is empty";
  EXPECT_EQ(data.find("nan"), data.npos) << "what has no place is not drawn\n" << data;
}

TEST_F(Figures, OfNothingAreAnEmptyPage) {
  EXPECT_NE(drawn({.title = "nothing here", .panels = {Panel{.area = {50, 100, 50, 100}}}})
                .find("nothing here"),
            std::string::npos);
  Figure empty = one_of_every_kind();
  for (Panel& panel : empty.panels)
    for (Series& series : panel.series) series.marks = {{}, {}};
  drawn(empty);
}

TEST_F(Figures, ReadNoNameAsACommand) {
  const std::string file = directory_.file("made"),
                    hostile = "`touch " + file + "`\n'\"! touch " + file;
  Figure figure = one_of_every_kind();
  figure.title = figure.caption = figure.legend[0].name = hostile;
  for (Panel& panel : figure.panels) {
    panel.title = panel.x.label = panel.y.label = hostile;
    panel.x.ticks = {{1, hostile}};
    for (Series& series : panel.series)
      for (Mark& mark : series.marks) mark.text = hostile;
  }
  drawn(figure);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(Figures, ShowNamesAsTheyAreSpelled) {
  Figure figure = one_of_every_kind();
  figure.title = "a_b^c {d} @e & <f> 5%";
  figure.legend[0].name = "row:eps_x=1e-9";
  figure.panels[0].series[2].marks[0].text = "t_1\\n";
  const std::string svg = drawn(figure);
  for (const char* words : {"a_b^c {d} @e &amp; &lt;f", "row:eps_x=1e-9", "t_1"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
}

TEST_F(Figures, SayWhatIsMissingAndLeaveTheOldPicture) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", directory_.path().c_str(), 1);
  EXPECT_THROW(draw_figure(directory_.file("f.svg"), one_of_every_kind()), UnwritableOutput);
  setenv("PATH", path.c_str(), 1);
  EXPECT_FALSE(std::filesystem::exists(directory_.file("f.svg")));
  EXPECT_TRUE(std::filesystem::exists(directory_.file("f.gp")));
}

TEST(FigureJson, HoldsWhatIsDrawn) {
  const Figure figure = one_of_every_kind();
  const nlohmann::ordered_json json = to_json(figure);
  EXPECT_EQ(json.at("title"), figure.title);
  ASSERT_EQ(json.at("panels").size(), 2u);
  const auto& chart = json["panels"][0];
  EXPECT_EQ(chart.at("x").at("log"), true);
  EXPECT_EQ(chart.at("area"), (nlohmann::json{70, 260, 60, 220}));
  const auto& line = chart.at("series")[0];
  EXPECT_EQ(line.at("kind"), "line");
  EXPECT_EQ(line.at("marks")[0].at("x"), 0.2);
  EXPECT_FALSE(line.at("marks")[2].contains("x")) << "what is NaN is left out";
  EXPECT_EQ(chart.at("series")[1].at("marks")[1].at("filled"), false);
  EXPECT_EQ(chart.at("series")[1].at("marks")[0].at("look").at("colour"), "#0072b2");
  EXPECT_EQ(json.at("panels")[1].at("y").at("ticks")[1], (nlohmann::json{1, "second"}));
  EXPECT_EQ(json.at("legend")[0].at("name"), "solver a");
  EXPECT_EQ(nlohmann::json::parse(json.dump()), nlohmann::json(json)) << "is JSON";
}

bool same(const Look& a, const Look& b) {
  return a.colour == b.colour && a.marker == b.marker && a.dash == b.dash;
}

TEST(Looks, AreThoseOfTheRowWhateverElseIsShown) {
  std::set<std::tuple<Colour, int, int>> looks;
  for (const Row& row : registry()) {
    const Look look = look_of_solver(row.info.name);
    EXPECT_TRUE(same(look, look_of_solver(row.info.name)));
    EXPECT_TRUE(looks.insert({look.colour, look.marker, look.dash}).second) << row.info.name;
  }
  EXPECT_TRUE(same(look_of_solver("no row of this name"), look_of_solver("nor this")));
}

TEST(RoundTicks, AreAtOneTwoAndFive) {
  const auto places = [](double low, double high, std::size_t most, Axis::Scale scale) {
    std::vector<double> at;
    for (const Tick& tick : round_ticks(low, high, most, scale)) at.push_back(tick.at);
    return at;
  };
  EXPECT_EQ(places(0, 4, 4, Axis::Scale::linear), (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(places(0, 90, 5, Axis::Scale::linear), (std::vector<double>{0, 20, 40, 60, 80}));
  EXPECT_EQ(places(0.9, 12, 9, Axis::Scale::log), (std::vector<double>{1, 2, 5, 10}));
  EXPECT_EQ(round_ticks(0.9, 12, 9, Axis::Scale::log).back().label, "10");
  EXPECT_LE(round_ticks(1, 9e5, 6, Axis::Scale::log).size(), 6u);
}

TEST(PanelGrids, HoldTheirPlotsInReadingOrderWithoutOverlap) {
  const PanelGrid grid{.abreast = 2, .width = 100, .height = 50};
  const PageArea first = grid.area(0), second = grid.area(1), third = grid.area(2);
  EXPECT_GT(second.left, first.left + first.width);
  EXPECT_EQ(third.left, first.left);
  EXPECT_GT(third.top, first.top + first.height);
  EXPECT_GE(grid.page_width(3), second.left + second.width);
  EXPECT_GE(grid.page_height(3), third.top + third.height);
  EXPECT_LT(grid.page_width(1), grid.page_width(2));
}

}  // namespace
}  // namespace lcp
