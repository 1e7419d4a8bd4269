#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace lcp {

/// A value of a table: a number, a text, yes or no; null where there is none.
using Cell = nlohmann::ordered_json;

/// A column, whatever its rows are: named once for a terminal, CSV, JSON and LaTeX.
struct ColumnHead {
  std::string key = {};      ///< In CSV and JSON; empty: for readers alone.
  std::string heading = {};  ///< In a terminal; empty: for programs alone.
  std::string meaning = {};  ///< What legend() says of it; empty: it speaks for itself.
  /// Format of a number for a reader (fmt). A 0 is always printed as 0.
  std::string number = "{:.0f}";
  double scale = 1;          ///< What a reader sees is the value times this.
  std::string latex = {};    ///< Heading in LaTeX; empty: the terminal's, or else the key.
  std::string exact = "{}";  ///< Format of a number in CSV: the shortest that reads back.
  bool right = false;        ///< Text stands on the right, as numbers do.
  bool only_if_any = false;  ///< A terminal shows it only where a row has a value other than 0.
};

/// A column of rows of one kind with the value that it shows of each.
template <class Row>
struct Column : ColumnHead {
  std::function<Cell(const Row&)> value = {};
};

/// A table of cells: what every format is written from.
struct CellTable {
  std::vector<ColumnHead> heads;
  std::vector<std::vector<Cell>> rows;  ///< Each as long as `heads`.
};

template <class Row, class Rows>
CellTable cells_of(const std::vector<Column<Row>>& columns, const Rows& rows) {
  CellTable table{{columns.begin(), columns.end()}, {}};
  for (const Row& row : rows) {
    table.rows.emplace_back();
    for (const Column<Row>& column : columns) table.rows.back().push_back(column.value(row));
  }
  return table;
}

/// The row as an object, by the keys of its columns; with the keys of `object` before them.
template <class Row>
nlohmann::ordered_json json_object(
    const std::vector<Column<Row>>& columns, const Row& row,
    nlohmann::ordered_json object = nlohmann::ordered_json::object()) {
  for (const Column<Row>& column : columns)
    if (!column.key.empty()) object[column.key] = column.value(row);
  return object;
}

/// An optional value as a cell; what is not finite is null, since JSON has no such numbers.
Cell cell_of(const std::optional<double>& value);

/// A cell as a reader sees it: `empty` for null.
std::string printed(const ColumnHead& head, const Cell& cell, const std::string& empty = "-");

/// The columns with a key, a line per row below a line of keys. Yes and no are 1 and 0.
std::string csv_text(const CellTable& table);
/// The lines of csv_text alone.
std::string csv_head(const std::vector<ColumnHead>& heads);
std::string csv_rows(const CellTable& table);

/// How a terminal shows a table.
struct TextStyle {
  std::string indent = {};  ///< Before every line.
  std::size_t width = 100;  ///< Letters of a line at most; what does not fit is folded.
  std::size_t widest = 44;  ///< A longer first cell stands on a line of its own.
  std::string empty = "-";  ///< For null.
  std::size_t names = 1;    ///< Leading columns that together name a row.
};

/// The columns with a heading, each as wide as its widest cell; the first is the name of the row and
/// stands on the left, numbers on the right, text on the left. Where a line would be longer than the
/// style's width, the columns that do not fit follow as another block with the names repeated.
std::string text_table(const CellTable& table, const TextStyle& style = {});

/// A line for each column that text_table shows and that has a meaning: `  heading  meaning`, broken at
/// `width` letters.
std::string legend(const CellTable& table, std::size_t width = 100);

/// A tabular with a line per column of the table and a column per row, as the paper's tables stand:
/// `heads` are those of its columns, null cells are printed as `--`.
std::string latex_tabular(const CellTable& table, const std::vector<std::string>& heads);

/// `text` in lines of at most `width` letters, broken between words; each further line is indented by
/// `hanging` letters. Ends with a line end.
std::string folded(const std::string& text, std::size_t width = 100, std::size_t hanging = 0);

}  // namespace lcp
