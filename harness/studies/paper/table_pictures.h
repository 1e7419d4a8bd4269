#pragma once

#include <vector>

#include "harness/present/dot_panels.h"
#include "harness/studies/paper/choices.h"
#include "harness/studies/paper/paper_table.h"

namespace lcp {

/// Published and measured values of the paper's own rows, a panel per row of the table; of Table II also
/// the sweep over delta.
DotPage picture_of(const PaperTable& table);

/// What each choice does to failures, nodes, violated contacts and penetration, in both scenes.
DotPage picture_of(const std::vector<ChoiceTable>& tables);

}  // namespace lcp
