#pragma once

#include <string>
#include <vector>

#include "harness/studies/sheet/sheet.h"

namespace lcp {

/// A row of the run as the sheet sees it.
struct Entry {
  const Record* record;
  std::size_t setting;
  std::size_t instance;
  Judged judged;
  double cost;
};

/// Ladders among the settings of `rows`, over options whose values are numbers. A setting may stand in
/// several.
std::vector<Ladder> make_ladders(const std::vector<Entry>& entries,
                                 const std::vector<SheetRow>& rows);

}  // namespace lcp
