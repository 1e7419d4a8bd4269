#include "harness/studies/paper/dance_figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/present/gnuplot_page.h"
#include "harness/present/scenes/scene_picture.h"
#include "harness/studies/paper/force_figure.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

constexpr double kGapBridged = 0.01;  // s
constexpr double kDegrees = 180 / std::numbers::pi;

// Pixels.
constexpr double kChartLeft = 90, kChartRight = 24, kAbove = 12, kTurn = 150, kGap = 18, kLane = 26,
                 kFoot = 52;
double turn(const LoopRun& run, const FrameRecord& frame) {
  return kDegrees * (frame.yaw - run.frames.front().yaw);
}

/// Three data sets after those of the panels.
std::string chart_data(const LoopRun& run, const std::vector<Snapshot>& snapshots) {
  std::string data = "# " + dance_csv(run);
  std::replace(data.begin(), data.end(), ',', ' ');
  data += "\n\n# pictures: time, turn, letter\n";
  char letter = 'a';
  for (const Snapshot& moment : snapshots) {
    const Index frame =
        std::min<Index>(std::lround(moment.time / run.dt), std::ssize(run.frames) - 1);
    data += fmt::format("{:.6g} {:.6g} {}\n", moment.time, turn(run, run.frames[frame]), letter++);
  }
  data += "\n\n# stances: begin, end (s), handle, struck\n";
  for (const Stance& s : stances(run))
    data += fmt::format("{:.6g} {:.6g} {} {:d}\n", s.begin, s.end, s.handle, s.struck);
  return data + "NaN NaN NaN NaN\n";  // gnuplot does not count what is empty
}

std::string chart_script(const LoopRun& run, double top, const GnuplotPage& page) {
  const std::vector<std::string> names = handle_names(run.frames.front().handle_forces.size());
  const double begin = run.frames.front().time, end = run.frames.back().time;
  const double margin = 0.012 * (end - begin + run.dt), lanes = static_cast<double>(names.size());
  const auto panel = [&](double from_top, double height) {
    return gnuplot_margins({kChartLeft, page.width - kChartLeft - kChartRight, from_top, height},
                           page.width, page.height);
  };
  return fmt::format(
      R"({upper}set border 3 lc rgb '#555555'
set tics nomirror
set xtics nomirror autofreq format ''
set ytics nomirror autofreq format '%g'
set grid xtics ytics lc rgb '#e6e6e6' lt 1 lw 0.8
set xrange [{begin:.6g}:{end:.6g}]
set yrange [*<-0.5:0.5<*]
set offsets graph 0, 0, 0.12, 0.12
set ylabel 'turn (degrees)'
plot DATA index {set} using 1:2 with lines lw 1.8 lc rgb '#222222', \
     DATA index {set}+1 using 1:2 with points pt 7 ps 0.6 lc rgb '#222222', \
     DATA index {set}+1 using 1:2:3 with labels offset 0,0.8 font ',12' tc rgb '#222222'
unset offsets
{lower}set xtics nomirror autofreq format '%g'
NAMES = '"{names}"'
set ytics nomirror scale 0 (word(NAMES, 1) 0)
set for [h=2:words(NAMES)] ytics add (word(NAMES, h) h - 1)
set grid noytics
unset ylabel
set xlabel 'time (s); bars: the foot carries force, triangles: it strikes'
set yrange [{lanes} - 0.5:-0.6]
colour(h) = h == 0 ? 0x0072B2 : h == 1 ? 0xD55E00 : 0x009E73
plot DATA index {set}+2 using 1:3:1:2:($3-0.2):($3+0.2):(colour($3)) with boxxyerror fs solid 0.55 noborder lc rgb variable, \
     DATA index {set}+2 using ($4 > 0 ? $1 : NaN):($3-0.33):(colour($3)) with points pt 11 ps 0.75 lc rgb variable
)",
      fmt::arg("upper", panel(top, kTurn)),
      fmt::arg("lower", panel(top + kTurn + kGap, kLane * lanes)), fmt::arg("lanes", lanes),
      fmt::arg("begin", begin - margin), fmt::arg("end", end + margin),
      fmt::arg("set", scene_page_sets), fmt::arg("names", fmt::join(names, "\" \"")));
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
  const std::size_t handles = run.frames.empty() ? 0 : run.frames.front().handle_forces.size();
  std::string csv = "time_s,turn_deg";
  for (const std::string& name : handle_columns(handles))
    csv += fmt::format(",{0}_N,{0}_strikes", name);
  csv += '\n';
  for (const FrameRecord& frame : run.frames) {
    csv += fmt::format("{:.9g},{:.9g}", frame.time, turn(run, frame));
    for (std::size_t h = 0; h < handles; ++h) {
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
  const double lanes = kLane * static_cast<double>(run.frames.front().handle_forces.size());
  const double chart = kAbove + kTurn + kGap + lanes + kFoot;
  replace_file(std::filesystem::path(svg).replace_extension(".csv").string(), dance_csv(run));
  const SceneMoments moments{.scene = &scene,
                             .snapshots = snapshots,
                             .most_in_a_row = 4,
                             .height = 260,
                             .most_width = 260,
                             .letters = true,
                             .azimuth = -18};  // dancers turn left: seen from the front for longer
  GnuplotPage page = scene_page(fmt::format("Frames of {}, {} in the loop.", run.scene, run.solver),
                                {moments}, chart);
  page.commands += chart_script(run, page.height - chart + kAbove, page);
  page.data += chart_data(run, snapshots);
  draw_with_gnuplot(svg, page);
}

}  // namespace lcp
