#pragma once

#include <string>
#include <vector>

#include "harness/studies/paper/plan.h"
#include "harness/studies/paper/published.h"
#include "harness/studies/paper/quantities.h"
#include "harness/studies/table/table.h"

namespace lcp {

/// A table of the paper beside what this program measured.
struct PaperTable {
  PaperPlan plan;  ///< Its columns with their solvers.
  PublishedTable published;
  std::string source;                               ///< Of what is published.
  std::vector<LoopColumn> in_loop;                  ///< On plan.scene, as plan.columns.
  std::vector<LoopColumn> beside;                   ///< On plan.beside, likewise; or none.
  std::vector<LoopColumn> sweep;                    ///< As plan.deltas.
  std::vector<CorpusColumn> by_paper, by_residual;  ///< On every frictional corpus.
  std::string note;  ///< On the corpus, if its simulation ended early.
};

struct PaperCell {
  std::optional<double> value;
  bool far = false;  ///< From the published value, by more than a factor of 2.
};

/// One line of a row of the table, with a cell per column.
struct PaperLine {
  enum class Kind { published, in_loop, corpus } kind;
  std::string label;      ///< published, in the loop, reduced, on corpus, ... at 1e-6.
  std::string corpus;     ///< Scene or corpus in full spelling; empty for what is published.
  Acceptance acceptance;  ///< Of lines on a corpus.
  std::vector<PaperCell> cells;
};

/// The lines of a row: published, in the loop, beside, on the corpus by the paper's criterion and,
/// where it makes a difference, by the residual. Lines without any value are left out.
std::vector<PaperLine> lines_of(const PaperTable& table, const PaperQuantity& quantity);

/// The frictional corpora, the scene's own first.
std::vector<std::string> corpora_of(const PaperTable& table);

/// What a solver did on a corpus; null where it has no rows.
const CorpusColumn* find_column(const std::vector<CorpusColumn>& columns, const std::string& corpus,
                                const std::string& solver);

/// Position of the column of the sweep with most successes among those whose robot did not fall (on
/// its side it has fewer contacts, which are easier), with fewest pivots among equals.
std::size_t best_of(const std::vector<LoopColumn>& sweep);

/// `text` for a terminal; `json` {"rows": [...]}, an object per column and mode with the fields of
/// `lcpbench table` and a `published` object with the printed values; `csv`, a line per value;
/// `latex`, a plain tabular.
std::string render(const PaperTable& table, TableFormat format);

/// The parts of render.
std::string paper_text(const PaperTable& table);
std::string paper_json(const PaperTable& table);
std::string paper_csv(const PaperTable& table);
std::string paper_latex(const PaperTable& table);

}  // namespace lcp
