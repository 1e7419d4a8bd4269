#pragma once

#include "harness/cli/verbs.h"

namespace lcp::cli {

/// The parts of the verb `stability`, one per file.
Verb add_stability_perturb(CLI::App& page);

Verb add_stability_loop(CLI::App& page);
Verb add_stability_frontier(CLI::App& stability);

}  // namespace lcp::cli
