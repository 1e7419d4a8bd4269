#include "harness/studies/loop/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "harness/observed_quantile.h"

namespace lcp {

namespace {

constexpr double kAveraged = 0.02;  // s, over which forces and accelerations are compared

double mean(double sum, Index count) { return count > 0 ? sum / static_cast<double>(count) : 0; }

void count(const FrameRecord& frame, LoopSummary& summary) {
  ++summary.total_frames;
  const Judged judged{frame.frictional};
  switch (judged.standing()) {
    case Standing::no_solution:
      ++summary.no_solution;
      break;
    case Standing::cycle:
      ++summary.cycle;
      break;
    case Standing::error:
      ++summary.error;
      break;
    default:
      break;
  }
  summary.success += judged.success();
  summary.failure += judged.failure();
  summary.unsupported += judged.verdict == Verdict::unsupported;
  if (frame.frictionless != Verdict::solved) ++summary.frictionless_failures;
  if (frame.applied == Applied::none) ++summary.both_failures;
  summary.restarts += frame.work.restarts;
  summary.violated += frame.violated;
  summary.pivots += frame.work.pivots;
  summary.nodes += frame.work.nodes;
}

/// Newton's second law over windows of kAveraged: the forces of a step act on the velocity after it.
double force_mismatch(const LoopRun& run, double mass, const Vector3d& gravity) {
  const Index window = std::max<Index>(1, std::lround(kAveraged / run.dt));
  const double weight = mass * gravity.norm();
  double worst = 0;
  for (Index begin = 0; begin + window < static_cast<Index>(run.frames.size()); begin += window) {
    double force = 0;
    for (Index i = begin; i < begin + window; ++i) {
      for (const Vector3d& on_handle : run.frames[i].handle_forces) force += on_handle.z();
      force += run.frames[i].pull.z();
    }
    const double change =
        run.frames[begin + window].com_velocity.z() - run.frames[begin].com_velocity.z();
    const double steps = static_cast<double>(window);
    const double expected = mass * (change / (steps * run.dt) - gravity.z());
    worst = std::max(worst, std::abs(force / steps - expected) / weight);
  }
  return worst;
}

/// See LoopSummary::energy_excess.
double energy_excess(const LoopRun& run) {
  double worst = 0, largest = 0;
  for (const FrameRecord& frame : run.frames) {
    largest = std::max(largest, frame.kinetic);
    const double excess = frame.energy - run.frames.front().energy - frame.pull_work;
    if (excess > 0) worst = std::max(worst, excess / largest);
  }
  return worst;
}

/// Every figure with its name, for writing and reading.
template <class Summary, class Field>
void for_each_field(Summary& s, Field field) {
  field("scene", s.scene);
  field("solver", s.solver);
  field("broken", s.broken);
  field("stopped", s.stopped);
  field("dt", s.dt);
  field("duration", s.duration);
  field("steps", s.steps);
  field("total_frames", s.total_frames);
  field("success", s.success);
  field("failure", s.failure);
  field("no_solution", s.no_solution);
  field("cycle", s.cycle);
  field("error", s.error);
  field("unsupported", s.unsupported);
  field("frictionless_failures", s.frictionless_failures);
  field("both_failures", s.both_failures);
  field("restarts", s.restarts);
  field("contacts", s.contacts);
  field("active", s.active);
  field("violated", s.violated);
  field("total_pivots", s.pivots);
  field("nodes", s.nodes);
  field("lcp_time_ms", s.lcp_ms);
  field("simulation_time_ms", s.simulation_ms);
  field("outside_time_ms", s.outside_ms);
  field("residual_median", s.residual_median);
  field("residual_max", s.residual_max);
  field("depth_max", s.depth_max);
  field("tilt_max", s.tilt_max);
  field("turn", s.turn);
  field("height_min", s.height_min);
  field("height_end", s.height_end);
  field("force_mismatch", s.force_mismatch);
  field("work", s.work);
  field("energy_excess", s.energy_excess);
  field("gap_max", s.gap_max);
  field("gap_end", s.gap_end);
  field("trail", s.trail);
}

}  // namespace

LoopSummary summarise(const LoopRun& run, double mass, const Vector3d& gravity) {
  LoopSummary summary;
  summary.scene = run.scene;
  summary.solver = run.solver;
  summary.broken = run.broken;
  summary.stopped = run.stopped;
  summary.dt = run.dt;
  summary.duration = run.duration;
  summary.steps = static_cast<Index>(run.frames.size());
  double contacts = 0, active = 0, lcp_ns = 0, step_ns = 0, outside_ns = 0;
  Index knows_active = 0;
  std::vector<double> residuals;
  for (const FrameRecord& frame : run.frames) {
    summary.tilt_max = std::max(summary.tilt_max, frame.tilt);
    summary.gap_max = std::max(summary.gap_max, frame.gap);
    outside_ns += static_cast<double>(frame.step_ns - frame.frictional_ns - frame.frictionless_ns);
    if (frame.contacts == 0) continue;
    count(frame, summary);
    contacts += static_cast<double>(frame.contacts);
    if (frame.active) {
      active += static_cast<double>(*frame.active);
      ++knows_active;
    }
    lcp_ns += static_cast<double>(frame.frictional_ns);
    step_ns += static_cast<double>(frame.step_ns);
    summary.depth_max = std::max(summary.depth_max, frame.depth);
    if (frame.frictional == Verdict::solved) residuals.push_back(frame.accuracy.residual);
  }
  summary.contacts = mean(contacts, summary.total_frames);
  summary.active = mean(active, knows_active);
  summary.lcp_ms = mean(lcp_ns, summary.total_frames) / 1e6;
  summary.simulation_ms = mean(step_ns, summary.total_frames) / 1e6;
  summary.outside_ms = mean(outside_ns, summary.steps) / 1e6;
  if (!residuals.empty()) {
    summary.residual_max = *std::max_element(residuals.begin(), residuals.end());
    summary.residual_median = observed_quantile(residuals, 0.5).value();
  }
  if (!run.frames.empty()) {
    const auto lower = [](const FrameRecord& a, const FrameRecord& b) {
      return a.centre_of_mass.z() < b.centre_of_mass.z();
    };
    summary.height_min =
        std::min_element(run.frames.begin(), run.frames.end(), lower)->centre_of_mass.z();
    summary.height_end = run.frames.back().centre_of_mass.z();
    summary.turn = run.frames.back().yaw - run.frames.front().yaw;
    summary.work = run.frames.back().pull_work;
    summary.gap_end = run.frames.back().gap;
  }
  if (!run.anchored) summary.force_mismatch = force_mismatch(run, mass, gravity);
  if (!run.driven) summary.energy_excess = energy_excess(run);
  for (const std::vector<Vector3d>& centres : run.trail) {
    summary.trail.emplace_back();
    for (const Vector3d& c : centres) summary.trail.back().push_back({c.x(), c.y(), c.z()});
  }
  return summary;
}

double mean_link_distance(const LoopSummary& a, const LoopSummary& b, double share) {
  const auto at = static_cast<std::size_t>(std::lround(trail_parts * share));
  if (at >= a.trail.size() || at >= b.trail.size() || a.trail[at].size() != b.trail[at].size())
    return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (std::size_t i = 0; i < a.trail[at].size(); ++i) {
    const auto &p = a.trail[at][i], &q = b.trail[at][i];
    sum += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  return sum / static_cast<double>(a.trail[at].size());
}

void to_json(nlohmann::json& json, const LoopSummary& summary) {
  json = nlohmann::json::object();
  for_each_field(summary, [&](const char* name, const auto& value) { json[name] = value; });
}

nlohmann::json figures_of(const LoopSummary& summary) {
  nlohmann::json json = summary;
  json.erase("trail");
  return json;
}

void from_json(const nlohmann::json& json, LoopSummary& summary) {
  for_each_field(summary, [&](const char* name, auto& value) {
    try {
      if constexpr (std::is_same_v<decltype(value), double&>)
        if (json.at(name).is_null()) {  // how JSON spells what is not a number
          value = std::numeric_limits<double>::quiet_NaN();
          return;
        }
      json.at(name).get_to(value);
    } catch (const nlohmann::json::exception&) {
      throw std::invalid_argument(fmt::format("summary of a simulation: field '{}'", name));
    }
  });
}

std::string frames_csv(const LoopRun& run) {
  std::string csv =
      "frame,time,points_found,contacts,active,frictional,frictionless,applied,residual,paper_"
      "error,"
      "violated,pivots,nodes,start_pivots,restarts,frictionless_pivots,lcp_us,frictionless_us,step_"
      "us,"
      "depth,approach,yaw,tilt,com_x,com_y,com_z,com_vx,com_vy,com_vz";
  const std::size_t handles = run.frames.empty() ? 0 : run.frames.front().handle_forces.size();
  for (std::size_t h = 0; h < handles; ++h) csv += fmt::format(",f{0}_x,f{0}_y,f{0}_z", h);
  csv += '\n';
  for (const FrameRecord& f : run.frames) {
    csv += fmt::format("{},{},{},{},", f.frame, f.time, f.points_found, f.contacts);
    csv += f.active ? fmt::format("{}", *f.active) : "";
    if (f.contacts > 0)
      csv +=
          fmt::format(",{},{},{},{:.3e},{:.3e}", to_string(f.frictional), to_string(f.frictionless),
                      to_string(f.applied), f.accuracy.residual, f.accuracy.paper_error);
    else
      csv += ",,,none,,";
    csv +=
        fmt::format(",{},{},{},{},{},{},{:.1f},{:.1f},{:.1f},{:.6g},{:.6g},{:.9g},{:.6g}",
                    f.violated, f.work.pivots, f.work.nodes, f.work.start_pivots, f.work.restarts,
                    f.frictionless_work.pivots, static_cast<double>(f.frictional_ns) / 1e3,
                    static_cast<double>(f.frictionless_ns) / 1e3,
                    static_cast<double>(f.step_ns) / 1e3, f.depth, f.approach, f.yaw, f.tilt);
    for (const Vector3d* v : {&f.centre_of_mass, &f.com_velocity})
      csv += fmt::format(",{:.9g},{:.9g},{:.9g}", v->x(), v->y(), v->z());
    for (const Vector3d& v : f.handle_forces)
      csv += fmt::format(",{:.9g},{:.9g},{:.9g}", v.x(), v.y(), v.z());
    csv += '\n';
  }
  return csv;
}

std::string render(const LoopSummary& s) {
  const double degrees = 180 / std::numbers::pi;
  std::string text = fmt::format("{}, {} in the loop: {} s at {} ms\n", s.scene, s.solver,
                                 static_cast<double>(s.steps) * s.dt, 1e3 * s.dt);
  if (!s.broken.empty()) text += fmt::format("  ended early: {}\n", s.broken);
  text += fmt::format("  frames with contact  {} ({:.2f} contacts, {:.2f} active)\n",
                      s.total_frames, s.contacts, s.active);
  text += fmt::format(
      "  frictional LCP       {} solved, {} failed ({} no solution, {} cycle, {} error)", s.success,
      s.failure, s.no_solution, s.cycle, s.error);
  if (s.unsupported > 0) text += fmt::format(", {} unsupported", s.unsupported);
  text += fmt::format("\n  frictionless LCP     {} failed; both failed in {} frames\n",
                      s.frictionless_failures, s.both_failures);
  text += fmt::format("  residual             {:.1e} median, {:.1e} largest of the solved\n",
                      s.residual_median, s.residual_max);
  text += fmt::format("  work                 {} pivots, {} nodes, {} restarts\n", s.pivots,
                      s.nodes, s.restarts);
  text += fmt::format(
      "  time                 {:.3f} ms a frictional LCP, {:.3f} ms a step with "
      "contact, {:.3f} ms of a step outside LCPs\n",
      s.lcp_ms, s.simulation_ms, s.outside_ms);
  text += fmt::format("  penetration          {:.4f} mm at most; {} contacts violated\n",
                      1e3 * s.depth_max, s.violated);
  text += fmt::format("  centre of mass       {:.1f} mm high at least, {:.1f} mm at the end\n",
                      1e3 * s.height_min, 1e3 * s.height_end);
  text +=
      fmt::format("  first link           {:.2f} degrees of tilt at most, {:.1f} degrees of turn\n",
                  degrees * s.tilt_max,
                  std::round(10 * degrees * s.turn) / 10 + 0.0);  // + 0.0: no "-0.0"
  if (!std::isnan(s.force_mismatch))
    text += fmt::format(
        "  forces               off weight + m a by {:.3f} % of the weight at most "
        "(20 ms averages)\n",
        100 * s.force_mismatch);
  if (!std::isnan(s.energy_excess))
    text += fmt::format(
        "  energy               {:.4f} % of the largest kinetic energy above start and work at "
        "most; work {:.3f} J\n",
        100 * s.energy_excess, s.work);
  if (s.gap_max > 0)
    text += fmt::format("  loops                open by {:.2e} mm at most, {:.2e} mm at the end\n",
                        1e3 * s.gap_max, 1e3 * s.gap_end);
  return text;
}

}  // namespace lcp
