#pragma once

#include <string>
#include <vector>

#include "harness/present/columns.h"

namespace lcp {

/// A table for readers below a heading.
struct PaperSection {
  std::string title;
  CellTable cells;
  std::size_t names = 1;  ///< Leading columns that name a row, 1 or 2.
};

/// For a terminal: the sections, then the notes, in lines of at most 100 letters.
std::string section_text(const std::vector<PaperSection>& sections,
                         const std::vector<std::string>& notes);

/// A tabular per section, its title as a comment.
std::string section_latex(const std::vector<PaperSection>& sections);

}  // namespace lcp
