#pragma once

#include <string>
#include <vector>

#include "harness/present/columns.h"
#include "harness/studies/table/table.h"

namespace lcp {

/// A table for readers below a heading.
struct PaperSection {
  std::string title;
  CellTable cells;
  std::size_t names = 2;  ///< Leading columns that name a row.
};

/// What readers and programs get of a computation.
struct PaperPage {
  std::vector<PaperSection> sections;
  std::vector<std::string> notes;
  std::string csv, json;
};

/// `text` for a terminal: the sections, then the notes, in lines of at most 100 letters; `latex`, the notes
/// as comments and a tabular per section; `csv` and `json` as they are.
std::string render(const PaperPage& page, TableFormat format);

}  // namespace lcp
