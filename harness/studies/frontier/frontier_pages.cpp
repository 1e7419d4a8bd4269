#include "harness/studies/frontier/frontier_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>

#include "harness/present/columns.h"

namespace lcp {

namespace {

using nlohmann::json;

constexpr const char* frontier_legend =
    R"(  a [b, c]    half of the draws are solved at a; at 95 % the line lies in b ... c (Wilson)
  ... rising  more are solved above the line, fewer below it
  above       more than half are solved in every cell; below: fewer than half
  crosses Nx  the share is not monotone: decided cells change sides N times, near the values named
  >           the band is open towards the edge of the grid
  *           still wider, or less certain, than asked for after all the draws allowed
  not counted no draw counts: unsupported, not run, or z = 0 solves it
)";
constexpr const char* agree_legend =
    R"(  agree       columns where both seeds' bands overlap, or that have no line with either seed and no
              cell decided differently; in brackets, of the lines, those of the second seed in the
              first one's own band
)";

std::string printed_value(const KnobAxis& y, double position) {
  if (std::isfinite(position)) return three_digits(y.value_at(position));
  return position < 0 ? "<" + three_digits(y.values.front()) : ">" + three_digits(y.values.back());
}

std::string line_in_words(const KnobAxis& y, const FrontierColumn& column) {
  const ShareLine& line = column.line;
  std::string words = to_string(line.kind);
  if (line.kind == ShareLine::Kind::nothing) return "not counted";
  if (line.kind == ShareLine::Kind::crossing)
    words = fmt::format("{} [{}, {}]{}", printed_value(y, line.u), printed_value(y, line.low),
                        printed_value(y, line.high), line.rising ? " rising" : "");
  if (line.kind == ShareLine::Kind::several) {
    std::vector<std::string> places;
    for (const double u : line.crossings) places.push_back(printed_value(y, u));
    words = fmt::format("crosses {}x: {}", places.size(), fmt::join(places, ", "));
  }
  return words + (column.settled ? "" : " *");
}

/// A solver's lines with one seed.
struct TextLine {
  std::string solver;
  std::uint64_t seed;
  const FrontierRow& row;
  std::string agree = {};
};

std::string lines_text(const FrontierReport& report, const std::vector<SeedAgreement>& again) {
  const KnobAxis &x = report.first.plan.grid.x, &y = report.first.plan.grid.y;
  std::vector<Column<TextLine>> columns = {
      {{"", " "}, [](const TextLine& line) { return line.solver; }},
      {{"", "seed"}, [](const TextLine& line) { return line.seed; }}};
  for (std::size_t i = 0; i < x.size(); ++i)
    columns.push_back(
        {{"", " " + x.knob + "=" + three_digits(x.values[i])},
         [i, &y](const TextLine& line) { return " " + line_in_words(y, line.row.columns[i]); }});
  if (report.second)
    columns.push_back({{"", " agree"}, [](const TextLine& line) { return " " + line.agree; }});
  std::vector<TextLine> lines;
  for (std::size_t s = 0; s < report.first.rows.size(); ++s) {
    const FrontierRow& row = report.first.rows[s];
    lines.push_back({row.solver, report.first.plan.seed, row});
    if (!report.second) continue;
    const SeedAgreement& of = again[s];
    lines.push_back(
        {"", report.second->plan.seed, report.second->rows[s],
         fmt::format("{} of {}{}", of.agree, of.column_agrees.size(),
                     of.lines > 0 ? fmt::format(" ({} of {})", of.within, of.lines) : "")});
  }
  return text_table(cells_of(columns, lines));
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
  return folded(
      fmt::format("Both seeds agree in {} of {} columns; of {} lines that both find, the second "
                  "seed's lies in the first's own band in {}.",
                  agree, columns, lines, within));
}

double timeout_s(const FrontierPlan& plan) {
  return std::chrono::duration<double>(plan.limits.timeout).count();
}

/// A cell of a frontier in its place.
struct CsvLine {
  const std::string& solver;
  double x, y;
  const FrontierCell& cell;
};

CellTable csv_cells(const Frontier& frontier) {
  const FrontierGrid& grid = frontier.plan.grid;
  const auto share = [](const char* key, double Interval::*end) -> Column<CsvLine> {
    Column<CsvLine> column{{key}, [end](const CsvLine& line) {
                             return wilson_interval(line.cell.solved, line.cell.counted).*end;
                           }};
    column.exact = "{:.4f}";
    return column;
  };
  const std::vector<Column<CsvLine>> columns = {
      {{"solver"}, [](const CsvLine& line) { return line.solver; }},
      {{"seed"}, [&](const CsvLine&) { return frontier.plan.seed; }},
      {{grid.x.knob}, [](const CsvLine& line) { return line.x; }},
      {{grid.y.knob}, [](const CsvLine& line) { return line.y; }},
      {{"drawn"}, [](const CsvLine& line) { return line.cell.drawn; }},
      {{"counted"}, [](const CsvLine& line) { return line.cell.counted; }},
      {{"solved"}, [](const CsvLine& line) { return line.cell.solved; }},
      share("share_low", &Interval::low),
      share("share_high", &Interval::high),
      {{"pivots_median"},
       [](const CsvLine& line) { return line.cell.pivots ? Cell(*line.cell.pivots) : Cell(); }},
      {{"verdicts"}, [](const CsvLine& line) {
         std::vector<std::string> counts;
         for (const auto& [verdict, count] : line.cell.verdicts)
           counts.push_back(fmt::format("{} {}", to_string(verdict), count));
         return fmt::format("{}", fmt::join(counts, "; "));
       }}};
  std::vector<CsvLine> lines;
  for (const FrontierRow& row : frontier.rows)
    for (std::size_t x = 0; x < grid.x.size(); ++x)
      for (std::size_t y = 0; y < grid.y.size(); ++y)
        lines.push_back({row.solver, grid.x.values[x], grid.y.values[y], row.columns[x].cells[y]});
  return cells_of(columns, lines);
}

json axis_json(const KnobAxis& axis) {
  return {{"knob", axis.knob}, {"values", axis.values}, {"geometric", axis.geometric}};
}

/// The knob's value at a position of y; null for an open end.
json value_json(const KnobAxis& y, double position) {
  return std::isfinite(position) ? json(y.value_at(position)) : json();
}

json cell_json(double y, const FrontierCell& cell) {
  const Interval interval = wilson_interval(cell.solved, cell.counted);
  json verdicts = json::object();
  for (const auto& [verdict, count] : cell.verdicts) verdicts[to_string(verdict)] = count;
  return {{"y", y},
          {"drawn", cell.drawn},
          {"counted", cell.counted},
          {"solved", cell.solved},
          {"low", interval.low},
          {"high", interval.high},
          {"pivots_median", cell.pivots ? json(*cell.pivots) : json()},
          {"verdicts", verdicts}};
}

json column_json(double x, const KnobAxis& y, const FrontierColumn& column) {
  const ShareLine& line = column.line;
  json object = {{"x", x}, {"line", to_string(line.kind)}, {"settled", column.settled}};
  if (line.kind == ShareLine::Kind::crossing) {
    object["y"] = value_json(y, line.u);
    object["low"] = value_json(y, line.low);
    object["high"] = value_json(y, line.high);
    object["rising"] = line.rising;
  }
  for (const double u : line.crossings)
    if (line.kind == ShareLine::Kind::several) object["crossings"].push_back(value_json(y, u));
  for (std::size_t i = 0; i < column.cells.size(); ++i)
    object["cells"].push_back(cell_json(y.values[i], column.cells[i]));
  return object;
}

json rows_json(const Frontier& frontier) {
  const FrontierGrid& grid = frontier.plan.grid;
  json rows = json::array();
  for (const FrontierRow& row : frontier.rows) {
    rows.push_back({{"solver", row.solver}});
    for (std::size_t x = 0; x < row.columns.size(); ++x)
      rows.back()["columns"].push_back(column_json(grid.x.values[x], grid.y, row.columns[x]));
  }
  return rows;
}

std::string frontier_text(const FrontierReport& report) {
  const FrontierPlan& plan = report.first.plan;
  std::string text = folded(fmt::format(
      "{}: where along {} the share of solved draws crosses 1/2, by {}; {} to {} draws a cell",
      plan.grid.family, plan.grid.y.knob, plan.grid.x.knob, plan.count, plan.max_count));
  for (const KnobAxis* axis : {&plan.grid.y, &plan.grid.x})
    text +=
        folded(fmt::format("  {} = {} ... {}{}: {}", axis->knob, three_digits(axis->values.front()),
                           three_digits(axis->values.back()), axis->geometric ? ", geometric" : "",
                           knob_meaning(plan.grid, axis->knob)),
               100, 4);
  std::vector<SeedAgreement> again;
  if (report.second) again = seed_agreements(report.first, *report.second);
  text += "\n" + lines_text(report, again) + "\n";
  if (report.second) text += agreement(again) + "\n";
  text += frontier_legend;
  if (report.second) text += agree_legend;
  return text + fmt::format("Solved means a natural residual of at most {}, within {} s.\n",
                            plan.limits.tolerance, timeout_s(plan));
}

json frontier_json(const FrontierReport& report) {
  const FrontierPlan& plan = report.first.plan;
  json object = {{"family", plan.grid.family},
                 {"x", axis_json(plan.grid.x)},
                 {"y", axis_json(plan.grid.y)},
                 {"tolerance", plan.limits.tolerance},
                 {"timeout_s", timeout_s(plan)},
                 {"count", plan.count},
                 {"max_count", plan.max_count},
                 {"band_decades", plan.band},
                 {"seed", plan.seed},
                 {"rows", rows_json(report.first)}};
  if (!report.second) return object;
  json& check = object["check"] = {{"seed", report.second->plan.seed},
                                   {"rows", rows_json(*report.second)},
                                   {"agreement", json::array()}};
  const std::vector<SeedAgreement> all = seed_agreements(report.first, *report.second);
  for (std::size_t s = 0; s < all.size(); ++s)
    check["agreement"].push_back({{"solver", report.first.rows[s].solver},
                                  {"columns", all[s].column_agrees},
                                  {"agree", all[s].agree},
                                  {"lines", all[s].lines},
                                  {"within", all[s].within}});
  return object;
}

}  // namespace

Described described(const FrontierReport& report) {
  const auto& [first, second] = report;
  return {frontier_text(report),
          csv_text(csv_cells(first)) + (second ? csv_rows(csv_cells(*second)) : ""),
          frontier_json(report), frontier_figure(first)};
}

}  // namespace lcp
