#pragma once

#include "harness/present/described.h"
#include "harness/studies/perturb/perturb_flips.h"

namespace lcp {

/// Text: a block per corpus, with the meaning of its columns and which kinds did not apply to what. CSV:
/// a line per row; rates are shares of the trials, empty where nothing was measured. JSON: {"options",
/// "same", "tolerance", "rows", "not_applicable"}. Figure: flips_figure, without panels where nothing
/// was counted.
Described described(const Flips& flips);

/// Pooled over the corpora: a line per solver; the share it solves undisturbed; and per kind its flip
/// rate with the 95 % interval. Throws std::invalid_argument where nothing was counted.
Figure flips_figure(const Flips& flips);

}  // namespace lcp
