#pragma once

#include "harness/present/figure.h"
#include "harness/studies/sheet/sheet.h"

namespace lcp {

/// The plane of a sheet: a panel per group, median cost against median residual on logarithmic axes with
/// quartiles as bars, settings of a ladder joined, the front ringed, and its part among those that
/// solve the most as stairs. Beside each panel the mass: failures of every setting, which have no
/// place in the plane, and what else is not solved. Where a group has many settings, the front and the
/// highlights are in colour and listed, the others grey and summed up. Costs and residuals of 0 stand
/// at `cost_floor` and `residual_floor`. Throws std::invalid_argument when no group has a counted row.
Figure chart_figure(const Sheet& sheet);

/// Where 0 stands on an axis of costs.
double cost_floor(Measure measure);

/// Groups that a picture of small multiples shows, the first `most` with counted rows: all corpora
/// together, then corpora in their order.
std::vector<const Group*> drawn_groups(const Sheet& sheet, std::size_t most);

/// The registry row of every setting, without its start.
std::vector<std::string> rows_of_settings(const Sheet& sheet);

}  // namespace lcp
