#pragma once

#include <filesystem>
#include <string>

#include "harness/studies/perturb/perturb_flips.h"

namespace lcp {

enum class FlipFormat { text, csv, json };

/// `text`: a block per corpus for a terminal, with the meaning of its columns and which kinds did not
/// apply to what; `csv`: a line per row; `json`: {"options", "same", "tolerance", "rows",
/// "not_applicable"}, null where nothing was measured. Rates are shares of the trials.
std::string render(const Flips& flips, FlipFormat format);

/// Draws `flips` with gnuplot, pooled over the corpora: a line per solver; the share it solves
/// undisturbed; and per kind its flip rate with the 95 % interval. Writes `svg`, and .gp and .dat
/// beside it, so that it can be restyled. Throws UnwritableOutput where they cannot be written or
/// gnuplot is missing or fails, and std::invalid_argument where nothing was counted.
void draw_flips(const Flips& flips, const std::filesystem::path& svg);

}  // namespace lcp
