#include "harness/studies/sufficient/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "harness/present/columns.h"

namespace lcp {

namespace {

constexpr double kPercent = 100;

std::vector<ModelRow> all_rows(const Study& study) {
  std::vector<ModelRow> rows = {study.reference, study.disturbed};
  rows.insert(rows.end(), study.rows.begin(), study.rows.end());
  return rows;
}

std::string label_of(const ModelRow& row) {
  return row.axis == "disturbed" ? "reference, disturbed" : row.model.label;
}

std::string verdict_of(const Study& study, const ModelRow& row) {
  if (row.axis == "reference") return "";
  if (row.axis == "disturbed") return "noise floor";
  std::string verdict;
  const std::vector<std::string> criteria = exceeded(row.error, study.plan.criteria);
  if (row.stopped)
    verdict = "not cheaper: " + row.broken;
  else if (!row.broken.empty())
    verdict = fmt::format("broke at t = {:g} s: {}", row.until, row.broken);
  if (!criteria.empty())
    return fmt::format("{}{}fails: {}", verdict, verdict.empty() ? "" : "; ",
                       fmt::join(criteria, ", "));
  if (!verdict.empty()) return verdict;
  return row.cheaper ? "passes" : "passes, saves nothing";
}

/// Of each kind the value of `of(kind)`: `trajectory 0.1 mm, force 2 % of the weight, ...`.
template <class Of>
std::string errors_of(const Of& of) {
  std::vector<std::string> parts;
  for (const ErrorKind& kind : error_kinds)
    parts.push_back(fmt::format("{} {:.2g} {}", kind.name, kind.scale * of(kind),
                                kind.error == &Drift::force ? "% of the weight" : kind.unit));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string errors_of(const Drift& error) {
  return errors_of([&](const ErrorKind& kind) { return error.*kind.error; });
}

std::string saved(const Saving& saving) {
  return fmt::format("{:.0f} % ({:.0f} to {:.0f})", kPercent * saving.all, kPercent * saving.low,
                     kPercent * saving.high);
}

std::string compared_over(const Study& study) {
  const StudyPlan& plan = study.plan;
  const std::string text = study.horizon == plan.duration
                               ? fmt::format(
                                     "Compared over {:g} s; up to there the disturbed reference "
                                     "stays within {:g} of each "
                                     "tolerance.\n",
                                     study.horizon, plan.floor_share)
                               : fmt::format(
                                     "Compared over {:g} s of {:g} s: then the disturbed reference "
                                     "is {:g} of a tolerance "
                                     "from itself, and later differences say nothing.\n",
                                     study.horizon, plan.duration, plan.floor_share);
  if (study.reference.frames > 0) return text;
  return text +
         "Nothing touches in this time, which says nothing of contact: try a longer --duration.\n";
}

std::string time_noise_of(const Study& study) {
  const auto share = [](double noise) { return fmt::format("{:.1f} %", kPercent * noise); };
  std::string text = share(std::abs(study.disturbed.step_saved.all)) + " more or less";
  double combined = -1;
  for (const ModelRow& row : study.rows)
    if (row.axis == "combination") combined = std::max(combined, row.time_noise);
  return combined < 0 ? text : text + ", beside combinations up to " + share(combined);
}

std::string conclusion(const Study& study) {
  if (!study.cheapest)
    return "Nothing cheaper than the reference is enough (a saving below the noise of times is "
           "none).\n";
  const ModelRow& row = study.rows[*study.cheapest];
  return fmt::format(
      "Cheapest that passes: {} ({} with {})\n  saves {} of a step's time, {} of the LCPs'\n"
      "  at an error of {}\n",
      row.model.label, row.model.scene, row.model.solver, saved(row.step_saved),
      saved(row.lcp_saved), errors_of(row.error));
}

/// One line for a table over several scenes.
std::string summary_line(const Study& study) {
  if (!study.cheapest)
    return fmt::format("{}: nothing cheaper is enough\n", study.plan.ladder.scene);
  const ModelRow& row = study.rows[*study.cheapest];
  return fmt::format(
      "{}: {}: n {:.1f} for {:.1f}, saves {:.0f} % of a step, {:.0f} % of the LCPs, "
      "error {:.2g} of the tolerance\n",
      study.plan.ladder.scene, row.model.label, row.n, study.reference.n,
      kPercent * row.step_saved.all, kPercent * row.lcp_saved.all,
      over_tolerance(row.error, study.plan.criteria));
}

std::string error_key(const ErrorKind& kind) { return fmt::format("{}_{}", kind.name, kind.unit); }

/// Of the text and CSV.
std::vector<Column<ModelRow>> model_columns(const Study& study) {
  std::vector<Column<ModelRow>> columns;
  const auto add = [&](ColumnHead head, const char* exact, double scale, auto value) {
    head.exact = exact;
    columns.push_back({std::move(head), [=](const ModelRow& row) -> Cell {
                         return scale * std::invoke(value, row);
                       }});
  };
  const auto add_as_it_is = [&](ColumnHead head, auto value) {
    columns.push_back({std::move(head), value});
  };
  add_as_it_is({"", "model"}, label_of);
  add_as_it_is({"scene"}, [&study](const ModelRow&) { return study.plan.ladder.scene; });
  add_as_it_is({"model"}, label_of);
  add_as_it_is({"axis"}, &ModelRow::axis);
  for (const ErrorKind& kind : error_kinds)
    add({error_key(kind), kind.heading, kind.meaning, "{:.2g}"}, "{:.4g}", kind.scale,
        [=](const ModelRow& row) { return row.error.*kind.error; });
  add({"error_over_tolerance"}, "{:.4g}", 1,
      [&study](const ModelRow& row) { return over_tolerance(row.error, study.plan.criteria); });
  add({"n", "n", "size of the frictional LCP, mean over frames with contact", "{:.1f}"}, "{:.1f}",
      1, &ModelRow::n);
  add_as_it_is({"frames"}, &ModelRow::frames);
  add_as_it_is({"failed_frames", "failed", "frames whose frictional LCP failed"},
               &ModelRow::failed);
  add({"lcp_ms_per_s", "LCP ms/s", "processor time of LCPs per simulated second", "{:.1f}"},
      "{:.4g}", 1e3, &ModelRow::lcp);
  add({"step_ms_per_s", "step ms/s", "the same of whole steps", "{:.1f}"}, "{:.4g}", 1e3,
      &ModelRow::step);
  const auto add_saving = [&](ColumnHead head, Saving ModelRow::*saving, double Saving::*end) {
    add(std::move(head), "{:.1f}", kPercent, [=](const ModelRow& r) { return r.*saving.*end; });
  };
  add_saving({"lcp_saved_percent", "LCP -%", "part of the reference's time of LCPs that is saved"},
             &ModelRow::lcp_saved, &Saving::all);
  add_saving({"step_saved_percent", "step -%", "and of steps"}, &ModelRow::step_saved,
             &Saving::all);
  add_saving({"step_saved_low"}, &ModelRow::step_saved, &Saving::low);
  add_saving({"step_saved_high"}, &ModelRow::step_saved, &Saving::high);
  add({"time_noise_percent"}, "{:.1f}", kPercent, &ModelRow::time_noise);
  add({"until_s"}, "{:.6g}", 1, &ModelRow::until);
  add_as_it_is({"verdict", "verdict"},
               [&study](const ModelRow& row) { return verdict_of(study, row); });
  return columns;
}

Cell json_of(const Saving& saving) {
  return {{"all", saving.all}, {"low", saving.low}, {"high", saving.high}};
}

Cell json_of(const Study& study, const ModelRow& row) {
  Cell json = {{"label", label_of(row)},
               {"axis", row.axis},
               {"scene", row.model.scene},
               {"solver", row.model.solver}};
  for (const ErrorKind& kind : error_kinds)
    json[error_key(kind)] = kind.scale * row.error.*kind.error;
  json.update(Cell{{"error_over_tolerance", over_tolerance(row.error, study.plan.criteria)},
                   {"fails", exceeded(row.error, study.plan.criteria)},
                   {"until_s", row.until},
                   {"broken", row.broken},
                   {"stopped", row.stopped},
                   {"frames", row.frames},
                   {"failed_frames", row.failed},
                   {"n", row.n},
                   {"lcp_ms_per_s", 1e3 * row.lcp},
                   {"step_ms_per_s", 1e3 * row.step},
                   {"lcp_saved", json_of(row.lcp_saved)},
                   {"step_saved", json_of(row.step_saved)},
                   {"time_noise", row.time_noise},
                   {"passes", row.passes},
                   {"cheaper", row.cheaper}});
  return json;
}

Cell json_of(const Study& study) {
  const StudyPlan& plan = study.plan;
  Cell rows = Cell::array(), criteria;
  for (const ModelRow& row : all_rows(study)) rows.push_back(json_of(study, row));
  for (const ErrorKind& kind : error_kinds) {
    criteria[error_key(kind)] = kind.scale * plan.criteria.*kind.tolerance;
    if (kind.error == &Drift::force) criteria["window_s"] = plan.criteria.window;
  }
  return {{"scene", plan.ladder.scene},
          {"kept", plan.ladder.kept},
          {"criteria", criteria},
          {"duration_s", plan.duration},
          {"compared_s", study.horizon},
          {"disturbance", plan.disturbance},
          {"floor_share", plan.floor_share},
          {"rounds", plan.rounds},
          {"cheapest", study.cheapest ? Cell(study.rows[*study.cheapest].model.label) : Cell()},
          {"rows", rows}};
}

/// But for its table.
std::string introduction(const Study& study) {
  const StudyPlan& plan = study.plan;
  std::string text = fmt::format("{}: reference {} with {}\n", plan.ladder.scene,
                                 study.reference.model.scene, study.reference.model.solver);
  if (!plan.ladder.kept.empty())
    text += fmt::format("Kept as the scene has it: {}.\n", fmt::join(plan.ladder.kept, ", "));
  text += folded(fmt::format("The tolerances: {}.", errors_of([&](const ErrorKind& kind) {
                               return plan.criteria.*kind.tolerance;
                             })));
  text += compared_over(study);
  text += folded(
      fmt::format("Noise floor: the reference, its velocities disturbed by {:g}, differs by {}.",
                  plan.disturbance, errors_of(study.disturbed.error)));
  return text +
         folded(fmt::format("Times are processor time, of each frame the least of {} rounds. Their "
                            "noise: the disturbed reference takes {}.",
                            plan.rounds, time_noise_of(study)));
}

}  // namespace

Described described(const std::vector<Study>& studies) {
  Described all{.json = {{"studies", Cell::array()}}, .figure = figure_of(studies)};
  std::string explained, ends;
  for (const Study& study : studies) {
    const CellTable table = cells_of(model_columns(study), all_rows(study));
    all.text += introduction(study) + "\n" + text_table(table) + "\n" + conclusion(study) + "\n";
    explained = legend(table);
    all.csv += all.csv.empty() ? csv_text(table) : csv_rows(table);
    all.json["studies"].push_back(json_of(study));
    ends += summary_line(study);
  }
  all.text += explained;
  if (studies.size() > 1) all.text += "\nCheapest model that is enough:\n" + ends;
  return all;
}

}  // namespace lcp
