#include "harness/present/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/present/escaping.h"

namespace lcp {

namespace {

std::size_t letters(const std::string& text) {  // of UTF-8
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, letters(text)), ' ');
  return right ? space + text : text + space;
}

std::string csv_cell(const ColumnHead& head, const Cell& cell) {
  if (cell.is_null()) return "";
  if (cell.is_string()) return csv_quoted(cell.get<std::string>());
  if (cell.is_boolean()) return cell.get<bool>() ? "1" : "0";
  if (cell.is_number_integer()) return cell.dump();
  if (cell.is_number()) return fmt::format(fmt::runtime(head.exact), cell.get<double>());
  return csv_quoted(cell.dump());
}

bool has_value(const Cell& cell) {
  if (cell.is_number()) return cell.get<double>() != 0;
  return !cell.is_null() && cell != "" && cell != false;
}

/// Places of the columns that a terminal shows.
std::vector<std::size_t> shown(const CellTable& table) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < table.heads.size(); ++i) {
    const ColumnHead& head = table.heads[i];
    const bool any = std::any_of(table.rows.begin(), table.rows.end(),
                                 [i](const auto& row) { return has_value(row[i]); });
    if (!head.heading.empty() && (any || !head.only_if_any)) places.push_back(i);
  }
  return places;
}

/// The cells of a column as text, its heading first.
struct TextColumn {
  std::vector<std::string> cells;
  bool right = false;
  std::size_t width = 0;
};

TextColumn text_column(const CellTable& table, std::size_t place, const TextStyle& style) {
  TextColumn column;
  column.cells.push_back(table.heads[place].heading);
  bool text = false, number = false;
  for (const auto& row : table.rows) {
    column.cells.push_back(printed(table.heads[place], row[place], style.empty));
    text |= row[place].is_string();
    number |= row[place].is_number();
  }
  column.right = table.heads[place].right || number || !text;
  for (const std::string& cell : column.cells) column.width = std::max(column.width, letters(cell));
  return column;
}

}  // namespace

Cell cell_of(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Cell(*value) : Cell();
}

std::string printed(const ColumnHead& head, const Cell& cell, const std::string& empty) {
  if (cell.is_null()) return empty;
  if (cell.is_string()) return cell.get<std::string>();
  if (cell.is_boolean()) return cell.get<bool>() ? "yes" : "no";
  const double value = cell.get<double>();
  return value == 0 ? "0" : fmt::format(fmt::runtime(head.number), head.scale * value);
}

std::string csv_head(const std::vector<ColumnHead>& heads) {
  std::string line;
  for (const ColumnHead& head : heads)
    if (!head.key.empty()) line += (line.empty() ? "" : ",") + csv_quoted(head.key);
  return line + "\n";
}

std::string csv_rows(const CellTable& table) {
  std::string out;
  for (const auto& row : table.rows) {
    bool first = true;
    for (std::size_t i = 0; i < table.heads.size(); ++i) {
      if (table.heads[i].key.empty()) continue;
      out += (first ? "" : ",") + csv_cell(table.heads[i], row[i]);
      first = false;
    }
    out += "\n";
  }
  return out;
}

std::string csv_text(const CellTable& table) { return csv_head(table.heads) + csv_rows(table); }

std::string text_table(const CellTable& table, const TextStyle& style) {
  std::vector<TextColumn> columns;
  for (const std::size_t place : shown(table)) columns.push_back(text_column(table, place, style));
  if (columns.empty()) return "";
  TextColumn& names = columns.front();
  for (std::size_t more = 1; more < style.names && columns.size() > 1; ++more) {
    for (std::size_t line = 0; line < names.cells.size(); ++line)
      names.cells[line] =
          padded(names.cells[line], names.width, false) + "  " + columns[1].cells[line];
    columns.erase(columns.begin() + 1);
  }
  names.right = false;
  names.width = 0;
  for (const std::string& name : names.cells)
    if (letters(name) <= style.widest) names.width = std::max(names.width, letters(name));

  std::string out;
  const std::size_t room = style.width - std::min(style.width, style.indent.size() + names.width);
  for (std::size_t first = 1, last; first < columns.size() || out.empty(); first = last) {
    std::size_t used = 0;
    for (last = first; last < columns.size(); ++last) {
      used += columns[last].width + 1;
      if (used > room && last > first) break;
    }
    for (std::size_t line = 0; line <= table.rows.size(); ++line) {
      const std::string& name = names.cells[line];
      std::string text = style.indent;
      text += letters(name) > style.widest && first < columns.size()
                  ? name + "\n" + style.indent + std::string(names.width, ' ')
                  : padded(name, names.width, false);
      for (std::size_t i = first; i < last; ++i)
        text += " " + padded(columns[i].cells[line], columns[i].width, columns[i].right);
      text.erase(text.find_last_not_of(' ') + 1);
      out += text + "\n";
    }
  }
  return out;
}

std::string legend(const CellTable& table, std::size_t width) {
  std::size_t widest = 0;
  std::vector<const ColumnHead*> explained;
  for (const std::size_t place : shown(table))
    if (const ColumnHead& head = table.heads[place]; !head.meaning.empty()) {
      explained.push_back(&head);
      widest = std::max(widest, letters(head.heading));
    }
  std::string out;
  for (const ColumnHead* head : explained)
    out += folded("  " + padded(head->heading, widest, false) + "  " + head->meaning, width,
                  widest + 4);
  return out;
}

std::string latex_tabular(const CellTable& table, const std::vector<std::string>& heads) {
  std::string out = fmt::format("\\begin{{tabular}}{{l|{}}}\n", std::string(heads.size(), 'r'));
  for (const std::string& head : heads) out += " & " + head;
  out += " \\\\ \\hline\n";
  for (std::size_t i = 0; i < table.heads.size(); ++i) {
    const ColumnHead& head = table.heads[i];
    out += !head.latex.empty() ? head.latex
                               : latex_escaped(head.heading.empty() ? head.key : head.heading);
    for (const auto& row : table.rows) out += " & " + latex_escaped(printed(head, row[i], "--"));
    out += " \\\\\n";
  }
  return out + "\\end{tabular}\n";
}

std::string folded(const std::string& text, std::size_t width, std::size_t hanging) {
  std::string out, rest = text;
  while (letters(rest) > width) {
    std::size_t end = rest.rfind(' ', width);
    if (end == std::string::npos || rest.find_first_not_of(' ') > end) {
      end = rest.find(' ', width);
      if (end == std::string::npos) break;
    }
    out += rest.substr(0, end) + "\n";
    rest = std::string(hanging, ' ') + rest.substr(end + 1);
  }
  return out + rest + "\n";
}

}  // namespace lcp
