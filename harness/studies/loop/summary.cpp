#include "harness/studies/loop/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "harness/fields.h"
#include "harness/observed_quantile.h"
#include "harness/present/columns.h"

namespace lcp {

namespace {

constexpr double kAveraged = 0.02;  // s, over which forces and accelerations are compared

double mean(double sum, Index count) { return count > 0 ? sum / static_cast<double>(count) : 0; }

void count(const FrameRecord& frame, LoopSummary& summary) {
  ++summary.total_frames;
  const Judged judged{frame.frictional};
  const Standing standing = judged.standing();
  summary.no_solution += standing == Standing::no_solution;
  summary.cycle += standing == Standing::cycle;
  summary.error += standing == Standing::error;
  summary.success += judged.success();
  summary.failure += judged.failure();
  summary.unsupported += judged.verdict == Verdict::unsupported;
  summary.frictionless_failures += frame.frictionless != Verdict::solved;
  summary.both_failures += frame.applied == Applied::none;
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

constexpr double kDegrees = 180 / std::numbers::pi;  // in a radian

/// Every figure with its name; then, for a reader, the line that it stands in, its words there, what it
/// is multiplied by, and whether it is left out where it is 0.
constexpr auto summary_fields = [](auto& s, const auto& field) {
  loop_header_fields(s, field);
  field("duration", s.duration);
  field("steps", s.steps);
  field("total_frames", s.total_frames, "frames with contact", "{}");
  field("contacts", s.contacts, "frames with contact", " ({:.2f} contacts, ");
  field("active", s.active, "frames with contact", "{:.2f} active)");
  field("success", s.success, "frictional LCP", "{} solved, ");
  field("failure", s.failure, "frictional LCP", "{} failed (");
  field("no_solution", s.no_solution, "frictional LCP", "{} no solution, ");
  field("cycle", s.cycle, "frictional LCP", "{} cycle, ");
  field("error", s.error, "frictional LCP", "{} error)");
  field("unsupported", s.unsupported, "frictional LCP", ", {} unsupported", 1, true);
  field("frictionless_failures", s.frictionless_failures, "frictionless LCP", "{} failed; ");
  field("both_failures", s.both_failures, "frictionless LCP", "both failed in {} frames");
  field("residual_median", s.residual_median, "residual", "{:.1e} median, ");
  field("residual_max", s.residual_max, "residual", "{:.1e} largest of the solved");
  field("total_pivots", s.pivots, "work", "{} pivots, ");
  field("nodes", s.nodes, "work", "{} nodes, ");
  field("restarts", s.restarts, "work", "{} restarts");
  field("lcp_time_ms", s.lcp_ms, "time", "{:.3f} ms a frictional LCP, ");
  field("simulation_time_ms", s.simulation_ms, "time", "{:.3f} ms a step with contact, ");
  field("outside_time_ms", s.outside_ms, "time", "{:.3f} ms of a step outside LCPs");
  field("depth_max", s.depth_max, "penetration", "{:.4f} mm at most; ", 1e3);
  field("violated", s.violated, "penetration", "{} contacts violated");
  field("height_min", s.height_min, "centre of mass", "{:.1f} mm high at least, ", 1e3);
  field("height_end", s.height_end, "centre of mass", "{:.1f} mm at the end", 1e3);
  field("tilt_max", s.tilt_max, "first link", "{:.2f} degrees of tilt at most, ", kDegrees);
  field("turn", s.turn, "first link", "{:.1f} degrees of turn", kDegrees);
  field("force_mismatch", s.force_mismatch, "forces",
        "off weight + m a by {:.3f} % of the weight at most (20 ms averages)", 100);
  field("energy_excess", s.energy_excess, "energy",
        "{:.4f} % of the largest kinetic energy above start and work at most; ", 100);
  field("work", s.work, "energy", "work {:.3f} J");
  field("gap_max", s.gap_max, "loops", "open by {:.2e} mm at most, ", 1e3, true);
  field("gap_end", s.gap_end, "loops", "{:.2e} mm at the end", 1e3);
  field("trail", s.trail);
};

}  // namespace

LoopSummary summarise(const LoopRun& run, double mass, const Vector3d& gravity) {
  LoopSummary summary;
  static_cast<LoopHeader&>(summary) = run;
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
  json = fields_to_json(summary, summary_fields);
}

nlohmann::json figures_of(const LoopSummary& summary) {
  nlohmann::json json = summary;
  json.erase("trail");
  return json;
}

void from_json(const nlohmann::json& json, LoopSummary& summary) {
  fields_from_json(json, summary, summary_fields, "summary of a simulation", true);
}

std::string render(const LoopSummary& summary) {
  std::string text = fmt::format("{}, {} in the loop: {} s at {} ms", summary.scene, summary.solver,
                                 static_cast<double>(summary.steps) * summary.dt, 1e3 * summary.dt);
  if (!summary.broken.empty()) text += "\n  ended early: " + summary.broken;
  std::string_view before;
  bool shown = false;  // the line: as its first figure
  summary_fields(summary, [&](const char*, const auto& value, std::string_view line = {},
                              const char* words = "", double scale = 1, bool rare = false) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
      if (line.empty()) return;
      const bool first = std::exchange(before, line) != line;
      if (first) shown = std::isfinite(static_cast<double>(value)) && !(rare && value == 0);
      if (!shown || (rare && value == 0)) return;
      if (first) text += fmt::format("\n  {:<20} ", line);
      std::string printed = fmt::format(fmt::runtime(words), value);
      if constexpr (std::is_same_v<decltype(value), const double&>)
        printed = fmt::format(fmt::runtime(words), scale * value);
      if (printed.starts_with("-0.0 ")) printed.erase(0, 1);
      text += printed;
    }
  });
  return text + "\n";
}

std::string frames_csv(const LoopRun& run) {
  std::vector<Column<FrameRecord>> columns;
  const auto add = [&](const std::string& key, auto value, const char* exact = "{}") {
    columns.push_back({{.key = key, .exact = exact},
                       [=](const FrameRecord& f) -> Cell { return std::invoke(value, f); }});
  };
  const auto add_solve = [&](const char* key, auto value) {  // of frames with contact
    const auto of = [=](const FrameRecord& f) { return f.contacts > 0 ? Cell(value(f)) : Cell(); };
    add(key, of, "{:.3e}");
  };
  const auto add_us = [&](const char* key, std::int64_t FrameRecord::*ns) {
    add(
        key, [=](const FrameRecord& f) { return static_cast<double>(f.*ns) / 1e3; }, "{:.1f}");
  };
  const auto add_vector = [&](const std::string& key, auto vector) {
    for (const int i : {0, 1, 2})
      add(
          key + "xyz"[i], [=](const FrameRecord& f) { return std::invoke(vector, f)[i]; },
          "{:.9g}");
  };
  add("frame", &FrameRecord::frame);
  add("time", &FrameRecord::time);
  add("points_found", &FrameRecord::points_found);
  add("contacts", &FrameRecord::contacts);
  add("active", [](const FrameRecord& f) { return f.active ? Cell(*f.active) : Cell(); });
  add_solve("frictional", [](const FrameRecord& f) { return to_string(f.frictional); });
  add_solve("frictionless", [](const FrameRecord& f) { return to_string(f.frictionless); });
  add("applied", [](const FrameRecord& f) { return to_string(f.applied); });
  add_solve("residual", [](const FrameRecord& f) { return f.accuracy.residual; });
  add_solve("paper_error", [](const FrameRecord& f) { return f.accuracy.paper_error; });
  add("violated", &FrameRecord::violated);
  add("pivots", [](const FrameRecord& f) { return f.work.pivots; });
  add("nodes", [](const FrameRecord& f) { return f.work.nodes; });
  add("start_pivots", [](const FrameRecord& f) { return f.work.start_pivots; });
  add("restarts", [](const FrameRecord& f) { return f.work.restarts; });
  add("frictionless_pivots", [](const FrameRecord& f) { return f.frictionless_work.pivots; });
  add_us("lcp_us", &FrameRecord::frictional_ns);
  add_us("frictionless_us", &FrameRecord::frictionless_ns);
  add_us("step_us", &FrameRecord::step_ns);
  add("depth", &FrameRecord::depth, "{:.6g}");
  add("approach", &FrameRecord::approach, "{:.6g}");
  add("yaw", &FrameRecord::yaw, "{:.9g}");
  add("tilt", &FrameRecord::tilt, "{:.6g}");
  add_vector("com_", &FrameRecord::centre_of_mass);
  add_vector("com_v", &FrameRecord::com_velocity);
  const std::size_t handles = run.frames.empty() ? 0 : run.frames.front().handle_forces.size();
  for (std::size_t h = 0; h < handles; ++h)
    add_vector(fmt::format("f{}_", h), [=](const FrameRecord& f) { return f.handle_forces[h]; });
  return csv_text(cells_of(columns, run.frames));
}

}  // namespace lcp
