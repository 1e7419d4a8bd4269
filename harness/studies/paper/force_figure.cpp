#include "harness/studies/paper/force_figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/observed_quantile.h"
#include "harness/present/gnuplot_page.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

constexpr double kHalfWindow = 0.01;  // s

// Pixels.
constexpr double kWidth = 720, kLeft = 70, kRight = 20, kLegend = 34, kPanel = 210, kGap = 40,
                 kFoot = 52;
constexpr double kHeight = kLegend + 2 * kPanel + kGap + kFoot;

Index handles_of(const Eigen::MatrixXd& forces) { return (forces.cols() - 4) / 2; }

/// Upper end of an axis: above every average and nearly every single frame.
double axis_end(const Eigen::MatrixXd& single, const Eigen::MatrixXd& means) {
  const std::vector<double> frames(single.data(), single.data() + single.size());
  return 1.08 * std::max({1e-9, observed_quantile(frames, 0.99).value_or(0),
                          means.maxCoeff<Eigen::PropagateNumbers>()});
}

std::string commands(const Eigen::MatrixXd& forces) {
  const Index frames = forces.rows(), handles = handles_of(forces);
  const auto panel = [](double top) {
    return gnuplot_margins({kLeft, kWidth - kLeft - kRight, top, kPanel}, kWidth, kHeight);
  };
  return fmt::format(
      R"(COLOURS = '0x0072B2 0xD55E00 0x009E73 0xCC79A7 0xE69F00 0x56B4E9'  # Okabe and Ito
colour(k) = int(word(COLOURS, int(k) % words(COLOURS) + 1))
faint(k) = 0xa0000000 + colour(k)
HANDLES = {handles}
NAMES = '"{names}"'
set datafile separator ','
set border 3 lc rgb '#555555'
set tics nomirror
set grid xtics ytics lc rgb '#e6e6e6' lt 1 lw 0.8
set key at graph 1,1.02 bottom right horizontal samplen 2.5 noenhanced
set xrange [{begin:.6g}:{end:.6g}]
set ylabel 'vertical force (N)'
{upper}set format x ''
set yrange [0:{highest:.6g}]
plot for [h=1:HANDLES] DATA using 1:(column(1 + h)) with lines lw 0.6 lc rgb faint(h - 1) notitle, \
     for [h=1:HANDLES] DATA using 1:(column(HANDLES + 2 + h)) with lines lw 2 lc rgb colour(h - 1) title word(NAMES, h)
{lower}set format x '%g'
set xlabel 'time (s)'
set yrange [0:{highest_sum:.6g}]
plot DATA using 1:(column(HANDLES + 2)) with lines lw 0.6 lc rgb 0xa0444444 notitle, \
     DATA using 1:(column(2 * HANDLES + 3)) with lines lw 2 lc rgb '#444444' title 'sum', \
     DATA using 1:(column(2 * HANDLES + 4)) with lines lw 1.6 dt (6,5) lc rgb '#e69f00' title 'weight + m a of the centre of mass'
)",
      fmt::arg("handles", handles), fmt::arg("names", fmt::join(handle_names(handles), "\" \"")),
      fmt::arg("begin", forces(0, 0)),
      fmt::arg("end", 2 * forces(frames - 1, 0) - forces(frames - 2, 0)),
      fmt::arg("upper", panel(kLegend)), fmt::arg("lower", panel(kLegend + kPanel + kGap)),
      fmt::arg("highest",
               axis_end(forces.middleCols(1, handles), forces.middleCols(handles + 2, handles))),
      fmt::arg("highest_sum", axis_end(forces.col(handles + 1), forces.rightCols(2))));
}

}  // namespace

std::vector<std::string> handle_names(std::size_t handles) {
  if (handles == 2) return {"left foot", "right foot"};
  std::vector<std::string> names;
  for (std::size_t h = 0; h < handles; ++h) names.push_back(fmt::format("link {}", h + 1));
  return names;
}

std::vector<std::string> handle_columns(std::size_t handles) {
  std::vector<std::string> names = handle_names(handles);
  for (std::string& name : names) std::replace(name.begin(), name.end(), ' ', '_');
  return names;
}

Eigen::MatrixXd vertical_forces(const LoopRun& run, double mass, const Vector3d& gravity) {
  const auto& frames = run.frames;
  const Index count = std::ssize(frames);
  const Index handles = frames.empty() ? 0 : std::ssize(frames.front().handle_forces);
  const Index half = std::max<Index>(1, std::lround(kHalfWindow / run.dt));
  const double steps = static_cast<double>(2 * half);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Eigen::MatrixXd forces = Eigen::MatrixXd::Constant(count, 2 * handles + 4, none);
  for (Index i = 0; i < count; ++i) {
    forces(i, 0) = frames[i].time;
    for (Index h = 0; h < handles; ++h) forces(i, 1 + h) = frames[i].handle_forces[h].z();
    forces(i, handles + 1) = forces.row(i).segment(1, handles).sum();
  }
  // Newton's second law: the forces of steps i-half to i+half-1 take the velocity of frame i-half to
  // that of frame i+half.
  for (Index i = half; i + half < count; ++i) {
    auto means = forces.row(i).segment(handles + 2, handles);
    means.setZero();
    for (Index k = i - half; k < i + half; ++k) means += forces.row(k).segment(1, handles) / steps;
    forces(i, 2 * handles + 2) = means.sum();
    const double change = frames[i + half].com_velocity.z() - frames[i - half].com_velocity.z();
    forces(i, 2 * handles + 3) = mass * (change / (steps * run.dt) - gravity.z());
  }
  return forces;
}

std::string forces_csv(const Eigen::MatrixXd& forces) {
  std::string csv = "time_s", means;
  for (const std::string& name : handle_columns(handles_of(forces))) {
    csv += fmt::format(",{}_N", name);
    means += fmt::format(",{}_20ms_N", name);
  }
  csv += ",sum_N" + means + ",sum_20ms_N,weight_plus_ma_20ms_N\n";
  for (const auto& row : forces.rowwise()) {
    csv += fmt::format("{:.9g}", row(0));
    for (const double force : row.tail(row.size() - 1))
      csv += std::isnan(force) ? "," : fmt::format(",{:.9g}", force);
    csv += '\n';
  }
  return csv;
}

void write_force_figure(const LoopRun& run, double mass, const Vector3d& gravity,
                        const std::filesystem::path& svg) {
  const Eigen::MatrixXd forces = vertical_forces(run, mass, gravity);
  if (forces.rightCols(1).array().isNaN().all())
    throw std::invalid_argument("figure of forces: the simulation is shorter than 20 ms");
  const std::string csv = forces_csv(forces);
  replace_file(std::filesystem::path(svg).replace_extension(".csv").string(), csv);
  draw_with_gnuplot(svg, {.title = fmt::format("Vertical contact forces of {}, {} in the loop.",
                                               run.scene, run.solver),
                          .width = kWidth,
                          .height = kHeight,
                          .commands = commands(forces),
                          .data = "# " + csv});
}

}  // namespace lcp
