#include "harness/studies/paper/sections.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "harness/present/escaping.h"

namespace lcp {

namespace {

/// A line of a tabular; what is indented for a terminal is so here too.
std::string latex_line(std::vector<std::string> cells) {
  for (std::string& cell : cells)
    cell = cell.starts_with("  ") ? "\\quad " + latex_escaped(cell.substr(2)) : latex_escaped(cell);
  return fmt::format("{} \\\\", fmt::join(cells, " & "));
}

std::string latex_tabular_of(const PaperSection& section) {
  const auto& [heads, rows] = section.cells;
  std::vector<std::string> cells;
  for (const ColumnHead& head : heads)
    cells.push_back(head.latex.empty() ? head.heading : head.latex);
  std::string out = fmt::format("% {}\n\\begin{{tabular}}{{{}|{}}}\n{} \\hline\n", section.title,
                                std::string(section.names, 'l'),
                                std::string(heads.size() - section.names, 'r'), latex_line(cells));
  for (const std::vector<Cell>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) cells[i] = printed(heads[i], row[i], "--");
    out += latex_line(cells) + "\n";
  }
  return out + "\\end{tabular}\n\n";
}

}  // namespace

std::string render(const PaperPage& page, TableFormat format) {
  if (format == TableFormat::csv) return page.csv;
  if (format == TableFormat::json) return page.json;
  const bool text = format == TableFormat::text;
  std::string sections, notes;
  for (const PaperSection& each : page.sections)
    sections += text ? folded(each.title) + text_table(each.cells, {.names = each.names}) + "\n"
                     : latex_tabular_of(each);
  for (const std::string& note : page.notes)
    notes += text ? folded(note, 100, 2) : "% " + note + "\n";
  return text ? sections + notes : notes + sections;
}

}  // namespace lcp
