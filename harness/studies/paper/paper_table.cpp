#include "harness/studies/paper/paper_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lcp {

namespace {

// Columns of the hoist that are compared with one another.
constexpr const char *fine_hoist = "hoist", *coarse_hoist = "hoist:10ms";

/// The threshold of ties, where the solver has one.
nlohmann::json delta_of(const std::string& solver) {
  const NamedSolver named = make_solver(solver);  // which the options' getters refer to
  for (const Option& option : named.solver->options())
    if (option.name == "delta") return std::stod(option.get());
  return nullptr;
}

/// The object of one solver in the loop of a scene or on a corpus.
Cell row_object(const PublishedTable& published, const std::string& name, const std::string& solver,
                const std::string& corpus, const char* mode, const Acceptance& acceptance,
                nlohmann::json values) {
  values["delta"] = delta_of(solver);
  Cell row = {{"table", published.table},
              {"column", name},
              {"solver", solver},
              {"corpus", corpus},
              {"mode", mode},
              {"criterion", to_string(acceptance.criterion)},
              {"tolerance", acceptance.tolerance}};
  Cell stated;
  for (const PaperQuantity& quantity : paper_quantities()) {
    row[quantity.key] = values.value(quantity.key, nlohmann::json());
    if (const auto value = published.value(quantity.key, name))
      stated[quantity.key] = quantity.stated(value);
  }
  row["instances"] = row["total_frames"];
  if (!stated.is_null()) row["published"] = stated;
  return row;
}

Cell loop_object(const PublishedTable& published, const std::string& name,
                 const LoopColumn& column) {
  const LoopQuestion& question = column.question;
  Cell row = row_object(published, name, question.solver, question.scene, "in-loop",
                        question.acceptance, values_of(column));
  row["broken"] = column.summary.broken;
  row["jobs"] = column.jobs;
  row["environment"] = column.environment;
  row["commit"] = column.commit;
  return row;
}

/// Adds what the second table of Table III says.
void add_motion(Cell& row, const LoopSummary& summary, const LoopSummary& reference,
                double length) {
  const Motion motion = motion_of(summary, reference, length);
  row["fell"] = nullptr;  // The first link of a chain or a net may well turn over.
  row["survived"] = motion.survived;
  row["stopped"] = summary.stopped;
  row["off"] = cell_of(motion.distance);
  row["parted"] = cell_of(motion.parted);
}

void add_corpora(PaperTable& table, const PaperColumns& columns) {
  const std::string& scene = table.plan.scenes.front().scene;
  std::vector<std::string> corpora;
  for (const CorpusColumn& column : columns.by_paper)
    if (std::find(corpora.begin(), corpora.end(), column.corpus) == corpora.end())
      corpora.push_back(column.corpus);
  std::stable_partition(corpora.begin(), corpora.end(),
                        [&](const std::string& corpus) { return corpus == scene; });
  for (const std::string& corpus : corpora)
    for (const bool again : {false, true}) {
      PaperLayer layer{
          again ? "  at 1e-6" : "on corpus", corpus == scene ? "" : "corpus " + corpus, again, {}};
      for (const PaperColumn& solver : table.plan.solvers) {
        layer.rows.emplace_back();
        for (const CorpusColumn& found : again ? columns.by_residual : columns.by_paper)
          if (found.corpus == corpus && found.solver == solver.solver)
            layer.rows.back() = row_object(table.published, solver.name, solver.solver, corpus,
                                           "corpus", again ? second_look : by_paper, found.values);
      }
      table.layers.push_back(std::move(layer));
    }
}

void add_hoists(PaperTable& table, const PaperColumns& columns) {
  const auto place = [&](const char* name) {
    std::size_t at = 0;
    while (at < table.columns.size() && table.columns[at].name != name) ++at;
    return at;
  };
  table.told_ratio = cell_of(table.published.value("time_ratio", fine_hoist));
  table.printed_ratio = cell_of(printed_time_ratio(table.published));
  for (std::size_t i = 0; i < table.plan.solvers.size(); ++i) {
    const PaperColumn& solver = table.plan.solvers[i];
    if (solver.limit) continue;
    const LoopSummary& fine = columns.in_loop[i].at(place(fine_hoist)).summary;
    const LoopSummary& coarse = columns.in_loop[i].at(place(coarse_hoist)).summary;
    table.hoists.push_back(
        {solver.heading, solver.solver, cell_of(time_ratio(fine, coarse)),
         cell_of(end_distance(fine, coarse, columns.lengths.at(place(fine_hoist))))});
  }
}

}  // namespace

PaperTable set_together(const PaperPlan& plan, const PaperColumns& columns) {
  PaperTable table;
  table.plan = plan;
  table.published = published().table(plan.table);
  table.source = published().source;
  const bool by_scene = plan.by_scene();
  for (const PaperScene& each : plan.scenes)
    if (by_scene) table.columns.push_back({each.name, each.name, ""});
  if (!by_scene) table.columns = plan.solvers;
  const std::size_t lines = by_scene ? plan.solvers.size() : plan.scenes.size();
  for (std::size_t line = 0; line < lines; ++line) {
    PaperLayer layer{by_scene ? plan.solvers[line].heading : plan.scenes[line].name, "", false, {}};
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const auto [by, at] = by_scene ? std::pair(line, i) : std::pair(i, line);
      const PaperColumn& solver = plan.solvers[by];
      const LoopColumn& column = columns.in_loop[by][at];
      const LoopSummary& summary = column.summary;
      Cell row = loop_object(table.published, table.columns[i].name, column);
      if (by_scene)
        add_motion(row, summary, columns.in_loop[reference_solver][at].summary,
                   columns.lengths[at]);
      if (solver.limit) layer.section = rest_section;
      layer.rows.push_back(std::move(row));
      table.jobs = std::max(table.jobs, column.jobs);
      // The second table says when; of its solvers only those without a frame.
      if (!summary.broken.empty() && (!solver.limit || summary.steps == 0))
        table.broken.push_back(fmt::format("{}{}{} ended early: {}", solver.heading,
                                           by_scene ? " in " : " ", plan.scenes[at].name,
                                           summary.broken));
    }
    table.layers.push_back(std::move(layer));
  }
  for (const LoopColumn& column : columns.sweep)
    table.sweep.push_back(loop_object(table.published, column.question.solver, column));
  add_corpora(table, columns);
  if (by_scene) add_hoists(table, columns);
  return table;
}

std::vector<PaperLine> lines_of(const PaperTable& table, const PaperQuantity& quantity,
                                const std::string& section) {
  std::vector<PaperLine> lines;
  const auto add = [&](const std::string& label, const auto& cell_at) {
    PaperLine line{label, {}};
    bool any = false;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      line.cells.push_back(cell_at(i));
      any = any || !line.cells.back().value.is_null();
    }
    if (any) lines.push_back(std::move(line));
  };
  if (section.empty())
    add(table.published.at_most(quantity.key) ? "text: at most" : "published", [&](std::size_t i) {
      return PaperCell{cell_of(table.published.value(quantity.key, table.columns[i].name))};
    });
  for (const PaperLayer& layer : table.layers)
    if (layer.section == section && (quantity.judged || !layer.second_look))
      add(layer.label, [&](std::size_t i) -> PaperCell {
        if (layer.rows[i].is_null()) return {};
        const Cell& value = layer.rows[i].at(quantity.key);
        return {value, !value.is_null() &&
                           table.published.departs(quantity.key, table.columns[i].name, value)};
      });
  return lines;
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

std::optional<double> printed_time_ratio(const PublishedTable& published) {
  double total[2] = {};
  for (const bool coarse : {false, true}) {
    const char* column = coarse ? coarse_hoist : fine_hoist;
    const auto time = published.value("simulation_time_ms", column);
    const auto frames = published.value("total_frames", column);
    if (!time || !frames) return std::nullopt;
    total[coarse] = *time * *frames;
  }
  return total[0] / total[1];
}

std::optional<double> time_ratio(const LoopSummary& fine, const LoopSummary& coarse) {
  const auto total = [](const LoopSummary& summary) {
    return summary.simulation_ms * static_cast<double>(summary.total_frames);
  };
  if (!fine.broken.empty() || !coarse.broken.empty() || total(coarse) == 0) return std::nullopt;
  return total(fine) / total(coarse);
}

std::optional<double> end_distance(const LoopSummary& fine, const LoopSummary& coarse,
                                   double length) {
  const double distance = mean_link_distance(fine, coarse, 1);
  if (!fine.broken.empty() || !coarse.broken.empty() || std::isnan(distance)) return std::nullopt;
  return distance / length;
}

Motion motion_of(const LoopSummary& motion, const LoopSummary& reference, double length) {
  Motion found{static_cast<double>(motion.steps) * motion.dt, {}, {}};
  for (Index part = 0; part <= trail_parts; ++part) {
    const double share = static_cast<double>(part) / static_cast<double>(trail_parts);
    const double distance = mean_link_distance(motion, reference, share) / length;
    if (std::isnan(distance)) break;
    found.distance = distance;
    if (!found.parted && distance > same_motion) found.parted = share * motion.duration;
  }
  return found;
}

}  // namespace lcp
