#pragma once

#include "harness/runs/run_directory.h"

namespace lcp {

struct MergeOptions {
  bool mixed = false;  ///< Rows of different commits or environments may stand together.
};

/// Joins runs into one in directory `out` (not written yet): rows in the order in which one run
/// would have them, every environment, the solvers of all. Shards become a whole run, which can be
/// resumed; those missing are said to `note`.
///
/// Throws std::invalid_argument when the runs' settings conflict, when they are of different commits
/// or environments and may not be mixed, or when two of them hold the same pair.
StoredRun merge(const std::vector<StoredRun>& runs, const std::filesystem::path& out,
                const MergeOptions& options, const std::function<void(const std::string&)>& note);

}  // namespace lcp
