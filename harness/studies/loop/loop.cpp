#include "harness/studies/loop/loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/observed_quantile.h"
#include "harness/present/escaping.h"
#include "harness/studies/loop/tracked_runs.h"

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kForceWindow = 0.02;  // s
constexpr Index kFileParts = 50;       // of the duration, in files
constexpr double kMillimetres = 1e3;   // in a metre

NamedScene scene_of(const LoopPlan& plan) {
  NamedScene scene = make_scene(plan.scene);
  if (plan.dt) scene.setup.stepping.dt = *plan.dt;
  if (plan.duration) scene.setup.duration = *plan.duration;
  return scene;
}

std::vector<TrackedTask> tasks_of(const LoopPlan& plan) {
  const NamedScene scene = scene_of(plan);
  const TrackedTask reference{scene, plan.reference, plan.limit, "reference"};
  TrackedTask disturbed = reference, halved = reference;
  disturb_start(disturbed.scene, plan.disturbance);
  disturbed.name = fmt::format("reference, disturbed by {:g}", plan.disturbance);
  halved.scene.setup.stepping.dt /= 2;
  halved.name = "reference, half the time step";
  std::vector<TrackedTask> tasks = {reference, disturbed, halved};
  for (const std::string& solver : plan.solvers)
    tasks.push_back({scene, solver, plan.limit, solver});
  return tasks;
}

std::vector<double> residuals(const Track& track) {
  std::vector<double> known;
  for (const double r : track.residual)
    if (!std::isnan(r)) known.push_back(r);
  return known;
}

std::string fate(const Track& track) {
  if (track.broken.empty()) return fmt::format("went to {:g} s", track.simulated());
  if (track.stopped) return track.broken;
  return fmt::format("broke at t = {:g} s: {}", track.simulated(), track.broken);
}

/// What a line comes to.
struct Figures {
  std::optional<double> departed;
  std::optional<double> residual_median, residual_max;
  Drift most, end;
};

Figures figures_of(const LoopLine& line, double departure) {
  const std::vector<double> known = residuals(line.track);
  return {departed(line, departure), observed_quantile(known, 0.5), observed_quantile(known, 1.0),
          largest(line.drifts, std::numeric_limits<double>::infinity()),
          line.drifts.empty() ? Drift{} : line.drifts.back()};
}

std::string or_dash(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

Json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

std::string to_text(const LoopStudy& study) {
  const LoopPlan& plan = study.plan;
  std::string text =
      fmt::format("{} for {:g} s at {:g} ms, against {} in the loop\n", study.reference.scene,
                  study.reference.simulated(), 1e3 * study.reference.dt, study.reference.solver);
  if (!study.reference.broken.empty())
    text += fmt::format("  the reference ended early: {}\n", study.reference.broken);
  const LoopLine as_line{"reference", true, study.reference, {}};
  std::size_t width = 9;
  for (const LoopLine& line : study.lines) width = std::max(width, line.label.size());
  text += fmt::format("\n{:<{}} {:>7} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}  {}\n",
                      "in the loop", width, "frames", "failed", "resid", "max", "parts at",
                      "mean mm", "most mm", "energy J", "depth mm", "end");
  const auto add = [&](const LoopLine& line, bool drifts) {
    const Figures f = figures_of(line, plan.departure);
    text += fmt::format(
        "{:<{}} {:>7} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}  {}\n", line.label, width,
        line.track.contact_frames, line.track.failed, or_dash(f.residual_median, "{:.1e}"),
        or_dash(f.residual_max, "{:.1e}"), drifts ? or_dash(f.departed, "{:.3g} s") : "",
        drifts ? fmt::format("{:.2g}", kMillimetres * f.end.mean_distance) : "",
        drifts ? fmt::format("{:.2g}", kMillimetres * f.most.distance) : "",
        drifts ? fmt::format("{:.2g}", f.most.energy) : "",
        drifts ? fmt::format("{:.2g}", kMillimetres * f.most.depth) : "", fate(line.track));
  };
  add(as_line, false);
  for (const LoopLine& line : study.lines) add(line, true);
  text += fmt::format(
      "\n  frames    with contact\n"
      "  failed    their frictional LCP was not accepted: the frictionless answer acted, or none\n"
      "  resid     median natural residual of the frictional answers, scaled; max: the largest\n"
      "  parts at  when a link's centre of mass first was {:g} mm from where the reference has it\n"
      "  mean mm   distance of links at the end, mean; most mm: the largest of any link at any "
      "time\n"
      "  energy J  largest difference of kinetic and potential energy\n"
      "  depth mm  largest difference of the deepest overlap\n",
      kMillimetres * plan.departure);
  return text;
}

std::string to_csv(const LoopStudy& study) {
  std::string csv =
      "in_the_loop,until_s,distance_mm,mean_distance_mm,energy_J,depth_mm,slip_mm,residual\n";
  for (const LoopLine& line : study.lines)
    for (const LoopSample& s : thinned(line, study.reference.simulated(), kFileParts))
      csv +=
          fmt::format("{},{:.6g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{}\n", csv_quoted(line.label),
                      s.time, kMillimetres * s.drift.distance, kMillimetres * s.drift.mean_distance,
                      s.drift.energy, kMillimetres * s.drift.depth, kMillimetres * s.drift.slip,
                      std::isnan(s.residual) ? "" : fmt::format("{:.3g}", s.residual));
  return csv;
}

Json to_json(const LoopLine& line, double departure) {
  const Figures f = figures_of(line, departure);
  return {{"label", line.label},
          {"control", line.control},
          {"scene", line.track.scene},
          {"solver", line.track.solver},
          {"dt_s", line.track.dt},
          {"simulated_s", line.track.simulated()},
          {"broken", line.track.broken},
          {"stopped", line.track.stopped},
          {"frames", line.track.contact_frames},
          {"failed_frames", line.track.failed},
          {"residual_median", number(f.residual_median)},
          {"residual_max", number(f.residual_max)},
          {"departed_s", number(f.departed)},
          {"end_mean_distance_mm", number(kMillimetres * f.end.mean_distance)},
          {"distance_mm", number(kMillimetres * f.most.distance)},
          {"energy_J", number(f.most.energy)},
          {"depth_mm", number(kMillimetres * f.most.depth)},
          {"slip_mm", number(kMillimetres * f.most.slip)}};
}

std::string to_json(const LoopStudy& study) {
  const LoopPlan& plan = study.plan;
  Json rows = Json::array();
  rows.push_back(to_json(LoopLine{"reference", true, study.reference, {}}, plan.departure));
  for (const LoopLine& line : study.lines) rows.push_back(to_json(line, plan.departure));
  return Json{{"scene", study.reference.scene},
              {"reference", study.reference.solver},
              {"dt_s", study.reference.dt},
              {"duration_s", study.reference.simulated()},
              {"criterion", to_string(plan.acceptance.criterion)},
              {"tolerance", plan.acceptance.tolerance},
              {"disturbance", plan.disturbance},
              {"departure_mm", kMillimetres * plan.departure},
              {"rows", rows}}
             .dump(1) +
         "\n";
}

}  // namespace

std::optional<LoopStudy> loop_study(const LoopPlan& plan,
                                    const std::function<void(const Progress&)>& progress,
                                    const std::atomic<bool>& interrupted) {
  const std::vector<TrackedTask> tasks = tasks_of(plan);
  auto tracks = run_tracks(tasks, plan.acceptance, plan.silence, progress, interrupted);
  if (!tracks) return std::nullopt;
  LoopStudy study{plan, std::move(tracks->front()), {}};
  if (study.reference.frames() == 0)
    throw std::runtime_error(fmt::format("the reference {} with {} has no frame: {}",
                                         study.reference.scene, study.reference.solver,
                                         study.reference.broken));
  constexpr std::size_t controls = 2;
  for (std::size_t i = 1; i < tasks.size(); ++i) {
    LoopLine line{tasks[i].name, i <= controls, std::move((*tracks)[i]), {}};
    line.drifts = drift(line.track, study.reference, kForceWindow);
    study.lines.push_back(std::move(line));
  }
  return study;
}

std::optional<double> departed(const LoopLine& line, double departure) {
  for (const Drift& each : line.drifts)
    if (!(each.distance < departure)) return each.time;
  return std::nullopt;
}

std::vector<LoopSample> thinned(const LoopLine& line, double duration, Index parts) {
  std::vector<LoopSample> samples;
  const double length = duration / static_cast<double>(parts);
  Index frame = 0;
  for (const Drift& each : line.drifts) {
    const double part = std::floor(each.time / length * (1 + 1e-9));
    const double end = std::min(duration, (part + 1) * length);
    if (samples.empty() || samples.back().time < end)
      samples.push_back({end, {}, std::numeric_limits<double>::quiet_NaN()});
    LoopSample& sample = samples.back();
    sample.drift = largest({sample.drift, each}, std::numeric_limits<double>::infinity());
    for (; frame < line.track.frames() && line.track.time(frame) <= each.time; ++frame) {
      const double residual = line.track.residual(frame);
      if (!(residual <= sample.residual)) {
        if (!std::isnan(residual)) sample.residual = residual;
      }
    }
  }
  return samples;
}

std::string render(const LoopStudy& study, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return to_text(study);
    case TableFormat::csv:
      return to_csv(study);
    case TableFormat::json:
      return to_json(study);
    case TableFormat::latex:
      break;
  }
  throw std::invalid_argument("stability loop: expected text, csv or json");
}

}  // namespace lcp
