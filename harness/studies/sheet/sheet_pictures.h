#pragma once

#include "harness/present/figure.h"
#include "harness/studies/sheet/sheet.h"

namespace lcp {

/// Pictures of a sheet's curves: one large panel with a legend beside it, smaller ones below, all with
/// the same axes. At most `most_highlights_of_curves` settings are in colour: the highlights of the
/// first group, the same in every panel; the others are grey, in the large panel alone. The legend
/// gives each one's share that never rises. All throw std::invalid_argument where nothing is counted.
constexpr std::size_t most_highlights_of_curves = 10;

/// Performance profiles: the first group large, then the following ones.
Figure profile_figure(const Sheet& sheet);

/// Cumulative curves of the first group: at the sheet's tolerance large, then at the other accuracies.
Figure cumulative_figure(const Sheet& sheet);

/// Accuracy in time of the first group: the middle budget large, then the others. Of a sheet of times.
Figure accuracy_figure(const Sheet& sheet);

}  // namespace lcp
