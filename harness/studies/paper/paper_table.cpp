#include "harness/studies/paper/paper_table.h"

#include <algorithm>
#include <stdexcept>

namespace lcp {

namespace {

/// Empty unless any cell of the line has a value.
void add_line(std::vector<PaperLine>& lines, PaperLine line, const PaperTable& table,
              const PaperQuantity& quantity) {
  const bool any = std::any_of(line.cells.begin(), line.cells.end(),
                               [](const PaperCell& cell) { return cell.value.has_value(); });
  if (!any) return;
  if (line.kind != PaperLine::Kind::published)
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
      PaperCell& cell = line.cells[i];
      cell.far = cell.value &&
                 table.published.departs(quantity.key, table.plan.columns[i].name, *cell.value);
    }
  lines.push_back(std::move(line));
}

PaperLine loop_line(const std::string& label, const std::string& scene,
                    const std::vector<LoopColumn>& columns, const PaperQuantity& quantity) {
  PaperLine line{PaperLine::Kind::in_loop, label, scene, {}, {}};
  for (const LoopColumn& column : columns) line.cells.push_back({quantity.in_loop(column)});
  return line;
}

PaperLine corpus_line(const std::string& label, const std::vector<CorpusColumn>& columns,
                      const Acceptance& acceptance, const PaperTable& table,
                      const PaperQuantity& quantity) {
  PaperLine line{PaperLine::Kind::corpus, label, table.plan.scene, acceptance, {}};
  for (const PaperColumn& column : table.plan.columns) {
    const CorpusColumn* found = find_column(columns, table.plan.scene, column.solver);
    line.cells.push_back({found ? quantity.on_corpus(*found) : std::nullopt});
  }
  return line;
}

}  // namespace

std::vector<PaperLine> lines_of(const PaperTable& table, const PaperQuantity& quantity) {
  std::vector<PaperLine> lines;
  PaperLine printed{PaperLine::Kind::published,
                    table.published.at_most(quantity.key) ? "text: at most" : "published",
                    "",
                    {},
                    {}};
  for (const PaperColumn& column : table.plan.columns)
    printed.cells.push_back({table.published.value(quantity.key, column.name)});
  add_line(lines, std::move(printed), table, quantity);
  add_line(lines, loop_line("in the loop", table.plan.scene, table.in_loop, quantity), table,
           quantity);
  if (table.plan.beside)
    add_line(lines, loop_line(table.plan.beside_label, *table.plan.beside, table.beside, quantity),
             table, quantity);
  add_line(lines, corpus_line("on corpus", table.by_paper, by_paper, table, quantity), table,
           quantity);
  if (quantity.judged)
    add_line(lines,
             corpus_line("  at 1e-6", table.by_residual, table.plan.second_look, table, quantity),
             table, quantity);
  return lines;
}

std::vector<std::string> corpora_of(const PaperTable& table) {
  std::vector<std::string> corpora;
  for (const CorpusColumn& column : table.by_paper)
    if (std::find(corpora.begin(), corpora.end(), column.corpus) == corpora.end())
      corpora.push_back(column.corpus);
  std::stable_partition(corpora.begin(), corpora.end(),
                        [&](const std::string& corpus) { return corpus == table.plan.scene; });
  return corpora;
}

const CorpusColumn* find_column(const std::vector<CorpusColumn>& columns, const std::string& corpus,
                                const std::string& solver) {
  for (const CorpusColumn& column : columns)
    if (column.corpus == corpus && column.solver == solver) return &column;
  return nullptr;
}

std::size_t best_of(const std::vector<LoopColumn>& sweep) {
  const auto better = [](const LoopColumn& a, const LoopColumn& b) {
    if (a.fell() != b.fell()) return b.fell();
    if (a.summary.success != b.summary.success) return a.summary.success > b.summary.success;
    return a.summary.pivots < b.summary.pivots;
  };
  return static_cast<std::size_t>(std::min_element(sweep.begin(), sweep.end(), better) -
                                  sweep.begin());
}

std::string render(const PaperTable& table, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return paper_text(table);
    case TableFormat::csv:
      return paper_csv(table);
    case TableFormat::json:
      return paper_json(table);
    case TableFormat::latex:
      return paper_latex(table);
  }
  throw std::logic_error("unknown table format");
}

}  // namespace lcp
