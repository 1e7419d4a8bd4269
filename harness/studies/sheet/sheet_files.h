#pragma once

#include <filesystem>

#include "harness/studies/sheet/sheet.h"

namespace lcp {

/// Writes a sheet into a directory: sheet.txt, sheet.csv, sheet.json, and the pictures chart.svg (the
/// plane), sheet-profile.svg, sheet-cumulative.svg, and of times sheet-accuracy.svg, each with its
/// script and data beside it. Of another measure than time the names hold it: sheet-pivots.txt,
/// sheet-pivots-profile.svg, chart-pivots.svg. Pictures are left out where nothing is counted. Throws
/// UnwritableOutput; the numbers are written before the pictures.
void write_sheet(const Sheet& sheet, const std::filesystem::path& directory);

/// Makes the sheet of a run directory and writes it and its pictures into `out`. Throws as read_run,
/// make_sheet and write_sheet do.
Sheet write_sheet(const std::filesystem::path& directory, const SheetOptions& options,
                  const std::filesystem::path& out);

}  // namespace lcp
