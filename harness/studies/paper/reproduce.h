#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "harness/studies/paper/paper_table.h"

namespace lcp {

/// Computes what the directory does not hold yet and sets the table together: simulations, the
/// corpus, the rows of the columns on it. Empty when `interrupted`; what was finished stays.
/// Throws as PaperDirectory, compute_loop_columns, dump_corpus and run_on_corpus do.
std::optional<PaperTable> reproduce(PaperPlan plan, const Reproduction& how,
                                    const std::atomic<bool>& interrupted);

/// What reproduce would compute, a line each: `simulation of squat with lemke`. The directory is not
/// made, and rows on a corpus that is not there yet are one line.
std::vector<std::string> missing_work(PaperPlan plan, const Reproduction& how);

}  // namespace lcp
