#include <fmt/format.h>

#include <algorithm>

#include "harness/studies/paper/paper_table.h"
#include "harness/studies/paper/text_lines.h"

namespace lcp {

namespace {

constexpr std::size_t columns_per_block = 7;  ///< All of the paper's Table I in 104 letters.

/// All rows for the columns first ... last - 1.
std::string block(const PaperTable& table, const std::vector<std::string>& keys, std::size_t first,
                  std::size_t last) {
  std::string out;
  for (const std::string& key : keys) {
    const PaperQuantity& quantity = paper_quantity(key);
    out += row_text(quantity, lines_of(table, quantity), first, last);
  }
  return out;
}

Words headings(const PaperTable& table, std::size_t first, std::size_t last) {
  Words all;
  for (std::size_t i = first; i < last; ++i) all.push_back(table.plan.columns[i].heading);
  return all;
}

std::string judged_line(const PaperTable& table, std::size_t first, std::size_t last) {
  Words cells;
  for (std::size_t i = first; i < last; ++i)
    cells.push_back(table.plan.columns[i].acceptance.criterion == Acceptance::Criterion::paper
                        ? "paper "
                        : "residual ");
  return text_line("judged in the loop by", "", cells);
}

/// The columns from `first` on with all their rows, as far as they go into one block.
std::string whole_block(const PaperTable& table, std::size_t first) {
  const std::size_t last = std::min(first + columns_per_block, table.plan.columns.size());
  return heading_lines(headings(table, first, last)) + judged_line(table, first, last) +
         block(table, table.plan.rows, first, last) + "ours\n" +
         block(table, table.plan.own_rows, first, last) + "\n";
}

/// The sweep over delta: a line per threshold.
std::string sweep_text(const PaperTable& table) {
  if (table.sweep.empty()) return "";
  const Words keys = {"success", "failure",     "no_solution",  "cycle",
                      "error",   "lcp_time_ms", "total_pivots", "fell"};
  Words names = {"success", "failure", "no sol.", "cycle", "error", "LCP ms", "pivots", "fell"};
  std::string out = fmt::format("lexicographic in the loop of {}, by threshold delta\n{}",
                                table.plan.scene, heading_lines(names));
  const std::size_t best = best_of(table.sweep);
  for (std::size_t i = 0; i < table.sweep.size(); ++i) {
    Words cells;
    for (const std::string& key : keys) {
      const PaperQuantity& quantity = paper_quantity(key);
      cells.push_back(cell_text(quantity, {quantity.in_loop(table.sweep[i])}));
    }
    out += text_line("  delta = " + table.plan.deltas[i], i == best ? "best" : "", cells);
  }
  return out + "Best is most successes of those whose robot did not fall, then fewest pivots.\n\n";
}

/// The corpora beside the main one: other matrices of the same contacts.
std::string other_corpora(const PaperTable& table) {
  std::string out;
  for (const std::string& corpus : corpora_of(table)) {
    if (corpus == table.plan.scene) continue;
    out += fmt::format("corpus {}\n", corpus);
    const std::size_t count = table.plan.columns.size();
    for (std::size_t first = 0; first < count; first += columns_per_block) {
      const std::size_t last = std::min(first + columns_per_block, count);
      out += heading_lines(headings(table, first, last));
      for (const char* key : {"success", "no_solution", "cycle", "error", "frictionless_failures"})
        for (const auto* columns : {&table.by_paper, &table.by_residual}) {
          const PaperQuantity& quantity = paper_quantity(key);
          Words cells;
          for (std::size_t i = first; i < last; ++i) {
            const CorpusColumn* found = find_column(*columns, corpus, table.plan.columns[i].solver);
            cells.push_back(
                cell_text(quantity, {found ? quantity.on_corpus(*found) : std::nullopt}));
          }
          const bool first_line = columns == &table.by_paper;
          out += text_line(first_line ? quantity.label : "", first_line ? "on corpus" : "  at 1e-6",
                           cells);
        }
    }
    out += "\n";
  }
  return out;
}

std::string solvers_text(const PaperTable& table) {
  std::string out;
  for (const PaperColumn& column : table.plan.columns)
    if (column.heading != column.solver)
      out += fmt::format("  {:<20} {}\n", column.heading, column.solver);
  return out;
}

int most_jobs(const PaperTable& table) {
  int jobs = 1;
  for (const LoopColumn& column : table.in_loop) jobs = std::max(jobs, column.jobs);
  return jobs;
}

std::string legend(const PaperTable& table) {
  std::string out;
  out += fmt::format(
      "published: {}\n"
      "in the loop: every column drives its own simulation of {}.\n",
      table.source, table.plan.scene);
  if (table.plan.beside)
    out += fmt::format("{}: the same with {}.\n", table.plan.beside_label, *table.plan.beside);
  out += fmt::format(
      "on corpus: every column solves the same LCPs, those of {} as driven by {},\n"
      "  in two steps; the time there is that of both steps.\n",
      table.plan.scene, table.plan.driver);
  out += fmt::format(
      "Success is judged by the paper's criterion, |w - M z - q - z0 c| <= e_max = {} (unscaled, "
      "of\n"
      "  the solver's own w, which says nothing of signs); columns judged by the residual, and "
      "the\n"
      "  lines \"at 1e-6\", by the natural residual recomputed from z (scaled, at most {}).\n",
      by_paper.tolerance, table.plan.second_look.tolerance);
  for (const LoopColumn& column : table.in_loop)
    if (!column.summary.broken.empty())
      out += fmt::format("{} ended early: {}\n", column.question.solver, column.summary.broken);
  if (!table.note.empty()) out += table.note + "\n";
  for (const std::string& each : table.published.notes) out += "The paper: " + each + "\n";
  out += "fell: tilted by more than 45 degrees, or ended early.\n";
  const int jobs = most_jobs(table);
  out += fmt::format("{} simulation{} ran at the same time{}.\n", jobs, jobs == 1 ? "" : "s",
                     jobs == 1 ? "" : ": times are disturbed");
  out += "* differs from the published value by more than a factor of 2, or exceeds what the text allows.\n";
  return out + solvers_text(table);
}

}  // namespace

std::string paper_text(const PaperTable& table) {
  std::string out = fmt::format("Table {}. {} ({})\n\n", std::string(table.plan.table, 'I'),
                                table.published.title, table.published.section);
  for (std::size_t first = 0; first < table.plan.columns.size(); first += columns_per_block)
    out += whole_block(table, first);
  return out + sweep_text(table) + other_corpora(table) + legend(table);
}

}  // namespace lcp
