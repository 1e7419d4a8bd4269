#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "harness/studies/perturb/perturb_pages.h"

namespace lcp {

namespace {

/// The page, in pixels: names, the share solved undisturbed, and a column per kind.
constexpr double names_top = 68, names_margin = 24, foot_height = 64;
constexpr double solver_height = 22, name_letter = 6.9, least_names = 150;
constexpr double column_width = 160, column_gap = 30;

constexpr const char* column_title(DisturbanceKind kind) {
  constexpr const char* titles[] = {"last-bit noise", "rows permuted", "other units",
                                    "tangents turned", "q x power of ten"};
  return titles[static_cast<int>(kind)];
}

/// A solver's rows of the pooled corpora, by kind.
struct DrawnSolver {
  std::string label;
  std::map<std::string, const FlipRow*> by_kind;
};

std::vector<DrawnSolver> drawn_solvers(const Flips& flips) {
  std::vector<DrawnSolver> solvers;
  for (const FlipRow& row : flips.rows) {
    if (row.corpus != flips.rows.back().corpus) continue;
    if (solvers.empty() || solvers.back().label != row.label) solvers.push_back({row.label, {}});
    solvers.back().by_kind[row.kind] = &row;
  }
  std::erase_if(solvers, [](const DrawnSolver& solver) {
    return std::none_of(solver.by_kind.begin(), solver.by_kind.end(),
                        [](const auto& each) { return each.second->trials > 0; });
  });
  return solvers;
}

/// A line per solver: the share of `kind` in percent, as a bar from 0 or as a point with its interval,
/// and the count.
Panel share_panel(const std::vector<DrawnSolver>& solvers, const std::string& kind,
                  const Look& look, double left) {
  const bool baseline = kind == "baseline";
  const double count = static_cast<double>(solvers.size());
  const auto percent = [](double share) { return 100 * share; };
  Series shares{.kind = baseline ? Series::Kind::boxes : Series::Kind::points};
  Series counts{.kind = Series::Kind::text, .size = 0.9, .align = Series::Align::right};
  for (std::size_t k = 0; k < solvers.size(); ++k) {
    const FlipRow& row = *solvers[k].by_kind.at(kind);
    const Index seen = baseline ? row.solved : row.flips();
    const double y = static_cast<double>(k);
    counts.marks.push_back({.x = baseline ? 98.0 : 127.0,
                            .y = y,
                            .text = row.trials > 0 ? fmt::format("{}/{}", seen, row.trials) : "-",
                            .look = {black}});
    if (row.trials == 0) continue;
    const double share = static_cast<double>(seen) / static_cast<double>(row.trials);
    const Interval interval = wilson_interval(seen, row.trials);
    Mark mark{.x = percent(share), .y = y, .look = look, .filled = seen == 0};
    if (baseline) {
      mark.x_low = 0, mark.x_high = mark.x;
      mark.y_low = y - 0.3, mark.y_high = y + 0.3;
    } else {
      mark.x_low = percent(interval.low), mark.x_high = percent(interval.high);
    }
    shares.marks.push_back(mark);
  }
  Panel panel{.area = {left, column_width, names_top, solver_height * count}};
  panel.x = {.label = baseline ? "instances (%)" : "flips (%)",
             .high = baseline ? 100.0 : 130.0,
             .ticks = {{0, "0"}, {50, "50"}, {100, "100"}}};
  panel.y = {.low = count - 0.3, .high = -0.7, .ticks = {{-2, ""}}, .grid = false};
  panel.series = {shares, counts};
  return panel;
}

}  // namespace

Figure flips_figure(const Flips& flips) {
  const std::vector<DrawnSolver> solvers = drawn_solvers(flips);
  if (solvers.empty()) throw std::invalid_argument("no run to draw: none was counted");
  std::size_t longest = 0;
  Index instances = 0;
  std::vector<Tick> names;
  for (const DrawnSolver& solver : solvers) {
    longest = std::max(longest, solver.label.size());
    instances = std::max(instances, solver.by_kind.at("baseline")->instances);
    names.push_back({static_cast<double>(names.size()), solver.label});
  }
  double left = std::max(least_names, name_letter * static_cast<double>(longest)) + names_margin;
  Figure figure{.title =
                    "How often does a verdict flip when the data change in ways that should "
                    "not matter?"};
  figure.caption = fmt::format(
      "{} instances; flips (solved becomes not solved, or the reverse) per disturbed run, in %. "
      "Bars: Wilson 95 % interval, as if runs of one instance were independent. Filled marker: no "
      "flip seen. A solver that solves little undisturbed has little to lose: read the rates "
      "beside "
      "the first column. Solved: residual at most {}.",
      instances, flips.tolerance);
  const auto add = [&](const std::string& title, const std::string& kind, const Look& look) {
    figure.panels.push_back(share_panel(solvers, kind, look, left));
    figure.panels.back().title = title;
    left += column_width + column_gap;
  };
  add("solved undisturbed", "baseline", {mid_grey});
  figure.panels.back().y.ticks = names;
  for (const DisturbanceKind kind : flips.options.kinds)
    add(column_title(kind), to_string(kind), look_at(static_cast<std::size_t>(kind)));
  figure.width = left + names_margin;
  figure.height = names_top + solver_height * static_cast<double>(solvers.size()) + foot_height;
  return figure;
}

}  // namespace lcp
