#pragma once

#include <string>
#include <vector>

#include "harness/present/columns.h"
#include "harness/present/figure.h"
#include "harness/studies/perturb/perturb_flips.h"

namespace lcp {

/// A row as programs read it. Rates are shares of the trials; null where nothing was measured.
std::vector<Column<FlipRow>> flip_columns();

/// A block per corpus for a terminal, with the meaning of its columns and which kinds did not apply to
/// what.
std::string flips_text(const Flips& flips);
/// A line per row.
std::string flips_csv(const Flips& flips);
/// {"options", "same", "tolerance", "rows", "not_applicable"}.
nlohmann::ordered_json flips_json(const Flips& flips);

/// Pooled over the corpora: a line per solver; the share it solves undisturbed; and per kind its flip
/// rate with the 95 % interval. Throws std::invalid_argument where nothing was counted.
Figure flips_figure(const Flips& flips);

}  // namespace lcp
