#include "harness/studies/paper/choices.h"

#include <fmt/format.h>

#include <algorithm>

#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp {

namespace {

constexpr const char* papers_constants = "best-first:epsilon=1e-3,e_max=1e-3,polish=off,scale=off";

LoopQuestion question(const std::string& scene, const Choice& choice,
                      std::optional<double> duration) {
  const std::string text = choice.knobs.empty() ? scene : fmt::format("{}:{}", scene, choice.knobs);
  return {make_scene(text).spelling, make_solver(choice.solver).spelling, choice.acceptance,
          duration};
}

struct Figure {
  const char* name;
  std::string (*text)(const LoopColumn&);
};

template <auto member>
std::string whole(const LoopColumn& column) {
  return fmt::format("{}", column.summary.*member);
}

std::string nodes_a_frame(const LoopColumn& column) {
  if (column.summary.total_frames == 0) return "-";
  return fmt::format("{:.1f}", static_cast<double>(column.summary.nodes) /
                                   static_cast<double>(column.summary.total_frames));
}

std::string fell(const LoopColumn& column) { return column.fell() ? "yes" : "no"; }

std::string penetration(const LoopColumn& column) {
  return fmt::format("{:.3g}", 1e3 * column.summary.depth_max);
}

std::string residual(const LoopColumn& column) {
  return fmt::format("{:.1e}", column.summary.residual_median);
}

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all = {
      {"frames", whole<&LoopSummary::total_frames>},
      {"failures", whole<&LoopSummary::failure>},
      {"frictionless failures", whole<&LoopSummary::frictionless_failures>},
      {"nodes a frame", nodes_a_frame},
      {"violated contacts", whole<&LoopSummary::violated>},
      {"residual, median", residual},
      {"penetration (mm)", penetration},
      {"fell", fell}};
  return all;
}

std::string text_of(const std::vector<ChoiceTable>& tables) {
  std::string text;
  for (const ChoiceTable& table : tables) {
    text += fmt::format("{}\n{:<17} {:<28}", table.scene, "choice", "decided");
    for (const char* head :
         {"frames", "failed", "frictionless", "nodes", "violated", "residual", "mm", "fell"})
      text += fmt::format(" {:>12}", head);
    text += '\n';
    std::string before;
    for (std::size_t i = 0; i < choices().size(); ++i) {
      const Choice& choice = choices()[i];
      text += fmt::format("{:<17} {:<28}", choice.what == before ? "" : choice.what, choice.way);
      before = choice.what;
      for (const Figure& figure : figures())
        text += fmt::format(" {:>12}", figure.text(table.columns[i]));
      text += '\n';
    }
    text += '\n';
  }
  text +=
      "Every row drives its own simulation. A row differs from the first in its choice alone.\n"
      "frames        with contact\n"
      "failed        frictional LCPs not solved on the full LCP, at a natural residual of 1e-6 "
      "(the\n"
      "              paper's constants and the last active-only row: by its criterion at 1e-3)\n"
      "frictionless  frictionless LCPs not solved\n"
      "nodes         opened a frame\n"
      "violated      contacts that close faster than 1e-6 of the fastest under the forces that "
      "act\n"
      "residual      median natural residual of the solved\n"
      "mm            deepest penetration\n"
      "fell          tilted by more than 45 degrees, or ended early\n";
  return text;
}

std::string csv_of(const std::vector<ChoiceTable>& tables) {
  std::string csv = "scene,choice,decided,simulated,solver";
  for (const Figure& figure : figures()) csv += fmt::format(",\"{}\"", figure.name);
  csv += '\n';
  for (const ChoiceTable& table : tables)
    for (std::size_t i = 0; i < choices().size(); ++i) {
      const LoopColumn& column = table.columns[i];
      csv += fmt::format("{},{},\"{}\",\"{}\",\"{}\"", table.scene, choices()[i].what,
                         choices()[i].way, column.question.scene, column.question.solver);
      for (const Figure& figure : figures()) csv += fmt::format(",{}", figure.text(column));
      csv += '\n';
    }
  return csv;
}

std::string json_of(const std::vector<ChoiceTable>& tables) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const ChoiceTable& table : tables)
    for (std::size_t i = 0; i < choices().size(); ++i) {
      nlohmann::ordered_json row = {{"scene", table.scene},
                                    {"choice", choices()[i].what},
                                    {"decided", choices()[i].way},
                                    {"criterion", to_string(choices()[i].acceptance.criterion)},
                                    {"tolerance", choices()[i].acceptance.tolerance},
                                    {"fell", table.columns[i].fell()}};
      row["summary"] = figures_of(table.columns[i].summary);
      rows.push_back(std::move(row));
    }
  return nlohmann::ordered_json{{"rows", rows}}.dump(1) + "\n";
}

std::string latex_of(const std::vector<ChoiceTable>& tables) {
  std::string latex;
  for (const ChoiceTable& table : tables) {
    latex += fmt::format("% {}\n\\begin{{tabular}}{{ll{}}}\nchoice & decided", table.scene,
                         std::string(figures().size(), 'r'));
    for (const Figure& figure : figures()) latex += fmt::format(" & {}", figure.name);
    latex += " \\\\\n\\hline\n";
    for (std::size_t i = 0; i < choices().size(); ++i) {
      latex += fmt::format("{} & {}", choices()[i].what, choices()[i].way);
      for (const Figure& figure : figures())
        latex += fmt::format(" & {}", figure.text(table.columns[i]));
      latex += " \\\\\n";
    }
    latex += "\\end{tabular}\n";
  }
  return latex;
}

}  // namespace

const std::vector<Choice>& choices() {
  static const std::vector<Choice> all = {
      {"none", "our defaults", "", "best-first", {}},
      {"constants", "the paper's", "", papers_constants, by_paper},
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
      {"active contacts", "only, never looked at again", "active_only=on", papers_constants,
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
                                                        std::optional<double> duration,
                                                        const std::atomic<bool>& interrupted) {
  const PaperDirectory directory(how.directory, how.jobs, how.note);
  const std::vector<std::string> names = {"squat", "tap-dance"};
  std::vector<LoopQuestion> open;
  for (const std::string& scene : names)
    for (const Choice& choice : choices()) {
      const LoopQuestion each = question(scene, choice, duration);
      if (!read_loop_column(directory, each) &&
          std::find(open.begin(), open.end(), each) == open.end())
        open.push_back(each);
    }
  compute_loop_columns(directory, open, how.jobs, how.progress, interrupted);
  if (interrupted) return std::nullopt;
  std::vector<ChoiceTable> tables;
  for (const std::string& scene : names) {
    tables.push_back({scene, {}});
    for (const Choice& choice : choices())
      tables.back().columns.push_back(
          read_loop_column(directory, question(scene, choice, duration)).value());
  }
  return tables;
}

std::string render(const std::vector<ChoiceTable>& tables, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return text_of(tables);
    case TableFormat::csv:
      return csv_of(tables);
    case TableFormat::json:
      return json_of(tables);
    case TableFormat::latex:
      break;
  }
  return latex_of(tables);
}

}  // namespace lcp
