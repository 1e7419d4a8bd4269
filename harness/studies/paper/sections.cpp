#include "harness/studies/paper/sections.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/present/escaping.h"

namespace lcp {

namespace {

/// With one column of names instead of two, since a terminal repeats the first one where it folds.
CellTable with_one_name(CellTable cells) {
  std::size_t width = cells.heads.front().heading.size();
  for (const auto& row : cells.rows)
    width = std::max(width, row.front().get_ref<const std::string&>().size());
  const auto joined = [width](const std::string& first, const std::string& second) {
    return fmt::format("{:<{}}  {}", first, width, second);
  };
  for (auto& row : cells.rows) {
    row[1] = joined(row[0].get<std::string>(), row[1].get<std::string>());
    row.erase(row.begin());
  }
  cells.heads[1].heading = joined(cells.heads[0].heading, cells.heads[1].heading);
  cells.heads.erase(cells.heads.begin());
  return cells;
}

/// Escaped; what is indented for a terminal is so here too.
std::string latex_name(const std::string& text) {
  return text.starts_with("  ") ? "\\quad " + latex_escaped(text.substr(2)) : latex_escaped(text);
}

}  // namespace

std::string section_text(const std::vector<PaperSection>& sections,
                         const std::vector<std::string>& notes) {
  std::string out;
  for (const PaperSection& section : sections)
    out += folded(section.title) +
           text_table(section.names == 2 ? with_one_name(section.cells) : section.cells) + "\n";
  for (const std::string& note : notes) out += folded(note, 100, 2);
  return out;
}

std::string section_latex(const std::vector<PaperSection>& sections) {
  std::string out;
  for (const auto& [title, cells, names] : sections) {
    const std::size_t values = cells.heads.size() - names;
    out += fmt::format("% {}\n\\begin{{tabular}}{{{}|{}}}\n", title, std::string(names, 'l'),
                       std::string(values, 'r'));
    const auto add = [&out, first = true](const std::string& cell) mutable {
      out += (std::exchange(first, false) ? "" : " & ") + cell;
    };
    auto add_head = add;
    for (const ColumnHead& head : cells.heads) add_head(latex_name(head.heading));
    out += " \\\\ \\hline\n";
    for (const auto& row : cells.rows) {
      auto add_cell = add;
      for (std::size_t i = 0; i < row.size(); ++i)
        add_cell(latex_name(printed(cells.heads[i], row[i], "--")));
      out += " \\\\\n";
    }
    out += "\\end{tabular}\n\n";
  }
  return out;
}

}  // namespace lcp
