#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/judge/acceptance.h"
#include "harness/record.h"
#include "harness/studies/paper/columns/paper_directory.h"

namespace lcp {

/// A scene's LCPs, dumped while `driver` drives it (judged by the residual, 1e-6).
struct CorpusQuestion {
  std::string scene, driver;       ///< Full spellings.
  std::optional<double> duration;  ///< s; the scene's where empty.
};

/// A corpus that is complete.
struct ScenesCorpus {
  std::vector<std::filesystem::path> files;  ///< In order of time.
  std::string broken;                        ///< Why the simulation ended early, if it did.
};

/// The corpus of a table's directory; empty where there is none or it is not complete. Throws
/// UnreadableInput on a damaged corpus.json, std::invalid_argument where it is of another commit or
/// answers another question.
std::optional<ScenesCorpus> find_corpus(const PaperDirectory& directory,
                                        const CorpusQuestion& question);

/// Simulates and dumps in a process of its own. The corpus is written beside its place and moved
/// there when it is complete; what stands there without corpus.json, which is written last, is
/// removed. Throws std::runtime_error when the driver crashed.
void dump_corpus(const PaperDirectory& directory, const CorpusQuestion& question,
                 const std::atomic<bool>& interrupted);

/// Which solvers are to have rows on a corpus.
struct CorpusRun {
  std::vector<std::string> solvers;  ///< Full spellings.
  int samples = 1;                   ///< Timed repetitions of a solved pair.
};

/// How many solvers lack rows on the parts of the corpus, in all.
std::size_t missing_rows(const PaperDirectory& directory, const ScenesCorpus& corpus,
                         const CorpusRun& run);

/// Runs the pairs that have no row yet, a file of the corpus at a time, so that little is forked:
/// frictional LCPs in two steps, frictionless ones (which cannot be) cold. Then reads the rows of
/// run.solvers. When `interrupted`, returns those that are there. Throws as run_into does.
std::vector<Record> run_on_corpus(const PaperDirectory& directory, const ScenesCorpus& corpus,
                                  const CorpusRun& run, const std::atomic<bool>& interrupted);

/// What one solver did on one corpus of a scene (SCENE, SCENE+composite, SCENE+joint-space).
struct CorpusColumn {
  std::string corpus, solver;
  /// By the keys of paper_quantities, of the frictional LCPs: those of `lcpbench table`, the trivial in
  /// `success` as in the loop; total_pivots, lcp_time_ms (mean over frames of the median time, both
  /// steps), frictionless_failures (in CORPUS+frictionless, solved cold) and both_failures (frames
  /// where both failed).
  nlohmann::json values;
};

/// A column per frictional corpus and solver, in order of first appearance, counted by a criterion.
std::vector<CorpusColumn> corpus_columns(const std::vector<Record>& rows,
                                         const Acceptance& acceptance);

}  // namespace lcp
