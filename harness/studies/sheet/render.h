#pragma once

#include <string>
#include <vector>

#include "harness/studies/sheet/sheet.h"

namespace lcp {

/// What the median, mean and ratios are of, and to which set of settings they belong: the sentences
/// under a picture or a table.
std::string sheet_caption(const Sheet& sheet);

/// How the ratios of the profile are formed: `c / best` or `(c + 1) / (best + 1)`.
std::string ratio_formula(const SheetOptions& options);

/// Places in `group.rows` of the front among the settings that solve the largest share.
std::vector<std::size_t> best_solving_front(const Group& group);

}  // namespace lcp
