#include "harness/studies/paper/dance_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/present/gnuplot_page.h"
#include "harness/studies/paper/force_figure.h"
#include "harness/present/scenes/scene_panels.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

constexpr double kGapBridged = 0.01;  // s
constexpr double kDegrees = 180 / std::numbers::pi;

// Pixels.
constexpr double kChartLeft = 90, kChartRight = 24, kAbove = 12, kTurn = 150, kGap = 18, kLane = 26,
                 kFoot = 52;
constexpr ScenePanels::Layout kLayout{
    .most_in_a_row = 4,
    .height = 260,
    .most_width = 260,
    .letters = true,
    .azimuth = -18};  // dancers turn left: seen from the front for longer

double turn(const LoopRun& run, const FrameRecord& frame) {
  return kDegrees * (frame.yaw - run.frames.front().yaw);
}

/// Of the frame at that time.
double turn_at(const LoopRun& run, double time) {
  const Index frame =
      std::clamp<Index>(std::lround(time / run.dt), 0, static_cast<Index>(run.frames.size()) - 1);
  return turn(run, run.frames[frame]);
}

/// Three data sets after those of the panels.
std::string chart_data(const LoopRun& run, const std::vector<Snapshot>& snapshots) {
  std::string data = "# time (s), turn (degrees)\n";
  for (const FrameRecord& frame : run.frames)
    data += fmt::format("{:.6g} {:.6g}\n", frame.time, turn(run, frame));
  data += "\n\n# pictures: time, turn, letter\n";
  for (std::size_t i = 0; i < snapshots.size(); ++i)
    data += fmt::format("{:.6g} {:.6g} {:c}\n", snapshots[i].time, turn_at(run, snapshots[i].time),
                        'a' + static_cast<int>(i));
  data += "\n\n# stances: begin, end (s), handle, struck\n";
  const std::vector<Stance> all = stances(run);
  for (const Stance& s : all)
    data += fmt::format("{:.6g} {:.6g} {} {:d}\n", s.begin, s.end, s.handle, s.struck);
  if (all.empty()) data += "NaN NaN NaN NaN\n";
  return data;
}

std::string chart_script(const LoopRun& run, std::size_t set, double top, double page_width,
                         double page_height) {
  const std::vector<std::string> names = handle_names(run.frames.front().handle_forces.size());
  double low = 0, high = 0;
  for (const FrameRecord& frame : run.frames) {
    low = std::min(low, turn(run, frame));
    high = std::max(high, turn(run, frame));
  }
  const double margin = std::max(0.5, 0.12 * (high - low));
  const double length = run.frames.back().time - run.frames.front().time + run.dt;
  const double width = page_width - kChartLeft - kChartRight;
  std::string out = gnuplot_margins({kChartLeft, width, top, kTurn}, page_width, page_height);
  out += fmt::format(
      R"(unset title
unset key
set border 3 lc rgb '#555555'
set tics nomirror
set xtics nomirror autofreq format ''
set ytics nomirror autofreq format '%g'
set grid xtics ytics lc rgb '#e6e6e6' lt 1 lw 0.8
set xrange [{begin:.6g}:{end:.6g}]
set yrange [{low:.6g}:{high:.6g}]
set ylabel 'turn (degrees)'
plot DATA index {set} using 1:2 with lines lw 1.8 lc rgb '#222222', \
     DATA index {set}+1 using 1:2 with points pt 7 ps 0.6 lc rgb '#222222', \
     DATA index {set}+1 using 1:2:3 with labels offset 0,0.8 font ',12' tc rgb '#222222'
)",
      fmt::arg("begin", run.frames.front().time - 0.012 * length),
      fmt::arg("end", run.frames.back().time + 0.012 * length), fmt::arg("low", low - margin),
      fmt::arg("high", high + margin), fmt::arg("set", set));
  std::string lanes;
  for (std::size_t h = 0; h < names.size(); ++h)
    lanes += fmt::format("{}'{}' {}", h ? ", " : "", names[h], h);
  const double height = kLane * static_cast<double>(names.size());
  out += gnuplot_margins({kChartLeft, width, top + kTurn + kGap, height}, page_width, page_height);
  out += fmt::format(
      R"(set xtics nomirror autofreq format '%g'
set ytics nomirror ({lanes}) scale 0
set grid noytics
unset ylabel
set xlabel 'time (s); bars: the foot carries force, triangles: it strikes'
set yrange [{lowest:.6g}:-0.6]
colour(h) = h == 0 ? 0x0072B2 : h == 1 ? 0xD55E00 : 0x009E73
plot DATA index {set} using 1:3:1:2:($3-0.2):($3+0.2):(colour($3)) with boxxyerror fs solid 0.55 noborder lc rgb variable, \
     DATA index {set} using ($4 > 0 ? $1 : NaN):($3-0.33):(colour($3)) with points pt 11 ps 0.75 lc rgb variable
)",
      fmt::arg("lanes", lanes), fmt::arg("lowest", static_cast<double>(names.size()) - 0.5),
      fmt::arg("set", set + 2));
  return out;
}

}  // namespace

std::vector<Stance> stances(const LoopRun& run) {
  std::vector<Stance> all;
  if (run.frames.empty()) return all;
  for (std::size_t h = 0; h < run.frames.front().handle_forces.size(); ++h) {
    double free_since = run.frames.front().time;
    bool standing = false;
    for (const FrameRecord& frame : run.frames) {
      if (!(frame.handle_forces[h].z() > 0)) continue;
      const bool after_a_gap = frame.time - free_since >= kGapBridged - run.dt / 2;
      if (!standing || after_a_gap) all.push_back({h, frame.time, frame.time, after_a_gap});
      standing = true;
      free_since = all.back().end = frame.time + run.dt;
    }
  }
  return all;
}

std::string dance_csv(const LoopRun& run) {
  const std::vector<Stance> all = stances(run);
  std::string csv = "time_s,turn_deg";
  if (run.frames.empty()) return csv + "\n";
  std::vector<std::string> names = handle_names(run.frames.front().handle_forces.size());
  for (std::string& name : names) {
    std::replace(name.begin(), name.end(), ' ', '_');
    csv += fmt::format(",{0}_N,{0}_strikes", name);
  }
  csv += '\n';
  for (const FrameRecord& frame : run.frames) {
    csv += fmt::format("{:.9g},{:.9g}", frame.time, turn(run, frame));
    for (std::size_t h = 0; h < names.size(); ++h) {
      const bool strikes = std::any_of(all.begin(), all.end(), [&](const Stance& s) {
        return s.handle == h && s.struck && s.begin == frame.time;
      });
      csv += fmt::format(",{:.9g},{:d}", frame.handle_forces[h].z(), strikes);
    }
    csv += '\n';
  }
  return csv;
}

void write_dance_figure(const LoopRun& run, const NamedScene& scene,
                        const std::vector<Snapshot>& snapshots, const std::filesystem::path& svg) {
  const ScenePanels panels(scene, snapshots, kLayout);
  const double lanes = kLane * static_cast<double>(run.frames.front().handle_forces.size());
  const double width = panels.width(),
               height = panels.height() + kAbove + kTurn + kGap + lanes + kFoot;
  replace_file(std::filesystem::path(svg).replace_extension(".csv").string(), dance_csv(run));
  draw_with_gnuplot(
      svg, {.title = fmt::format("Frames of {}, {} in the loop.", run.scene, run.solver),
            .width = width,
            .height = height,
            .commands = panels.script(width, height) +
                        chart_script(run, panels.sets(), panels.height() + kAbove, width, height),
            .data = panels.data() + chart_data(run, snapshots)});
}

}  // namespace lcp
