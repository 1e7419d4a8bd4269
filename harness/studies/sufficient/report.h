#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/studies/sufficient/study.h"
#include "harness/studies/table/table.h"

namespace lcp {

/// A study for a terminal: its table, the noise floor, and which model is enough.
std::string render_text(const Study& study);

/// `text`, `csv` (a line per model and scene) or `json` (an object per scene) of studies; text of
/// several ends with a line for each. Throws std::invalid_argument on another format.
std::string render(const std::vector<Study>& studies, TableFormat format);

/// Draws physical error over tolerance against the time saved, one panel a study; script and data
/// are kept beside it. Throws as draw_with_gnuplot.
void draw_studies(const std::vector<Study>& studies, const std::filesystem::path& svg);

}  // namespace lcp
