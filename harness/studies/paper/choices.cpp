#include "harness/studies/paper/choices.h"

#include <fmt/format.h>

#include "harness/studies/paper/plan.h"
#include "harness/studies/paper/sections.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp {

namespace {

LoopQuestion question(const std::string& scene, const Choice& choice) {
  const std::string text = choice.knobs.empty() ? scene : fmt::format("{}:{}", scene, choice.knobs);
  return {make_scene(text).spelling, make_solver(choice.solver).spelling, choice.acceptance, {}};
}

/// A value as its column writes it, 0 and what is no number too.
std::string written(const ColumnHead& head, const Cell& value) {
  return value.is_number()
             ? fmt::format(fmt::runtime(head.number), head.scale * value.get<double>())
             : printed(head, value);
}

/// A figure of the summary by its name.
std::function<Cell(const LoopColumn&)> figure_named(const char* name) {
  return [name](const LoopColumn& column) -> Cell { return figures_of(column.summary).at(name); };
}

Cell nodes_a_frame(const LoopColumn& column) {
  const auto frames = static_cast<double>(column.summary.total_frames);
  return frames == 0 ? Cell() : Cell(static_cast<double>(column.summary.nodes) / frames);
}

PaperSection section_of(const ChoiceTable& table) {
  PaperSection section{table.scene, {{{.heading = "choice"}, {.heading = "decided"}}, {}}};
  for (ColumnHead head : choice_columns()) {
    head.latex = head.key;
    head.right = true;
    section.cells.heads.push_back(head);
  }
  for (std::size_t i = 0; i < choices().size(); ++i) {
    section.cells.rows.push_back({choices()[i].what, choices()[i].way});
    for (const Column<LoopColumn>& column : choice_columns())
      section.cells.rows.back().push_back(written(column, column.value(table.columns[i])));
  }
  return section;
}

/// Texts stand in quotes, whether they need it or not.
std::string csv_of(const std::vector<ChoiceTable>& tables) {
  std::string csv = "scene,choice,decided,simulated,solver";
  for (const Column<LoopColumn>& column : choice_columns())
    csv += fmt::format(",\"{}\"", column.key);
  csv += '\n';
  for (const ChoiceTable& table : tables)
    for (std::size_t i = 0; i < choices().size(); ++i) {
      const LoopColumn& simulated = table.columns[i];
      csv += fmt::format("{},{},\"{}\",\"{}\",\"{}\"", table.scene, choices()[i].what,
                         choices()[i].way, simulated.question.scene, simulated.question.solver);
      for (const Column<LoopColumn>& column : choice_columns())
        csv += "," + written(column, column.value(simulated));
      csv += '\n';
    }
  return csv;
}

std::string json_of(const std::vector<ChoiceTable>& tables) {
  Cell rows = Cell::array();
  for (const ChoiceTable& table : tables)
    for (std::size_t i = 0; i < choices().size(); ++i)
      rows.push_back({{"scene", table.scene},
                      {"choice", choices()[i].what},
                      {"decided", choices()[i].way},
                      {"criterion", to_string(choices()[i].acceptance.criterion)},
                      {"tolerance", choices()[i].acceptance.tolerance},
                      {"fell", table.columns[i].fell()},
                      {"summary", figures_of(table.columns[i].summary)}});
  return Cell{{"rows", rows}}.dump(1) + "\n";
}

}  // namespace

const std::vector<Column<LoopColumn>>& choice_columns() {
  static const std::vector<Column<LoopColumn>> all = {
      {{"frames", "frames", "with contact"}, figure_named("total_frames")},
      {{"failures", "failed",
        "frictional LCPs not solved on the full LCP, at a natural residual of 1e-6 (the paper's "
        "constants and the last active-only row: by its criterion at 1e-3)"},
       figure_named("failure")},
      {{"frictionless failures", "smooth", "frictionless LCPs not solved"},
       figure_named("frictionless_failures")},
      {{"nodes a frame", "nodes", "opened a frame", "{:.1f}"}, nodes_a_frame},
      {{"violated contacts", "closing",
        "contacts that close faster than 1e-6 of the fastest under the forces that act"},
       figure_named("violated")},
      {{"residual, median", "resid.", "median natural residual of the solved", "{:.1e}"},
       figure_named("residual_median")},
      {{"penetration (mm)", "mm", "deepest penetration", "{:.3g}", 1e3}, figure_named("depth_max")},
      {{"fell", "fell", "tilted by more than 45 degrees, or ended early"},
       [](const LoopColumn& column) { return Cell(column.fell()); }}};
  return all;
}

const std::vector<Choice>& choices() {
  static const std::vector<Choice> all = {
      {"none", "our defaults", "", "best-first", {}},
      {"constants", "the paper's", "", proposed_solver, by_paper},
      {"pivot tolerance", "0", "", "best-first:pivot=0", {}},
      {"pivot tolerance", "1e-10", "", "best-first:pivot=1e-10", {}},
      {"pivot tolerance", "1e-8", "", "best-first:pivot=1e-8", {}},
      {"order of equals", "by row", "", "best-first:order=row", {}},
      {"order of equals", "lexicographic", "", "best-first-lexicographic", {}},
      {"ties of cost", "newest first", "", "best-first:ties=lifo", {}},
      {"ties of cost", "oldest first, 1000 nodes", "", "best-first:ties=fifo,max_nodes=1000", {}},
      {"cost", "as printed, 1000 nodes", "", "best-first-uniform:max_nodes=1000", {}},
      {"cost grid", "1e-9", "", "best-first:cost_grid=1e-9", {}},
      {"cost grid", "1e-12", "", "best-first:cost_grid=1e-12", {}},
      {"epsilon", "1e-6", "", "best-first:epsilon=1e-6", {}},
      {"epsilon", "1e-8", "", "best-first:epsilon=1e-8", {}},
      {"epsilon", "1e-12", "", "best-first:epsilon=1e-12", {}},
      {"refactorisation", "at every node", "", "best-first:refactor_every=1", {}},
      {"active contacts", "only, judged in full", "active_only=on", "best-first", {}},
      {"active contacts", "only, never looked at again", "active_only=on", proposed_solver,
       by_paper},
      {"matrix", "of the composite body", "matrix=clean", "best-first", {}},
      {"start", "cold", "start=cold", "best-first", {}},
      {"start", "all active normals", "start=all-active", "best-first", {}},
      {"reduction", "none", "reduction=none", "best-first", {}},
      {"reduction", "paper", "reduction=paper", "best-first", {}},
      {"reduction", "deepest 4 of each sole", "reduction=deepest-4", "best-first", {}},
      {"friction axes", "fixed", "axes=fixed", "best-first", {}},
      {"stepping", "semi-implicit", "scheme=semi-implicit", "best-first", {}},
  };
  return all;
}

std::optional<std::vector<ChoiceTable>> decide_each_way(const Reproduction& how,
                                                        const std::atomic<bool>& interrupted) {
  const PaperDirectory directory(how);
  const char* const scenes[] = {"squat", "tap-dance"};
  std::vector<LoopQuestion> questions;
  for (const char* scene : scenes)
    for (const Choice& choice : choices()) questions.push_back(question(scene, choice));
  compute_loop_columns(directory, questions, interrupted);
  if (interrupted) return std::nullopt;
  std::vector<ChoiceTable> tables;
  auto next = questions.begin();
  for (const char* scene : scenes) {
    tables.push_back({scene, {}});
    for (std::size_t i = 0; i < choices().size(); ++i)
      tables.back().columns.push_back(read_loop_column(directory, *next++).value());
  }
  return tables;
}

PaperPage page_of(const std::vector<ChoiceTable>& tables) {
  PaperPage page{{}, {}, csv_of(tables), json_of(tables)};
  for (const ChoiceTable& table : tables) page.sections.push_back(section_of(table));
  page.notes = {
      "Every row drives its own simulation. A row differs from the first in its choice alone."};
  for (const Column<LoopColumn>& column : choice_columns())
    page.notes.push_back(fmt::format("{:<6}  {}", column.heading, column.meaning));
  return page;
}

}  // namespace lcp
