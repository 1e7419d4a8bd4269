#pragma once

#include <vector>

#include "harness/charts/dot_panels.h"
#include "harness/paper/choices.h"
#include "harness/paper/paper_table.h"
#include "harness/paper/scene_table.h"

namespace lcp {

/// Published and measured values of the paper's own rows, a panel per row of the table; of Table II also
/// the sweep over delta.
DotPage picture_of(const PaperTable& table);
DotPage picture_of(const SceneTable& table);

/// What each choice does to failures, nodes, violated contacts and penetration, in both scenes.
DotPage picture_of(const std::vector<ChoiceTable>& tables);

}  // namespace lcp
