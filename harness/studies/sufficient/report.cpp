#include "harness/studies/sufficient/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/present/escaping.h"

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

constexpr double mm = 1e3, percent = 100;

std::vector<const ModelRow*> all_rows(const Study& study) {
  std::vector<const ModelRow*> rows = {&study.reference, &study.disturbed};
  for (const ModelRow& row : study.rows) rows.push_back(&row);
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

std::string errors_of(const PhysicalError& error) {
  return fmt::format(
      "trajectory {:.2g} mm, force {:.2g} % of the weight, penetration {:.2g} mm, "
      "slip {:.2g} mm",
      mm * error.trajectory, percent * error.force, mm * error.penetration, mm * error.slip);
}

std::string saved(const Saving& saving) {
  return fmt::format("{:.0f} % ({:.0f} to {:.0f})", percent * saving.all, percent * saving.low,
                     percent * saving.high);
}

std::string compared_over(const Study& study) {
  const StudyPlan& plan = study.plan;
  const char* untouched =
      study.reference.frames > 0
          ? ""
          : "Nothing touches in this time, which says nothing of contact: try a longer "
            "--duration.\n";
  if (study.horizon == plan.duration)
    return fmt::format(
        "Compared over {:g} s; up to there the disturbed reference stays within {:g} of each "
        "tolerance.\n{}",
        study.horizon, plan.floor_share, untouched);
  return fmt::format(
      "Compared over {:g} s of {:g} s: then the disturbed reference is {:g} of a tolerance from "
      "itself, and later differences say nothing.\n{}",
      study.horizon, plan.duration, plan.floor_share, untouched);
}

std::string time_noise_of(const Study& study) {
  const auto share = [](double noise) { return fmt::format("{:.1f} %", percent * noise); };
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
std::string summary_line(const Study& study, std::size_t width) {
  const std::string name = fmt::format("{:<{}}", study.plan.ladder.scene, width);
  if (!study.cheapest) return fmt::format("{}  nothing cheaper is enough\n", name);
  const ModelRow& row = study.rows[*study.cheapest];
  return fmt::format(
      "{}  {}: n {:.1f} for {:.1f}, saves {:.0f} % of a step, {:.0f} % of the LCPs, "
      "error {:.2g} of the tolerance\n",
      name, row.model.label, row.n, study.reference.n, percent * row.step_saved.all,
      percent * row.lcp_saved.all, over_tolerance(row.error, study.plan.criteria));
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const Saving& saving) {
  return {{"all", number(saving.all)}, {"low", number(saving.low)}, {"high", number(saving.high)}};
}

Json to_json(const Study& study, const ModelRow& row) {
  return {{"label", label_of(row)},
          {"axis", row.axis},
          {"scene", row.model.scene},
          {"solver", row.model.solver},
          {"trajectory_mm", number(mm * row.error.trajectory)},
          {"force_percent", number(percent * row.error.force)},
          {"penetration_mm", number(mm * row.error.penetration)},
          {"slip_mm", number(mm * row.error.slip)},
          {"error_over_tolerance", number(over_tolerance(row.error, study.plan.criteria))},
          {"fails", exceeded(row.error, study.plan.criteria)},
          {"until_s", row.until},
          {"broken", row.broken},
          {"stopped", row.stopped},
          {"frames", row.frames},
          {"failed_frames", row.failed},
          {"n", row.n},
          {"lcp_ms_per_s", number(1e3 * row.lcp)},
          {"step_ms_per_s", number(1e3 * row.step)},
          {"lcp_saved", to_json(row.lcp_saved)},
          {"step_saved", to_json(row.step_saved)},
          {"time_noise", number(row.time_noise)},
          {"passes", row.passes},
          {"cheaper", row.cheaper}};
}

Json to_json(const Study& study) {
  const StudyPlan& plan = study.plan;
  Json rows = Json::array();
  for (const ModelRow* row : all_rows(study)) rows.push_back(to_json(study, *row));
  return {{"scene", plan.ladder.scene},
          {"kept", plan.ladder.kept},
          {"criteria",
           {{"trajectory_mm", mm * plan.criteria.trajectory},
            {"force_percent", percent * plan.criteria.force},
            {"window_s", plan.criteria.window},
            {"penetration_mm", mm * plan.criteria.penetration},
            {"slip_mm", mm * plan.criteria.slip}}},
          {"duration_s", plan.duration},
          {"compared_s", study.horizon},
          {"disturbance", plan.disturbance},
          {"floor_share", plan.floor_share},
          {"rounds", plan.rounds},
          {"cheapest", study.cheapest ? Json(study.rows[*study.cheapest].model.label) : Json()},
          {"rows", rows}};
}

std::string to_csv(const std::vector<Study>& studies) {
  std::string csv =
      "scene,model,axis,trajectory_mm,force_percent,penetration_mm,slip_mm,error_over_tolerance,n,"
      "frames,failed_frames,lcp_ms_per_s,step_ms_per_s,lcp_saved_percent,step_saved_percent,"
      "step_saved_low,step_saved_high,time_noise_percent,until_s,verdict\n";
  for (const Study& study : studies)
    for (const ModelRow* row : all_rows(study))
      csv += fmt::format(
          "{},{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.1f},{},{},{:.4g},{:.4g},{:.1f},{:.1f},"
          "{:.1f},{:.1f},{:.1f},{:.6g},{}\n",
          csv_quoted(study.plan.ladder.scene), csv_quoted(label_of(*row)), row->axis,
          mm * row->error.trajectory, percent * row->error.force, mm * row->error.penetration,
          mm * row->error.slip, over_tolerance(row->error, study.plan.criteria), row->n,
          row->frames, row->failed, 1e3 * row->lcp, 1e3 * row->step, percent * row->lcp_saved.all,
          percent * row->step_saved.all, percent * row->step_saved.low,
          percent * row->step_saved.high, percent * row->time_noise, row->until,
          csv_quoted(verdict_of(study, *row)));
  return csv;
}

}  // namespace

std::string render_text(const Study& study) {
  const StudyPlan& plan = study.plan;
  std::string text = fmt::format("{}: reference {} with {}\n", plan.ladder.scene,
                                 study.reference.model.scene, study.reference.model.solver);
  if (!plan.ladder.kept.empty())
    text += fmt::format("Kept as the scene has it: {}.\n", fmt::join(plan.ladder.kept, ", "));
  text += compared_over(study);
  text += fmt::format(
      "Noise floor: the reference, its velocities disturbed by {:g}, differs by {}.\n"
      "Times are processor time, of each frame the least of {} rounds. Their noise: the disturbed "
      "reference takes {}.\n\n",
      plan.disturbance, errors_of(study.disturbed.error), plan.rounds, time_noise_of(study));
  std::size_t width = 5;
  for (const ModelRow* row : all_rows(study)) width = std::max(width, label_of(*row).size());
  text += fmt::format("{:<{}} {:>9} {:>9} {:>9} {:>9} {:>6} {:>6} {:>9} {:>9} {:>7} {:>6}  {}\n",
                      "model", width, "traj mm", "force %", "depth mm", "slip mm", "n", "failed",
                      "LCP ms/s", "step ms/s", "LCP -%", "step-%", "verdict");
  for (const ModelRow* row : all_rows(study))
    text += fmt::format(
        "{:<{}} {:>9.2g} {:>9.2g} {:>9.2g} {:>9.2g} {:>6.1f} {:>6} {:>9.1f} {:>9.1f} {:>7.0f} "
        "{:>6.0f}  {}\n",
        label_of(*row), width, mm * row->error.trajectory, percent * row->error.force,
        mm * row->error.penetration, mm * row->error.slip, row->n, row->failed, 1e3 * row->lcp,
        1e3 * row->step, percent * row->lcp_saved.all, percent * row->step_saved.all,
        verdict_of(study, *row));
  text += fmt::format("{:<{}} {:>9.2g} {:>9.2g} {:>9.2g} {:>9.2g}  tolerances\n\n", "", width,
                      mm * plan.criteria.trajectory, percent * plan.criteria.force,
                      mm * plan.criteria.penetration, mm * plan.criteria.slip);
  return text + conclusion(study);
}

std::string render(const std::vector<Study>& studies, TableFormat format) {
  if (format == TableFormat::csv) return to_csv(studies);
  if (format == TableFormat::json) {
    Json all = Json::array();
    for (const Study& study : studies) all.push_back(to_json(study));
    return Json{{"studies", all}}.dump(1) + "\n";
  }
  if (format != TableFormat::text)
    throw std::invalid_argument("sufficient: expected text, csv or json");
  std::string text;
  std::size_t width = 0;
  for (const Study& study : studies) {
    text += render_text(study) + "\n";
    width = std::max(width, study.plan.ladder.scene.size());
  }
  text +=
      "  traj mm    largest distance of a link's centre of mass from the reference's\n"
      "  force %    contact force on a mechanism (links held together by joints), averaged, over "
      "the "
      "weight: largest difference\n"
      "  depth mm   largest difference of the deepest overlap\n"
      "  slip mm    largest difference of the way that a link slipped on its contacts\n"
      "  n          size of the frictional LCP, mean over frames with contact\n"
      "  failed     frames whose frictional LCP failed\n"
      "  LCP ms/s   processor time of LCPs, and of whole steps, per simulated second\n"
      "  LCP -%     part of the reference's time of LCPs that is saved, and of steps\n";
  if (studies.size() == 1) return text;
  text += "\nCheapest model that is enough:\n";
  for (const Study& study : studies) text += summary_line(study, width);
  return text;
}

}  // namespace lcp
