#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "harness/present/escaping.h"
#include "harness/runs/run_directory.h"
#include "harness/studies/table/table.h"
#include "problems/io/replace_file.h"
#include "solvers/options.h"

namespace lcp {

namespace {

/// One quantity of the table, named once for all renderers.
struct Quantity {
  std::string key;      ///< In CSV and JSON.
  std::string heading;  ///< In a terminal, at most six letters.
  std::string printed;  ///< In LaTeX, as in the paper where it has the quantity.
  std::string meaning;
  bool counted;        ///< A whole number.
  const char* number;  ///< Format of a value.
  bool always;         ///< In a terminal: shown even when 0 everywhere.
  bool of_starts;      ///< Shown to readers only where rows start differently.
  std::function<std::optional<double>(const TableRow&)> value;
};

Quantity count(std::string key, std::string heading, std::string printed, std::string meaning,
               Index TableRow::*field, bool always = true, bool of_starts = false) {
  return {std::move(key),
          std::move(heading),
          std::move(printed),
          std::move(meaning),
          true,
          "{:.0f}",
          always,
          of_starts,
          [field](const TableRow& row) { return double(row.*field); }};
}

Quantity number(std::string key, std::string heading, std::string printed, std::string meaning,
                const char* format, std::optional<double> TableRow::*field, bool always = true,
                bool of_starts = false) {
  return {std::move(key),
          std::move(heading),
          std::move(printed),
          std::move(meaning),
          false,
          format,
          always,
          of_starts,
          [field](const TableRow& row) { return row.*field; }};
}

/// What the paper's table states above the counts; a terminal shows it in the head of a block.
const std::vector<Quantity>& corpus_quantities() {
  static const std::vector<Quantity> all = {
      number("contacts", "", "contacts", "", "{:.2f}", &TableRow::contacts),
      number("active", "", "active", "", "{:.2f}", &TableRow::active),
      count("instances", "", "total frames", "", &TableRow::instances),
  };
  return all;
}

const std::vector<Quantity>& solver_quantities() {
  static const std::vector<Quantity> all = {
      count("success", "solved", "success", "claimed solved and passed the judge",
            &TableRow::success),
      count("failure", "failed", "failure", "no sol. + cycle + error", &TableRow::failure),
      count("no_solution", "no sol", "\\quad no solution",
            "ray, exhausted, infeasible or false-infeasible", &TableRow::no_solution),
      count("cycle", "cycle", "\\quad cycle", "cycle, limit or timeout", &TableRow::cycle),
      count("error", "error", "\\quad error", "wrong, inaccurate, singular, crash or memory",
            &TableRow::error),
      count("wrong", "wrong", "wrong", "of error: the claim fails the check", &TableRow::wrong,
            false),
      count("unclaimed", "uncl", "unclaimed", "of failed: z passes although a failure is claimed",
            &TableRow::unclaimed, false),
      count("unsupported", "unsup", "unsupported", "the method does not apply; not in failed",
            &TableRow::unsupported, false),
      count("not_run", "n.run", "not run", "left out as too large; not in failed",
            &TableRow::not_run, false),
      count("trivial", "triv", "trivial", "solved where z = 0 is a solution too; not in solved",
            &TableRow::trivial, false),
      number("pivots", "pivots", "pivots", "mean of basis changes, abandoned branches included",
             "{:.1f}", &TableRow::pivots),
      number("nodes", "nodes", "nodes", "mean of search nodes opened", "{:.1f}", &TableRow::nodes),
      number("sweeps", "sweeps", "sweeps", "mean of an iterative method's sweeps", "{:.1f}",
             &TableRow::sweeps, false, true),
      number("gained", "gained", "gained", "instances solved that the solver does not solve cold",
             "{:.0f}", &TableRow::gained, true, true),
      number("lost", "lost", "lost", "instances that it solves cold alone", "{:.0f}",
             &TableRow::lost, true, true),
      count("restarted", "again", "restarted",
            "instances where a start was replaced by a cold one, or a search by another",
            &TableRow::restarted, false, true),
      number("time_ratio", "t/cold", "time / time cold",
             "median of time over time cold, where both are solved", "{:.2f}",
             &TableRow::time_ratio, true, true),
      number("time_median_ms", "ms", "median time (ms)", "median time of the solved", "{:#.3g}",
             &TableRow::time_median_ms),
      number("residual_median", "resid", "median residual",
             "median natural residual of the solved, scaled", "{:.1e}", &TableRow::residual_median),
      number("residual_max", "max", "largest residual", "the largest of them", "{:.1e}",
             &TableRow::residual_max),
  };
  return all;
}

std::string cell(const Quantity& quantity, const TableRow& row, const std::string& empty) {
  const std::optional<double> value = quantity.value(row);
  if (!value) return empty;
  return *value == 0 ? "0" : fmt::format(fmt::runtime(quantity.number), *value);
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

std::string meaning(Acceptance::Criterion criterion) {
  return criterion == Acceptance::Criterion::residual
             ? "a natural residual"
             : "the paper's error |w - M z - q - z0 c| (unscaled)";
}

constexpr std::size_t name_width = 34;   ///< Longer names stand on a line of their own.
constexpr std::size_t start_width = 11;  ///< Of ` [two-step]`, where names have it.
constexpr std::size_t least_name_width = 4;
constexpr int count_width = 6;
constexpr int number_width = 7;

int width_of(const Quantity& quantity) { return quantity.counted ? count_width : number_width; }

std::string text(const Table& table) {
  if (table.rows.empty()) return "no rows\n";
  std::vector<Quantity> shown;
  for (const Quantity& quantity : solver_quantities()) {
    const bool any = std::any_of(table.rows.begin(), table.rows.end(), [&](const TableRow& row) {
      return quantity.value(row).value_or(0) != 0;
    });
    const bool has_place = quantity.always || any;
    if (has_place && (table.several_starts || !quantity.of_starts)) shown.push_back(quantity);
  }
  const std::size_t most = name_width + (table.several_starts ? start_width : 0);
  std::size_t width = least_name_width;
  for (const TableRow& row : table.rows)
    if (row.label.size() <= most) width = std::max(width, row.label.size());

  std::string out;
  for (const std::vector<TableRow>& block : blocks(table)) {
    out += corpus_heading(block) + "\n" + std::string(width, ' ');
    for (const Quantity& quantity : shown)
      out += fmt::format(" {:>{}}", quantity.heading, width_of(quantity));
    out += "\n";
    for (const TableRow& row : block) {
      out += row.label.size() > most ? row.label + "\n" + std::string(width, ' ')
                                     : fmt::format("{:<{}}", row.label, width);
      for (const Quantity& quantity : shown)
        out += fmt::format(" {:>{}}", cell(quantity, row, "-"), width_of(quantity));
      out += "\n";
    }
    out += "\n";
  }
  for (const Quantity& quantity : shown)
    out += fmt::format("  {:<7} {}\n", quantity.heading, quantity.meaning);
  out += fmt::format("Solved means {} of at most {}.", meaning(table.criterion), table.tolerance);
  if (table.start != "cold")
    out += fmt::format(" Start: {}; pivots before it are not counted.", table.start);
  if (table.jobs > 1)
    out += fmt::format(" {} jobs ran at the same time: times are disturbed.", table.jobs);
  return out + "\n";
}

template <class Visit>
void each_quantity(Visit visit) {
  for (const Quantity& quantity : corpus_quantities()) visit(quantity);
  for (const Quantity& quantity : solver_quantities()) visit(quantity);
}

nlohmann::ordered_json to_json(const TableRow& row, const Table& table) {
  nlohmann::ordered_json json = {
      {"solver", row.solver}, {"label", row.label}, {"corpus", row.corpus}, {"mode", "corpus"}};
  each_quantity([&](const Quantity& quantity) {
    const std::optional<double> value = quantity.value(row);
    if (!value) {
      json[quantity.key] = nullptr;
    } else if (quantity.counted) {
      json[quantity.key] = static_cast<Index>(*value);
    } else {
      json[quantity.key] = *value;
    }
  });
  for (const auto& [verdict, number_of] : row.verdicts)
    json["verdicts"][to_string(verdict)] = number_of;
  json["criterion"] = to_string(table.criterion);
  json["tolerance"] = table.tolerance;
  json["start"] = row.start;
  json["jobs"] = table.jobs;
  return json;
}

std::string json_text(const Table& table) {
  nlohmann::ordered_json json;
  json["rows"] = nlohmann::ordered_json::array();
  for (const TableRow& row : table.rows) json["rows"].push_back(to_json(row, table));
  return json.dump(1) + "\n";
}

std::string csv(const Table& table) {
  std::string out = "solver,corpus,mode";
  each_quantity([&](const Quantity& quantity) { out += fmt::format(",{}", quantity.key); });
  out += ",criterion,tolerance,start,jobs\n";
  for (const TableRow& row : table.rows) {
    out += fmt::format("{},{},corpus", csv_quoted(row.solver), csv_quoted(row.corpus));
    each_quantity([&](const Quantity& quantity) {
      const std::optional<double> value = quantity.value(row);
      out += fmt::format(",{}", value ? shortest(*value) : "");
    });
    out += fmt::format(",{},{},{},{}\n", to_string(table.criterion), table.tolerance,
                       csv_quoted(row.start), table.jobs);
  }
  return out;
}

/// A solver as the head of a column, a line per setting.
std::string column_head(const TableRow& row) {
  std::string name = row.label;
  std::replace(name.begin(), name.end(), ':', ',');
  std::string lines;
  std::size_t begin = 0;
  while (begin <= name.size()) {
    const std::size_t end = std::min(name.find(',', begin), name.size());
    if (begin > 0) lines += "\\\\ ";
    lines += latex_escaped(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return "\\begin{tabular}[b]{@{}r@{}}" + lines + "\\end{tabular}";
}

std::string latex(const Table& table) {
  std::string out =
      fmt::format("% {} at most {}, {} start, {} job{}\n",
                  table.criterion == Acceptance::Criterion::residual ? "natural residual"
                                                                     : "|w - M z - q - z0 c|",
                  table.tolerance, table.start, table.jobs, table.jobs == 1 ? "" : "s");
  for (const std::vector<TableRow>& block : blocks(table)) {
    out += fmt::format("% {}\n\\begin{{tabular}}{{l|{}}}\n", block.front().corpus,
                       std::string(block.size(), 'r'));
    for (const TableRow& row : block) out += " & " + column_head(row);
    out += " \\\\ \\hline\n";
    each_quantity([&](const Quantity& quantity) {
      if (quantity.of_starts && !table.several_starts) return;
      out += quantity.printed;
      for (const TableRow& row : block) out += " & " + cell(quantity, row, "--");
      out += " \\\\\n";
    });
    out += "\\end{tabular}\n\n";
  }
  return out;
}

}  // namespace

std::vector<TableColumn> table_columns() {
  std::vector<TableColumn> columns;
  for (const Quantity& quantity : solver_quantities())
    columns.push_back({quantity.key, quantity.heading, quantity.meaning, quantity.number,
                       quantity.always, quantity.of_starts});
  return columns;
}

std::string render(const Table& table, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return text(table);
    case TableFormat::csv:
      return csv(table);
    case TableFormat::json:
      return json_text(table);
    case TableFormat::latex:
      return latex(table);
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
