#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/runner.h"
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
                 const std::function<void(const Progress&)>& progress,
                 const std::atomic<bool>& interrupted);

}  // namespace lcp
