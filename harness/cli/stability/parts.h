#pragma once

#include "harness/cli/verbs.h"

namespace lcp::cli {

/// The parts of the verb `stability`, one per file.

}  // namespace lcp::cli
