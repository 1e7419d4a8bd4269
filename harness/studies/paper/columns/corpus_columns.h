#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/studies/paper/columns/corpus.h"
#include "harness/studies/table/table.h"

namespace lcp {

/// What one solver did on one corpus of a scene (SCENE, SCENE+composite, SCENE+joint-space),
/// counted by one criterion. Instances that z = 0 solves are successes here, as they are in the
/// loop.
struct CorpusColumn {
  std::string corpus, solver;
  Acceptance acceptance;
  TableRow counts;  ///< Of the frictional LCPs; `trivial` of them are in success too.
  Index frictionless_failures = 0;  ///< In CORPUS+frictionless, solved cold;
  Index both_failures = 0;          ///< frames where both LCPs failed.
  Index pivots = 0;                 ///< Total, of the frictional LCPs.
  double lcp_ms = 0;                ///< Mean over frames of the median time, both steps.
};

/// The rows of the solvers on the corpus, in shape to be counted by any criterion.
class CorpusRows {
 public:
  explicit CorpusRows(std::vector<Record> records) : records_(std::move(records)) {}

  /// A column per frictional corpus and per solver, in order of first appearance.
  std::vector<CorpusColumn> columns(const Acceptance& acceptance) const;

  std::size_t size() const { return records_.size(); }

 private:
  std::vector<Record> records_;
};

/// How rows on a corpus are made.
struct CorpusRun {
  std::vector<std::string> solvers;  ///< Full spellings.
  int jobs = 1;
  int samples = 1;  ///< Timed repetitions of a solved pair.
};

/// How many pairs have no row yet.
std::size_t missing_rows(const PaperDirectory& directory, const ScenesCorpus& corpus,
                         const CorpusRun& run);

/// Runs the pairs that have no row yet, a file of the corpus at a time, so that little is forked:
/// frictional LCPs in two steps, frictionless ones (which cannot be) cold. Then reads the rows of
/// run.solvers. When `interrupted`, returns those that stand there. Throws as run_into does.
CorpusRows run_on_corpus(const PaperDirectory& directory, const ScenesCorpus& corpus,
                         const CorpusRun& run, const std::function<void(const std::string&)>& note,
                         const std::function<void(const Progress&)>& progress,
                         const std::atomic<bool>& interrupted);

}  // namespace lcp
