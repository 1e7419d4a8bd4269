#include "harness/studies/loop/loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/observed_quantile.h"
#include "harness/present/columns.h"

namespace lcp {

namespace {

constexpr double kForceWindow = 0.02;  // s
constexpr Index kFileParts = 50;       // of the duration, in files
constexpr double kMillimetres = 1e3;   // in a metre
constexpr double kWhenever = std::numeric_limits<double>::infinity();

std::string fate(const Track& track) {
  if (track.broken.empty()) return fmt::format("went to {:g} s", track.simulated());
  if (track.stopped) return track.broken;
  return fmt::format("broke at t = {:g} s: {}", track.simulated(), track.broken);
}

Cell residual_of(const DriftLine& line, double quantile) {
  std::vector<double> known;
  for (const double residual : line.track.residual)
    if (!std::isnan(residual)) known.push_back(residual);
  return cell_of(observed_quantile(known, quantile));
}

/// The largest of a kind of drift, `scale` times.
Column<DriftLine> largest_column(ColumnHead head, double Drift::*field, double scale) {
  head.number = "{:.2g}";
  return {std::move(head), [=](const DriftLine& line) {
            return cell_of(scale * (largest(line.drifts, kWhenever).*field));
          }};
}

std::vector<Column<DriftLine>> line_columns(double departure) {
  const auto of_track = [](auto value) {
    return [value](const DriftLine& line) -> Cell { return std::invoke(value, line.track); };
  };
  return {
      {{"label", "in the loop"}, &DriftLine::label},
      {{"control"}, &DriftLine::control},
      {{"scene"}, of_track(&Track::scene)},
      {{"solver"}, of_track(&Track::solver)},
      {{"dt_s"}, of_track(&Track::dt)},
      {{"simulated_s"}, of_track(&Track::simulated)},
      {{"broken"}, of_track(&Track::broken)},
      {{"stopped"}, of_track(&Track::stopped)},
      {{"frames", "frames", "with contact"}, of_track(&Track::contact_frames)},
      {{"failed_frames", "failed",
        "their frictional LCP was not accepted: the frictionless answer acted, or none"},
       of_track(&Track::failed)},
      {{"residual_median", "resid", "median natural residual of the frictional answers, scaled",
        "{:.1e}"},
       [](const DriftLine& line) { return residual_of(line, 0.5); }},
      {{"residual_max", "max", "the largest of these residuals", "{:.1e}"},
       [](const DriftLine& line) { return residual_of(line, 1); }},
      {{"departed_s", "parts at",
        fmt::format(
            "when a link's centre of mass first was {:g} mm from where the reference has it",
            kMillimetres * departure),
        "{:.3g} s"},
       [=](const DriftLine& line) { return cell_of(departed(line, departure)); }},
      {{"end_mean_distance_mm", "mean mm", "distance of links at the end, mean", "{:.2g}"},
       [](const DriftLine& line) {
         return cell_of(line.drifts.empty() ? 0 : kMillimetres * line.drifts.back().mean_distance);
       }},
      largest_column({"distance_mm", "most mm", "the largest distance of any link at any time"},
                     &Drift::distance, kMillimetres),
      largest_column({"energy_J", "energy J", "largest difference of kinetic and potential energy"},
                     &Drift::energy, 1),
      largest_column({"depth_mm", "depth mm", "largest difference of the deepest overlap"},
                     &Drift::depth, kMillimetres),
      largest_column({"slip_mm"}, &Drift::slip, kMillimetres),
      {{"", "end"}, of_track(fate)}};
}

std::string csv_of(const LoopStudy& study) {
  std::string label;
  const auto drift = [](const char* key, double Drift::*field, double scale = kMillimetres) {
    return Column<LoopSample>{{.key = key, .exact = "{:.4g}"},
                              [=](const LoopSample& s) { return scale * s.drift.*field; }};
  };
  const std::vector<Column<LoopSample>> columns = {
      {{"in_the_loop"}, [&label](const LoopSample&) { return label; }},
      {{.key = "until_s", .exact = "{:.6g}"}, &LoopSample::time},
      drift("distance_mm", &Drift::distance),
      drift("mean_distance_mm", &Drift::mean_distance),
      drift("energy_J", &Drift::energy, 1),
      drift("depth_mm", &Drift::depth),
      drift("slip_mm", &Drift::slip),
      {{.key = "residual", .exact = "{:.3g}"},
       [](const LoopSample& s) { return std::isnan(s.residual) ? Cell() : Cell(s.residual); }}};
  std::string csv = csv_head({columns.begin(), columns.end()});
  const double duration = study.lines.front().track.simulated();
  for (auto line = study.lines.begin() + 1; line != study.lines.end(); ++line) {
    label = line->label;
    csv += csv_rows(cells_of(columns, thinned(*line, duration, kFileParts)));
  }
  return csv;
}

}  // namespace

LoopStudy loop_study(const LoopPlan& plan, const std::function<void(const Progress&)>& progress,
                     const std::atomic<bool>& interrupted) {
  NamedScene scene = make_scene(plan.scene);
  if (plan.dt) scene.setup.stepping.dt = *plan.dt;
  if (plan.duration) scene.setup.duration = *plan.duration;
  const TrackedTask reference{scene, plan.reference, plan.limit, "reference", true};
  std::vector<TrackedTask> tasks = {reference, disturbed(reference, plan.disturbance), reference};
  tasks[1].name = fmt::format("reference, disturbed by {:g}", plan.disturbance);
  tasks[2].name = "reference, half the time step";
  tasks[2].scene.setup.stepping.dt /= 2;
  for (const std::string& solver : plan.solvers)
    tasks.push_back({scene, solver, plan.limit, solver});
  return {plan,
          DriftStudy{plan.acceptance, kForceWindow, plan.silence, progress, interrupted}.simulate(
              tasks)};
}

std::optional<double> departed(const DriftLine& line, double departure) {
  for (const Drift& each : line.drifts)
    if (!(each.distance < departure)) return each.time;
  return std::nullopt;
}

std::vector<LoopSample> thinned(const DriftLine& line, double duration, Index parts) {
  std::vector<LoopSample> samples;
  const double length = duration / static_cast<double>(parts);
  Index frame = 0;
  for (const Drift& each : line.drifts) {
    const double part = std::floor(each.time / length * (1 + 1e-9));
    const double end = std::min(duration, (part + 1) * length);
    if (samples.empty() || samples.back().time < end)
      samples.push_back({end, {}, std::numeric_limits<double>::quiet_NaN()});
    LoopSample& sample = samples.back();
    sample.drift = largest({sample.drift, each}, kWhenever);
    for (; frame < line.track.frames() && line.track.time(frame) <= each.time; ++frame)
      sample.residual = std::fmax(sample.residual, line.track.residual(frame));
  }
  return samples;
}

Described described(const LoopStudy& study) {
  const LoopPlan& plan = study.plan;
  const Track& reference = study.lines.front().track;
  const std::vector<Column<DriftLine>> columns = line_columns(plan.departure);
  const CellTable table = cells_of(columns, study.lines);
  Described all{.text = fmt::format("{} for {:g} s at {:g} ms, against {} in the loop\n{}\n",
                                    reference.scene, reference.simulated(), 1e3 * reference.dt,
                                    reference.solver, text_table(table)) +
                        legend(table),
                .csv = csv_of(study),
                .json = {{"scene", reference.scene},
                         {"reference", reference.solver},
                         {"dt_s", reference.dt},
                         {"duration_s", reference.simulated()},
                         {"criterion", to_string(plan.acceptance.criterion)},
                         {"tolerance", plan.acceptance.tolerance},
                         {"disturbance", plan.disturbance},
                         {"departure_mm", kMillimetres * plan.departure},
                         {"rows", Cell::array()}},
                .figure = loop_figure(study)};
  for (const DriftLine& line : study.lines) all.json["rows"].push_back(json_object(columns, line));
  return all;
}

}  // namespace lcp
