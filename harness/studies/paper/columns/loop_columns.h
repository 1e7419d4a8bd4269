#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <vector>

#include "harness/studies/loop/summary.h"
#include "harness/studies/paper/columns/paper_directory.h"

namespace lcp {

/// A simulation to be done: a solver drives a scene.
struct LoopQuestion {
  std::string scene, solver;  ///< Full spellings.
  Acceptance acceptance;
  std::optional<double> duration;  ///< s; the scene's where empty.
  /// s of computing after which it is stopped, broken, with the frames that it did. An answer that
  /// came to its end is one to every limit.
  std::optional<double> limit = {};

  bool operator==(const LoopQuestion&) const = default;
};

/// A simulation done, as kept in its file.
struct LoopColumn {
  LoopQuestion question;
  LoopSummary summary;  ///< `broken` says why where it ended early: also a crash of the solver.
  std::string environment, commit;
  int jobs = 1;  ///< Simulations at the same time: it disturbs times.

  /// The robot lies: its trunk tilted by more than 45 degrees, or the simulation did not reach its end.
  bool fell() const;
};

/// Where a column is kept below the table's directory: `loop/squat/lexicographic,delta=0@paper.json`.
std::filesystem::path loop_file(const LoopQuestion& question);

/// The column of a question; empty where there is none yet, or one that was stopped at a lower
/// limit. Throws UnreadableInput on a damaged file, std::invalid_argument on one of another commit
/// or another question.
std::optional<LoopColumn> read_loop_column(const PaperDirectory& directory,
                                           const LoopQuestion& question);

/// The questions without an answer, each once; null is a directory that is not there.
std::vector<LoopQuestion> open_questions(const PaperDirectory* directory,
                                         const std::vector<LoopQuestion>& questions);

/// Answers the questions that are open by simulation, each in a process of its own, how.jobs at a time;
/// a column is in its file as soon as it is finished. A solver that crashes, throws or takes more than
/// two minutes for one step makes a column without frames whose summary says so. Throws as run_children
/// does.
void compute_loop_columns(const PaperDirectory& directory,
                          const std::vector<LoopQuestion>& questions,
                          const std::atomic<bool>& interrupted);

}  // namespace lcp
