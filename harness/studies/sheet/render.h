#pragma once

#include <string>

#include "harness/studies/sheet/sheet.h"

namespace lcp {

/// The formats of render(), one per file.
std::string sheet_text(const Sheet& sheet);
std::string sheet_csv(const Sheet& sheet);
std::string sheet_json(const Sheet& sheet);

/// What the median, mean and ratios are of, and to which set of settings they belong: the sentences
/// under a picture or a table.
std::string sheet_caption(const Sheet& sheet);

/// How the ratios of the profile are formed: `c / best` or `(c + 1) / (best + 1)`.
std::string ratio_formula(const SheetOptions& options);

}  // namespace lcp
