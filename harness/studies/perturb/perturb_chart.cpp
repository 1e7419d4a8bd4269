#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "harness/present/gnuplot_page.h"
#include "harness/studies/perturb/perturb_render.h"

namespace lcp {

namespace {

/// The page, in pixels: names, the share solved undisturbed, and a column per kind.
constexpr double names_top = 92, names_margin = 24, foot_height = 96;
constexpr double solver_height = 22, name_letter = 6.9, least_names = 150;
constexpr double column_width = 168, column_gap = 14;

struct KindStyle {
  const char* colour;  // Okabe and Ito
  int open, filled;    // markers
};
/// By place in all_kinds().
constexpr KindStyle kind_styles[] = {{"#0072B2", 6, 7},
                                     {"#D55E00", 4, 5},
                                     {"#009E73", 8, 9},
                                     {"#CC79A7", 12, 13},
                                     {"#E69F00", 10, 11}};

const char* column_title(DisturbanceKind kind) {
  switch (kind) {
    case DisturbanceKind::noise:
      return "last-bit noise";
    case DisturbanceKind::permutation:
      return "rows permuted";
    case DisturbanceKind::units:
      return "other units";
    case DisturbanceKind::rotation:
      return "tangents turned";
    case DisturbanceKind::scale_q:
      return "q x power of ten";
  }
  return "?";
}

/// Rows of the pooled corpora, in the order of solvers, each with its kinds.
struct DrawnSolver {
  std::string label;
  std::map<std::string, const FlipRow*> by_kind;
};

std::vector<DrawnSolver> drawn_solvers(const Flips& flips) {
  const std::string block = flips.rows.empty() ? "" : flips.rows.back().corpus;
  std::vector<DrawnSolver> solvers;
  for (const FlipRow& row : flips.rows) {
    if (row.corpus != block) continue;
    if (solvers.empty() || solvers.back().label != row.label) solvers.push_back({row.label, {}});
    solvers.back().by_kind[row.kind] = &row;
  }
  std::erase_if(solvers, [](const DrawnSolver& solver) {
    return std::none_of(solver.by_kind.begin(), solver.by_kind.end(),
                        [](const auto& each) { return each.second->trials > 0; });
  });
  return solvers;
}

/// A data set of a column: place, then in percent the value and its interval, and what is printed.
std::string column_data(const std::vector<DrawnSolver>& solvers, const std::string& kind) {
  std::string out;
  for (std::size_t k = 0; k < solvers.size(); ++k) {
    const FlipRow& row = *solvers[k].by_kind.at(kind);
    const bool baseline = kind == "baseline";
    const Index count = baseline ? row.solved : row.flips();
    const Interval interval = wilson_interval(count, row.trials);
    if (row.trials > 0)
      out += fmt::format("{} {:.4g} {:.4g} {:.4g} {} \"{}/{}\"\n", k,
                         100 * static_cast<double>(count) / static_cast<double>(row.trials),
                         100 * interval.low, 100 * interval.high, count, count, row.trials);
    else
      out += fmt::format("{} NaN NaN NaN 0 \"-\"\n", k);
  }
  return out + "\n\n";
}

std::string page_head(const std::vector<DrawnSolver>& solvers, const Flips& flips, double width,
                      double height) {
  Index instances = 0;
  for (const DrawnSolver& solver : solvers)
    instances = std::max(instances, solver.by_kind.at("baseline")->instances);
  const auto at = [&](double x, double y) {
    return fmt::format("at screen {:.5f}, screen {:.5f}", x / width, 1 - y / height);
  };
  std::string out = fmt::format(
      "set label 1 'How often does a verdict flip when the data change in ways that should not "
      "matter?' {} left font ',16'\n",
      at(names_margin, 22));
  out += fmt::format(
      "set label 2 '{} instances; flips (solved becomes not solved, or the reverse) per disturbed "
      "run, in %' {} left font ',12' tc rgb '#555555'\n",
      instances, at(names_margin, 44));
  out += fmt::format(
      "set label 3 'Bars: Wilson 95% interval, as if runs of one instance were independent. "
      "Filled marker: no flip seen.' {} left font ',11' tc rgb '#555555'\n",
      at(names_margin, height - 34));
  out += fmt::format(
      "set label 4 'A solver that solves little undisturbed has little to lose: read the rates "
      "beside the first column. Solved: residual at most {}.' {} left font ',11' tc rgb "
      "'#555555'\n",
      flips.tolerance, at(names_margin, height - 16));
  return out;
}

std::string script_baseline(const std::vector<DrawnSolver>& solvers) {
  std::string out = "set title 'solved undisturbed' offset 0,-0.3 font ',13'\nset ytics (";
  for (std::size_t k = 0; k < solvers.size(); ++k)
    out += fmt::format("{}'{}' {}", k > 0 ? ", " : "", fit_for_gnuplot(solvers[k].label), k);
  out += fmt::format(
      R"() nomirror scale 0 noenhanced font ',11' tc rgb '#222222'
set xlabel 'instances (%)' font ',11'
plot DATA index 0 using (0):1:(0):2:($1-0.3):($1+0.3) with boxxyerror fs solid 1 noborder lc rgb '#bbbbbb', \
     DATA index 0 using (98):1:6 with labels right font ',10' tc rgb '#222222'
unset label 1
unset label 2
unset label 3
unset label 4
unset ytics
)");
  return out;
}

std::string script_kind(DisturbanceKind kind, std::size_t index) {
  const KindStyle& style = kind_styles[static_cast<std::size_t>(kind)];
  return fmt::format(
      R"(set title '{title}' offset 0,-0.3 font ',13'
set xlabel 'flips (%)' font ',11'
plot DATA index {index} using 2:1:3:4 with xerrorbars pt 0 lw 1.6 lc rgb '{colour}', \
     DATA index {index} using ($5 > 0 ? $2 : NaN):1 with points pt {open} ps 0.9 lw 1.8 lc rgb '{colour}', \
     DATA index {index} using ($5 > 0 ? NaN : $2):1 with points pt {filled} ps 0.9 lc rgb '{colour}', \
     DATA index {index} using (127):1:6 with labels right font ',10' tc rgb '#222222'
)",
      fmt::arg("title", column_title(kind)), fmt::arg("index", index),
      fmt::arg("colour", style.colour), fmt::arg("open", style.open),
      fmt::arg("filled", style.filled));
}

}  // namespace

void draw_flips(const Flips& flips, const std::filesystem::path& svg) {
  const std::vector<DrawnSolver> solvers = drawn_solvers(flips);
  if (solvers.empty()) throw std::invalid_argument("no run to draw: none was counted");
  std::size_t longest = 0;
  for (const DrawnSolver& solver : solvers) longest = std::max(longest, solver.label.size());
  const double names =
      std::max(least_names, name_letter * static_cast<double>(longest)) + names_margin;
  const std::size_t columns = 1 + flips.options.kinds.size();
  const double panel_height = solver_height * static_cast<double>(solvers.size());

  GnuplotPage page;
  page.title = "Flip rate of every solver under every kind of disturbance.";
  page.width = names + static_cast<double>(columns) * (column_width + column_gap) + names_margin;
  page.height = names_top + panel_height + foot_height;
  page.commands = page_head(solvers, flips, page.width, page.height);
  page.commands += fmt::format(
      "unset key\nset border 3 lc rgb '#777777'\nset grid xtics lc rgb '#e6e6e6' lt 1\n"
      "set yrange [{}:-0.7]\nset xrange [0:100]\nset xtics 0,50,100 nomirror font ',10'\n",
      static_cast<double>(solvers.size()) - 0.3);
  std::size_t column = 0;
  const auto place = [&] {
    const double left = names + static_cast<double>(column) * (column_width + column_gap);
    page.commands +=
        gnuplot_margins({left, column_width - 8, names_top, panel_height}, page.width, page.height);
  };
  place();
  page.commands += script_baseline(solvers);
  page.data = column_data(solvers, "baseline");
  page.commands += "set xrange [0:130]\n";
  for (const DisturbanceKind kind : flips.options.kinds) {
    ++column;
    place();
    page.commands += script_kind(kind, column);
    page.data += column_data(solvers, to_string(kind));
  }
  draw_with_gnuplot(svg, page);
}

}  // namespace lcp
