#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "harness/present/columns.h"
#include "harness/present/escaping.h"
#include "harness/runs/run_directory.h"
#include "harness/studies/table/table.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

using TableColumns = std::vector<Column<TableRow>>;

/// Shown in a terminal: always, or only where it is not 0 everywhere.
enum class Shown { always, if_any };

template <class Field>
Column<TableRow> of(Field TableRow::*field, const char* key, const char* heading, const char* latex,
                    const char* meaning, const char* number = "{:.0f}",
                    Shown shown = Shown::always) {
  return {{.key = key,
           .heading = heading,
           .meaning = meaning,
           .number = number,
           .latex = latex,
           .only_if_any = shown == Shown::if_any},
          [field](const TableRow& row) {
            if constexpr (std::is_same_v<Field, Index>)
              return Cell(row.*field);
            else
              return cell_of(row.*field);
          }};
}

/// What the paper's table states above the counts; a terminal shows it in the head of a block.
TableColumns corpus_columns() {
  return {of(&TableRow::contacts, "contacts", "", "contacts", "", "{:.2f}"),
          of(&TableRow::active, "active", "", "active", "", "{:.2f}"),
          of(&TableRow::instances, "instances", "", "total frames", "")};
}

TableColumns joined(std::initializer_list<TableColumns> parts) {
  TableColumns all;
  for (const TableColumns& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// What a solver did; in LaTeX as in the paper where it has the quantity.
TableColumns solver_columns(bool several_starts) {
  using T = TableRow;
  TableColumns counts = {
      of(&T::success, "success", "solved", "success", "claimed solved and passed the judge"),
      of(&T::failure, "failure", "failed", "failure", "no sol. + cycle + error"),
      of(&T::no_solution, "no_solution", "no sol", "\\quad no solution",
         "ray, exhausted, infeasible or false-infeasible"),
      of(&T::cycle, "cycle", "cycle", "\\quad cycle", "cycle, limit or timeout"),
      of(&T::error, "error", "error", "\\quad error",
         "wrong, inaccurate, singular, crash or memory"),
      of(&T::wrong, "wrong", "wrong", "wrong", "of error: the claim fails the check", "{:.0f}",
         Shown::if_any),
      of(&T::unclaimed, "unclaimed", "uncl", "unclaimed",
         "of failed: z passes although a failure is claimed", "{:.0f}", Shown::if_any),
      of(&T::unsupported, "unsupported", "unsup", "unsupported",
         "the method does not apply; not in failed", "{:.0f}", Shown::if_any),
      of(&T::not_run, "not_run", "n.run", "not run", "left out as too large; not in failed",
         "{:.0f}", Shown::if_any),
      of(&T::trivial, "trivial", "triv", "trivial",
         "solved where z = 0 is a solution too; not in solved", "{:.0f}", Shown::if_any),
      of(&T::pivots, "pivots", "pivots", "pivots",
         "mean of basis changes, abandoned branches included", "{:.1f}"),
      of(&T::nodes, "nodes", "nodes", "nodes", "mean of search nodes opened", "{:.1f}")};
  TableColumns of_starts = {
      of(&T::sweeps, "sweeps", "sweeps", "sweeps", "mean of an iterative method's sweeps", "{:.1f}",
         Shown::if_any),
      of(&T::gained, "gained", "gained", "gained",
         "instances solved that the solver does not solve cold"),
      of(&T::lost, "lost", "lost", "lost", "instances that it solves cold alone"),
      of(&T::restarted, "restarted", "again", "restarted",
         "instances where a start was replaced by a cold one, or a search by another", "{:.0f}",
         Shown::if_any),
      of(&T::time_ratio, "time_ratio", "t/cold", "time / time cold",
         "median of time over time cold, where both are solved", "{:.2f}")};
  TableColumns measured = {of(&T::time_median_ms, "time_median_ms", "ms", "median time (ms)",
                              "median time of the solved", "{:#.3g}"),
                           of(&T::residual_median, "residual_median", "resid", "median residual",
                              "median natural residual of the solved, scaled", "{:.1e}"),
                           of(&T::residual_max, "residual_max", "max", "largest residual",
                              "the largest of them", "{:.1e}")};
  return joined({counts, several_starts ? of_starts : TableColumns{}, measured});
}

/// By what its rows were judged, and how they ran.
TableColumns table_wide_columns(const Table& table) {
  return {{{.key = "criterion"}, [&](const TableRow&) { return Cell(to_string(table.criterion)); }},
          {{.key = "tolerance"}, [&](const TableRow&) { return Cell(table.tolerance); }},
          {{.key = "start"}, [](const TableRow& row) { return Cell(row.start); }},
          {{.key = "jobs"}, [&](const TableRow&) { return Cell(table.jobs); }}};
}

std::vector<std::vector<TableRow>> blocks(const Table& table) {
  std::vector<std::vector<TableRow>> blocks;
  for (const TableRow& row : table.rows) {
    if (blocks.empty() || blocks.back().front().corpus != row.corpus) blocks.emplace_back();
    blocks.back().push_back(row);
  }
  return blocks;
}

std::string corpus_heading(const std::vector<TableRow>& block) {
  const auto [least, most] = std::minmax_element(
      block.begin(), block.end(),
      [](const TableRow& a, const TableRow& b) { return a.instances < b.instances; });
  std::string heading = fmt::format("{}: {} instance{}", block.front().corpus, most->instances,
                                    most->instances == 1 ? "" : "s");
  if (least->instances < most->instances)
    heading += fmt::format(" (only {} with {})", least->instances, least->label);
  if (most->contacts) heading += fmt::format(", {:.1f} contacts", *most->contacts);
  if (most->active) heading += fmt::format(", {:.1f} active", *most->active);
  return heading;
}

std::string table_text(const Table& table) {
  if (table.rows.empty()) return "no rows\n";
  TableColumns columns = solver_columns(table.several_starts);
  columns.insert(columns.begin(),
                 {{.heading = "solver"}, [](const TableRow& row) { return Cell(row.label); }});
  std::string out;
  for (const std::vector<TableRow>& block : blocks(table))
    out += folded(corpus_heading(block), 100, 2) + text_table(cells_of(columns, block)) + "\n";
  out += legend(cells_of(columns, table.rows));
  std::string note = fmt::format("Solved means {} of at most {}.",
                                 table.criterion == Acceptance::Criterion::residual
                                     ? "a natural residual"
                                     : "the paper's error |w - M z - q - z0 c| (unscaled)",
                                 table.tolerance);
  if (table.start != "cold")
    note += fmt::format(" Start: {}; pivots before it are not counted.", table.start);
  if (table.jobs > 1)
    note += fmt::format(" {} jobs ran at the same time: times are disturbed.", table.jobs);
  return out + folded(note);
}

std::string table_json(const Table& table) {
  const TableColumns quantities = joined({corpus_columns(), solver_columns(true)});
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const TableRow& row : table.rows) {
    nlohmann::ordered_json object = json_object(
        quantities, row,
        {{"solver", row.solver}, {"label", row.label}, {"corpus", row.corpus}, {"mode", "corpus"}});
    for (const auto& [verdict, count] : row.verdicts)
      object["verdicts"][to_string(verdict)] = count;
    rows.push_back(json_object(table_wide_columns(table), row, std::move(object)));
  }
  return nlohmann::ordered_json{{"rows", std::move(rows)}}.dump(1) + "\n";
}

std::string table_csv(const Table& table) {
  const TableColumns names = {
      {{.key = "solver"}, [](const TableRow& row) { return Cell(row.solver); }},
      {{.key = "corpus"}, [](const TableRow& row) { return Cell(row.corpus); }},
      {{.key = "mode"}, [](const TableRow&) { return Cell("corpus"); }}};
  return csv_text(
      cells_of(joined({names, corpus_columns(), solver_columns(true), table_wide_columns(table)}),
               table.rows));
}

/// A solver as the head of a column, a line per setting.
std::string column_head(const TableRow& row) {
  std::string lines;
  for (const char c : row.label)
    lines += c == ':' || c == ',' ? "\\\\ " : latex_escaped(std::string(1, c));
  return "\\begin{tabular}[b]{@{}r@{}}" + lines + "\\end{tabular}";
}

std::string table_latex(const Table& table) {
  std::string out =
      fmt::format("% {} at most {}, {} start, {} job{}\n",
                  table.criterion == Acceptance::Criterion::residual ? "natural residual"
                                                                     : "|w - M z - q - z0 c|",
                  table.tolerance, table.start, table.jobs, table.jobs == 1 ? "" : "s");
  const TableColumns columns = joined({corpus_columns(), solver_columns(table.several_starts)});
  for (const std::vector<TableRow>& block : blocks(table)) {
    std::vector<std::string> heads;
    for (const TableRow& row : block) heads.push_back(column_head(row));
    out +=
        "% " + block.front().corpus + "\n" + latex_tabular(cells_of(columns, block), heads) + "\n";
  }
  return out;
}

}  // namespace

std::vector<ColumnHead> table_columns(bool several_starts) {
  const TableColumns columns = solver_columns(several_starts);
  return {columns.begin(), columns.end()};
}

std::string render(const Table& table, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return table_text(table);
    case TableFormat::csv:
      return table_csv(table);
    case TableFormat::json:
      return table_json(table);
    case TableFormat::latex:
      return table_latex(table);
  }
  throw std::logic_error("unknown table format");
}

Table write_tables(const std::filesystem::path& directory) {
  const Table table = make_table(read_run(directory));
  const auto write = [&](const char* name, TableFormat format) {
    replace_file((directory / name).string(), render(table, format));
  };
  write("table.txt", TableFormat::text);
  write("table.csv", TableFormat::csv);
  write("table.json", TableFormat::json);
  return table;
}

}  // namespace lcp
