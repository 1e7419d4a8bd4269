#pragma once

#include <filesystem>

#include "harness/present/step_curves.h"
#include "harness/studies/sheet/sheet.h"

namespace lcp {

/// Pages of a sheet's curves. At most `most_highlights` settings are in colour: the highlights of the
/// first group, the same in every panel; the others are grey. The legend gives each one's share that
/// never rises.
constexpr std::size_t most_highlights_of_curves = 10;

/// Performance profiles: the first group large, then the following ones.
StepCurvePage profile_page(const Sheet& sheet);

/// Cumulative curves of the first group: at the sheet's tolerance large, then at the other accuracies.
StepCurvePage cumulative_page(const Sheet& sheet);

/// Accuracy in time of the first group: the middle budget large, then the others. Of a sheet of times.
StepCurvePage accuracy_page(const Sheet& sheet);

}  // namespace lcp
