#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "harness/studies/loop/summary.h"
#include "harness/studies/table/table.h"

namespace lcp {

/// Writes STEM.txt, .csv, .json and .tex, which hold `rendered` in each format. Throws
/// UnwritableOutput.
void write_each_format(const std::filesystem::path& stem,
                       const std::function<std::string(TableFormat)>& rendered);

/// What ran for a figure of the paper, a summary per scene: `text` for a terminal; `json` {"figure",
/// "picture", "data", "runs": [...]}, the names of its files; `latex` a figure that includes the
/// picture, with a caption. Throws std::invalid_argument for `csv`, which is the figure's data.
std::string render_figure(int figure, const std::vector<LoopSummary>& runs, TableFormat format);

}  // namespace lcp
