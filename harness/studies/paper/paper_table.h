#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/studies/paper/columns/corpus.h"
#include "harness/studies/paper/plan.h"
#include "harness/studies/paper/published.h"
#include "harness/studies/paper/quantities.h"
#include "harness/studies/paper/sections.h"

namespace lcp {

/// What was computed for a plan.
struct PaperColumns {
  std::vector<std::vector<LoopColumn>> in_loop;     ///< As plan.solvers, each as plan.scenes.
  std::vector<LoopColumn> sweep;                    ///< As plan.deltas.
  std::vector<CorpusColumn> by_paper, by_residual;  ///< On every frictional corpus.
  std::vector<double> lengths;                      ///< SceneSetup::length of each scene, m.
};

/// One way of measuring, or one solver: a line of each row of the table, with a value per column.
struct PaperLayer {
  std::string label;    ///< in the loop, reduced, on corpus, at 1e-6; in Table III a solver.
  std::string section;  ///< Heading of the lines; empty: the paper's table itself.
  bool second_look;     ///< Only in rows that depend on the criterion of success.
  std::vector<Cell>
      rows;  ///< As the table's columns: objects of the JSON; null where there is none.
};

/// How a solver's hoist at 10 ms compares with that at 1 ms.
struct PaperHoists {
  std::string heading, solver;
  Cell time_ratio, end_distance;  ///< Null where there is none.
};

/// A table of the paper beside what this program measured.
struct PaperTable {
  PaperPlan plan;  ///< Its columns with their solvers.
  PublishedTable published;
  std::string source;                ///< Of what is published.
  std::vector<PaperColumn> columns;  ///< plan.solvers; in Table III the names of scenes.
  std::vector<PaperLayer> layers;    ///< In the order of JSON.
  std::vector<Cell> sweep;           ///< As plan.deltas: objects of the JSON.
  std::vector<PaperHoists> hoists;   ///< Of Table III, as its lines.
  /// That ratio by the paper's text and by its cells, which contradict the text.
  Cell told_ratio = {}, printed_ratio = {};
  std::vector<std::string> broken;  ///< What ended early, a sentence each.
  int jobs = 1;                     ///< Most simulations that ran at the same time.
};

/// The section of Table III's solvers with a limit.
inline constexpr const char* rest_section = "other solvers";

PaperTable set_together(const PaperPlan& plan, const PaperColumns& columns);

struct PaperCell {
  Cell value;
  bool far = false;  ///< From the published value (PublishedTable::departs).
};

/// One line of a row of the table, with a cell per column.
struct PaperLine {
  std::string label;  ///< published, or a layer's.
  std::vector<PaperCell> cells;
};

/// The lines of a row in a section: published, which is in the paper's table alone, then its layers'.
/// Lines without any value are left out.
std::vector<PaperLine> lines_of(const PaperTable& table, const PaperQuantity& quantity,
                                const std::string& section = "");

/// Position of the column of the sweep with most successes among those whose robot did not fall (on
/// its side it has fewer contacts, which are easier), with fewest pivots among equals.
std::size_t best_of(const std::vector<LoopColumn>& sweep);

/// Total computation time (simulation time x frames with contact) of the hoist at 1 ms over that at
/// 10 ms, by the printed cells and by simulations; empty where either ended early.
std::optional<double> printed_time_ratio(const PublishedTable& published);
std::optional<double> time_ratio(const LoopSummary& fine, const LoopSummary& coarse);

/// The distance of two motions, over the length of what moves, up to which they count as the same.
inline constexpr double same_motion = 0.05;

/// Distance of the end of the hoist at 10 ms from that at 1 ms, over the length of the chain; empty
/// where either ended early.
std::optional<double> end_distance(const LoopSummary& fine, const LoopSummary& coarse,
                                   double length);

/// How far a simulation came, and how far from the reference's motion.
struct Motion {
  double survived = 0;             ///< s.
  std::optional<double> distance;  ///< Over the length, at the last twentieth that both reached.
  std::optional<double> parted;    ///< s; first twentieth at which it exceeds same_motion.
};

Motion motion_of(const LoopSummary& motion, const LoopSummary& reference, double length);

/// `Table I. TITLE (SECTION)`.
std::string title_of(const PaperTable& table);

/// Its json is {"rows": [...]}, an object per column and mode with the fields of `lcpbench table` and a
/// `published` object with the printed values, its csv a line per value.
PaperPage page_of(const PaperTable& table);

}  // namespace lcp
