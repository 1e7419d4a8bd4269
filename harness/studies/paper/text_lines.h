#pragma once

#include <string>
#include <vector>

#include "harness/studies/paper/paper_table.h"

namespace lcp {

/// Cells of a line, or pieces of a heading.
using Words = std::vector<std::string>;

/// Headings above the cells of a table for a terminal, cut where they are longer than a cell.
std::string heading_lines(const Words& headings);

/// A line: what the row is called, which line of the row it is, and a cell per column.
std::string text_line(const std::string& row, const std::string& label, const Words& cells);

/// The value as a reader sees it with its star, or a hyphen.
std::string cell_text(const PaperQuantity& quantity, const PaperCell& cell);

/// The lines of a row for the columns first ... last - 1; those without a value there are left out.
std::string row_text(const PaperQuantity& quantity, const std::vector<PaperLine>& lines,
                     std::size_t first, std::size_t last);

}  // namespace lcp
