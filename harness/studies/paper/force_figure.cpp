#include "harness/studies/paper/force_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "harness/present/gnuplot_page.h"
#include "harness/observed_quantile.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

constexpr double kHalfWindow = 0.01;  // s

// Pixels.
constexpr double kWidth = 720, kLeft = 70, kRight = 20, kLegend = 34, kPanel = 210, kGap = 40,
                 kFoot = 52;

/// Newton's second law: the forces of steps i-half to i+half-1 take the velocity of frame i-half to
/// that of frame i+half.
VerticalForces::Mean mean_around(const LoopRun& run, Index i, Index half, double mass,
                                 double gravity) {
  const std::size_t handles = run.frames[i].handle_forces.size();
  const double steps = static_cast<double>(2 * half);
  VerticalForces::Mean mean{.handles = std::vector<double>(handles, 0.0)};
  for (Index k = i - half; k < i + half; ++k)
    for (std::size_t h = 0; h < handles; ++h)
      mean.handles[h] += run.frames[k].handle_forces[h].z() / steps;
  for (const double force : mean.handles) mean.sum += force;
  const double change =
      run.frames[i + half].com_velocity.z() - run.frames[i - half].com_velocity.z();
  mean.expected = mass * (change / (steps * run.dt) - gravity);
  return mean;
}

/// Upper end of the axis: above every average and nearly every single frame.
double axis_end(std::vector<double> single, double largest_mean) {
  const double usual = observed_quantile(std::move(single), 0.99).value_or(0);
  return 1.08 * std::max({usual, largest_mean, 1e-9});
}

std::string data(const std::vector<VerticalForces>& forces) {
  std::string lines =
      "# time (s), sum, its average, weight + m a, each handle and its average (N)\n";
  for (const VerticalForces& f : forces) {
    lines += fmt::format("{:.6g} {:.6g}", f.time, f.sum);
    lines += f.mean ? fmt::format(" {:.6g} {:.6g}", f.mean->sum, f.mean->expected) : " NaN NaN";
    for (std::size_t h = 0; h < f.handles.size(); ++h) {
      lines += fmt::format(" {:.6g} ", f.handles[h]);
      lines += f.mean ? fmt::format("{:.6g}", f.mean->handles[h]) : "NaN";
    }
    lines += '\n';
  }
  return lines;
}

std::string commands(const std::vector<VerticalForces>& forces, double page_height) {
  const std::vector<std::string> names = handle_names(forces.front().handles.size());
  std::vector<double> single, sums;
  double largest_mean = 0, largest_sum = 0;
  for (const VerticalForces& f : forces) {
    single.insert(single.end(), f.handles.begin(), f.handles.end());
    sums.push_back(f.sum);
    if (!f.mean) continue;
    for (const double force : f.mean->handles) largest_mean = std::max(largest_mean, force);
    largest_sum = std::max({largest_sum, f.mean->sum, f.mean->expected});
  }
  const double width = kWidth - kLeft - kRight;
  std::string out = fmt::format(
      R"(COLOURS = '0x0072B2 0xD55E00 0x009E73 0xCC79A7 0xE69F00 0x56B4E9'  # Okabe and Ito
colour(k) = int(word(COLOURS, int(k) % words(COLOURS) + 1))
faint(k) = 0xa0000000 + colour(k)
set border 3 lc rgb '#555555'
set tics nomirror
set grid xtics ytics lc rgb '#e6e6e6' lt 1 lw 0.8
set key at graph 1,1.02 bottom right horizontal samplen 2.5 noenhanced
set xrange [{:.6g}:{:.6g}]
set ylabel 'vertical force (N)'
)",
      forces.front().time, 2 * forces.back().time - forces[forces.size() - 2].time);
  out += gnuplot_margins({kLeft, width, kLegend, kPanel}, kWidth, page_height);
  out +=
      fmt::format("set format x ''\nset yrange [0:{:.6g}]\nplot ", axis_end(single, largest_mean));
  for (std::size_t h = 0; h < names.size(); ++h)
    out += fmt::format("{0}DATA using 1:{1} with lines lw 0.6 lc rgb faint({2}) notitle",
                       h ? ", \\\n     " : "", 5 + 2 * h, h);
  for (std::size_t h = 0; h < names.size(); ++h)
    out += fmt::format(", \\\n     DATA using 1:{} with lines lw 2 lc rgb colour({}) title '{}'",
                       6 + 2 * h, h, names[h]);
  out += '\n';
  out += gnuplot_margins({kLeft, width, kLegend + kPanel + kGap, kPanel}, kWidth, page_height);
  out += fmt::format(
      R"(set format x '%g'
set xlabel 'time (s)'
set yrange [0:{:.6g}]
plot DATA using 1:2 with lines lw 0.6 lc rgb 0xa0444444 notitle, \
     DATA using 1:3 with lines lw 2 lc rgb '#444444' title 'sum', \
     DATA using 1:4 with lines lw 1.6 dt (6,5) lc rgb '#e69f00' title 'weight + m a of the centre of mass'
)",
      axis_end(sums, largest_sum));
  return out;
}

}  // namespace

std::vector<std::string> handle_names(std::size_t handles) {
  if (handles == 2) return {"left foot", "right foot"};
  std::vector<std::string> names;
  for (std::size_t h = 0; h < handles; ++h) names.push_back(fmt::format("link {}", h + 1));
  return names;
}

std::vector<VerticalForces> vertical_forces(const LoopRun& run, double mass,
                                            const Vector3d& gravity) {
  const Index count = static_cast<Index>(run.frames.size());
  const Index half = std::max<Index>(1, std::lround(kHalfWindow / run.dt));
  std::vector<VerticalForces> forces;
  for (Index i = 0; i < count; ++i) {
    VerticalForces now{.time = run.frames[i].time, .handles = {}, .sum = 0, .mean = {}};
    for (const Vector3d& force : run.frames[i].handle_forces) {
      now.handles.push_back(force.z());
      now.sum += force.z();
    }
    if (i >= half && i + half < count) now.mean = mean_around(run, i, half, mass, gravity.z());
    forces.push_back(std::move(now));
  }
  return forces;
}

std::string forces_csv(const std::vector<VerticalForces>& forces) {
  std::vector<std::string> names = handle_names(forces.empty() ? 0 : forces.front().handles.size());
  std::string csv = "time_s";
  for (std::string& name : names) {
    std::replace(name.begin(), name.end(), ' ', '_');
    csv += fmt::format(",{}_N", name);
  }
  csv += ",sum_N";
  for (const std::string& name : names) csv += fmt::format(",{}_20ms_N", name);
  csv += ",sum_20ms_N,weight_plus_ma_20ms_N\n";
  for (const VerticalForces& f : forces) {
    csv += fmt::format("{:.9g}", f.time);
    for (const double force : f.handles) csv += fmt::format(",{:.9g}", force);
    csv += fmt::format(",{:.9g}", f.sum);
    for (std::size_t h = 0; h < names.size(); ++h)
      csv += f.mean ? fmt::format(",{:.9g}", f.mean->handles[h]) : ",";
    csv += f.mean ? fmt::format(",{:.9g},{:.9g}\n", f.mean->sum, f.mean->expected) : ",,\n";
  }
  return csv;
}

void write_force_figure(const LoopRun& run, double mass, const Vector3d& gravity,
                        const std::filesystem::path& svg) {
  const std::vector<VerticalForces> forces = vertical_forces(run, mass, gravity);
  if (std::none_of(forces.begin(), forces.end(),
                   [](const VerticalForces& f) { return f.mean.has_value(); }))
    throw std::invalid_argument("figure of forces: the simulation is shorter than 20 ms");
  const double height = kLegend + 2 * kPanel + kGap + kFoot;
  replace_file(std::filesystem::path(svg).replace_extension(".csv").string(), forces_csv(forces));
  draw_with_gnuplot(svg, {.title = fmt::format("Vertical contact forces of {}, {} in the loop.",
                                               run.scene, run.solver),
                          .width = kWidth,
                          .height = height,
                          .commands = commands(forces, height),
                          .data = data(forces)});
}

}  // namespace lcp
