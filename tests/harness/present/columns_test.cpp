#include "harness/present/columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lcp {
namespace {

struct Fruit {
  std::string name;
  std::optional<double> weight;
  int count = 0;
  bool ripe = false;
};

std::vector<Column<Fruit>> fruit_columns() {
  return {
      {{.key = "name", .heading = "name"}, [](const Fruit& f) { return Cell(f.name); }},
      {{.key = "kg", .heading = "weight", .meaning = "in grams", .number = "{:.1f}", .scale = 1000},
       [](const Fruit& f) { return cell_of(f.weight); }},
      {{.key = "count", .heading = "n", .meaning = "how many", .only_if_any = true},
       [](const Fruit& f) { return Cell(f.count); }},
      {{.key = "ripe"}, [](const Fruit& f) { return Cell(f.ripe); }},
      {{.heading = "read", .latex = "\\emph{read}"},
       [](const Fruit&) { return Cell("by people"); }},
  };
}

const std::vector<Fruit> basket = {{"apple, red", 0.25, 3, true}, {"a \"fig\"", {}, 0, false}};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(Columns, InCsvAreThoseWithAKeyQuotedWhereItMust) {
  EXPECT_EQ(csv_text(cells_of(fruit_columns(), basket)),
            "name,kg,count,ripe\n\"apple, red\",0.25,3,1\n\"a \"\"fig\"\"\",,0,0\n");
}

TEST(Columns, InCsvHaveNumbersThatReadBack) {
  const std::vector<Column<double>> columns = {
      {{.key = "x"}, [](const double& x) { return Cell(x); }},
      {{.key = "short", .exact = "{:.4g}"}, [](const double& x) { return Cell(x); }}};
  EXPECT_EQ(csv_text(cells_of(columns, std::vector<double>{1.0 / 3, 1e-7})),
            "x,short\n0.3333333333333333,0.3333\n1e-07,1e-07\n");
}

TEST(Columns, InJsonKeepTheirOrderAndNull) {
  EXPECT_EQ(json_object(fruit_columns(), basket[1], {{"first", 1}}).dump(),
            R"({"first":1,"name":"a \"fig\"","kg":null,"count":0,"ripe":false})");
  EXPECT_TRUE(cell_of(INFINITY).is_null());
  EXPECT_TRUE(cell_of(std::nullopt).is_null());
}

TEST(Columns, OnATerminalAreAlignedAndScaled) {
  EXPECT_EQ(text_table(cells_of(fruit_columns(), basket)),
            "name       weight n read\n"
            "apple, red  250.0 3 by people\n"
            "a \"fig\"         - 0 by people\n");
}

TEST(Columns, OfNothingButZeroAreLeftOutWhereTheySaySo) {
  const CellTable table = cells_of(fruit_columns(), std::vector<Fruit>{{"kiwi", 1, 0, false}});
  EXPECT_EQ(text_table(table), "name weight read\nkiwi 1000.0 by people\n");
  EXPECT_EQ(legend(table), "  weight  in grams\n") << "and leave the legend";
}

TEST(Columns, FoldIntoBlocksThatRepeatTheNames) {
  std::vector<Column<int>> columns = {
      {{.heading = "row"}, [](const int& row) { return Cell("row" + std::to_string(row)); }}};
  for (int i = 0; i < 30; ++i)
    columns.push_back({{.heading = "column" + std::to_string(i)},
                       [i](const int& row) { return Cell(100 * row + i); }});
  const std::string text = text_table(cells_of(columns, std::vector<int>{1, 2}));
  const std::vector<std::string> lines = lines_of(text);
  EXPECT_EQ(lines.size(), 9u) << "three blocks\n" << text;
  for (const std::string& line : lines) EXPECT_LE(line.size(), 100u) << line;
  for (std::size_t i = 1; i < lines.size(); i += 3) EXPECT_EQ(lines[i].rfind("row1 ", 0), 0u);
  for (const char* part : {"column0", "column29", " 129", " 229"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(Columns, GiveALongNameALineOfItsOwn) {
  std::vector<Fruit> fruits = basket;
  fruits.push_back({std::string(60, 'x'), 1, 1, false});
  const std::vector<std::string> lines = lines_of(text_table(cells_of(fruit_columns(), fruits)));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[3], std::string(60, 'x'));
  EXPECT_EQ(lines[4], "           1000.0 1 by people");
}

TEST(Columns, CountLettersNotBytes) {
  const std::vector<std::string> lines =
      lines_of(text_table(cells_of(fruit_columns(), std::vector<Fruit>{{"p\xc3\xaa"
                                                                        "che",
                                                                        1, 1, 0},
                                                                       {"plum", 2, 2, 0}})));
  EXPECT_EQ(lines[1],
            "p\xc3\xaa"
            "che 1000.0 1 by people");
  EXPECT_EQ(lines[2], "plum  2000.0 2 by people");
}

TEST(Columns, InLatexAreLinesWithNamesEscaped) {
  EXPECT_EQ(
      latex_tabular(cells_of(fruit_columns(), std::vector<Fruit>{{"50 %", {}, 2, true}}), {"head"}),
      "\\begin{tabular}{l|r}\n & head \\\\ \\hline\nname & 50 \\% \\\\\nweight & -- \\\\\n"
      "n & 2 \\\\\nripe & yes \\\\\n\\emph{read} & by people \\\\\n\\end{tabular}\n");
}

TEST(Columns, PrintZeroAsZeroWhateverTheirFormat) {
  const ColumnHead head{.number = "{:.1e}"};
  EXPECT_EQ(printed(head, Cell(0.0)), "0");
  EXPECT_EQ(printed(head, Cell(0.00012)), "1.2e-04");
  EXPECT_EQ(printed(head, Cell()), "-");
}

TEST(Folding, BreaksBetweenWordsAndHangs) {
  EXPECT_EQ(folded("one two three", 8, 2), "one two\n  three\n");
  EXPECT_EQ(folded("short", 8), "short\n");
  EXPECT_EQ(folded("unbreakable-word-of-many-letters", 8), "unbreakable-word-of-many-letters\n");
  EXPECT_EQ(folded("a unbreakable-word b", 6, 2), "a\n  unbreakable-word\n  b\n");
}

}  // namespace
}  // namespace lcp
