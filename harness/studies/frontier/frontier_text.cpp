#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "harness/studies/frontier/frontier_render.h"

namespace lcp {

namespace {

constexpr const char* frontier_legend =
    R"(  a [b, c]    half of the draws are solved at a; at 95 % the line lies in b ... c (Wilson)
  ... rising  more are solved above the line, fewer below it
  above       more than half are solved in every cell; below: fewer than half
  crosses Nx  the share is not monotone: decided cells change sides N times, near the values named
  >           the band is open towards the edge of the grid
  *           still wider, or less certain, than asked for after all the draws allowed
  not counted no draw counts: unsupported, not run, or z = 0 solves it
)";

std::string printed_value(const KnobAxis& axis, double position) {
  return three_digits(axis.value_at(position));
}

std::string band_end(const KnobAxis& y, double position) {
  if (std::isfinite(position)) return printed_value(y, position);
  return position < 0 ? fmt::format("<{}", three_digits(y.values.front()))
                      : fmt::format(">{}", three_digits(y.values.back()));
}

std::string line_in_words(const KnobAxis& y, const FrontierColumn& column) {
  const ShareLine& line = column.line;
  const std::string mark = column.settled ? "" : " *";
  switch (line.kind) {
    case ShareLine::Kind::crossing:
      return fmt::format("{} [{}, {}]{}{}", printed_value(y, line.u), band_end(y, line.low),
                         band_end(y, line.high), line.rising ? " rising" : "", mark);
    case ShareLine::Kind::above:
      return "above" + mark;
    case ShareLine::Kind::below:
      return "below" + mark;
    case ShareLine::Kind::several: {
      std::string text = fmt::format("crosses {}x", line.crossings.size());
      for (const double u : line.crossings)
        text += fmt::format("{} {}", u == line.crossings.front() ? ":" : ",", printed_value(y, u));
      return text + mark;
    }
    case ShareLine::Kind::nothing:
      return "not counted";
  }
  return "";
}

/// Columns of text, each as wide as its longest entry.
std::string aligned_columns(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths;
  for (const auto& line : lines) {
    widths.resize(std::max(widths.size(), line.size()));
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i)
      row += fmt::format("{:<{}}", line[i], widths[i] + (i + 1 < line.size() ? 2 : 0));
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

std::vector<std::string> line_of(const std::string& name, std::uint64_t seed,
                                 const Frontier& frontier, std::size_t solver) {
  std::vector<std::string> line{name, std::to_string(seed)};
  for (const FrontierColumn& column : frontier.rows[solver].columns)
    line.push_back(line_in_words(frontier.plan.grid.y, column));
  return line;
}

/// Of all solvers together.
std::string agreement(const std::vector<SeedAgreement>& all) {
  std::size_t columns = 0;
  Index agree = 0, lines = 0, within = 0;
  for (const SeedAgreement& solver : all) {
    columns += solver.column_agrees.size();
    agree += solver.agree;
    lines += solver.lines;
    within += solver.within;
  }
  return fmt::format(
      "Both seeds agree in {} of {} columns; of {} lines that both find, the second seed's lies in "
      "the first's\nown band in {}.\n",
      agree, columns, lines, within);
}

std::string in_words(const SeedAgreement& of) {
  return fmt::format("{} of {}{}", of.agree, of.column_agrees.size(),
                     of.lines > 0 ? fmt::format(" ({} of {})", of.within, of.lines) : "");
}

}  // namespace

std::string frontier_text(const FrontierReport& report) {
  const FrontierPlan& plan = report.first.plan;
  const KnobAxis &x = plan.grid.x, &y = plan.grid.y;
  std::string text = fmt::format(
      "{}: where along {} the share of solved draws crosses 1/2, by {}; {} to {} draws a cell\n",
      plan.grid.family, y.knob, x.knob, plan.count, plan.max_count);
  for (const KnobAxis* axis : {&y, &x})
    text += fmt::format("  {} = {} ... {}{}: {}\n", axis->knob, three_digits(axis->values.front()),
                        three_digits(axis->values.back()), axis->geometric ? ", geometric" : "",
                        knob_meaning(plan.grid, axis->knob));
  text += "\n";

  std::vector<std::vector<std::string>> lines{{"", "seed"}};
  for (const double at : x.values) lines[0].push_back(x.knob + "=" + three_digits(at));
  std::vector<SeedAgreement> again;
  if (report.second) {
    again = seed_agreements(report.first, *report.second);
    lines[0].push_back("agree");
  }
  for (std::size_t s = 0; s < report.first.rows.size(); ++s) {
    lines.push_back(line_of(report.first.rows[s].solver, plan.seed, report.first, s));
    if (!report.second) continue;
    lines.push_back(line_of("", report.second->plan.seed, *report.second, s));
    lines.back().push_back(in_words(again[s]));
  }
  text += aligned_columns(lines) + "\n";
  if (report.second) text += agreement(again) + "\n";
  text += frontier_legend;
  if (report.second)
    text +=
        "  agree       columns where both seeds' bands overlap, or that have no line with either "
        "seed and no\n              cell decided differently; in brackets, of the lines, those of "
        "the second seed in the\n              first one's own band\n";
  return text + fmt::format("Solved means a natural residual of at most {}, within {} s.\n",
                            plan.limits.tolerance,
                            std::chrono::duration<double>(plan.limits.timeout).count());
}

std::string to_string(ShareLine::Kind kind) {
  switch (kind) {
    case ShareLine::Kind::crossing:
      return "crossing";
    case ShareLine::Kind::above:
      return "above";
    case ShareLine::Kind::below:
      return "below";
    case ShareLine::Kind::several:
      return "several";
    case ShareLine::Kind::nothing:
      return "nothing";
  }
  return "";
}

}  // namespace lcp
