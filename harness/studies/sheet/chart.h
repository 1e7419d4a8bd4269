#pragma once

#include <filesystem>

#include "harness/studies/sheet/sheet.h"

namespace lcp {

/// Draws the plane of a sheet with gnuplot: a panel per group, median cost against median residual on
/// log axes with quartiles as bars, settings of a ladder joined, the front ringed, and its part among
/// those that solve the most as stairs. Beside each panel the mass: failures of every setting, which
/// have no place in the plane, and what else is not solved. Where a group has many settings, the front
/// and the highlights are in colour and listed, the others grey and summed up.
///
/// Writes `svg`, and the script and the data it is made from beside it (.gp, .dat), so that it can be
/// restyled: `gnuplot chart.gp > chart.svg`. Throws UnwritableOutput where they cannot be written or
/// gnuplot is missing or fails, and std::invalid_argument when no group has a counted row.
void draw_chart(const Sheet& sheet, const std::filesystem::path& svg);

/// Groups that a picture of small multiples shows, the first `most` with counted rows: all corpora
/// together, then corpora in their order.
std::vector<const Group*> drawn_groups(const Sheet& sheet, std::size_t most);

}  // namespace lcp
