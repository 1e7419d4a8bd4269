#include "harness/report/report_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>

#include "harness/judge/acceptance.h"
#include "harness/present/columns.h"
#include "harness/present/figure.h"
#include "harness/report/origin_command.h"
#include "harness/runs/run_directory.h"
#include "harness/studies/table/table.h"
#include "problems/io/errors.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Ordered = nlohmann::ordered_json;

/// Numbers its keys in order of first appearance.
template <class Key>
class Places {
 public:
  /// The place of `key`, and whether it is new.
  std::pair<std::size_t, bool> operator()(const Key& key) {
    const auto [entry, added] = places_.emplace(key, places_.size());
    return {entry->second, added};
  }

 private:
  std::map<Key, std::size_t> places_;
};

/// A list, or its one value where all entries are equal.
Ordered compact(Ordered list) {
  if (list.empty()) return list;
  const bool constant = std::all_of(list.begin(), list.end(),
                                    [&](const Ordered& entry) { return entry == list.front(); });
  if (constant) return {{"all", list.front()}};
  return list;
}

/// A number with four digits; what is no number stays as it is.
json rounded(const json& value) {
  if (!value.is_number_float()) return value;
  return std::strtod(fmt::format("{:.3e}", value.get<double>()).c_str(), nullptr);
}

Ordered command_to_json(const InstanceCommand& command) {
  return {{"before", command.before},
          {"where", command.where},
          {"after", command.after},
          {"note", command.note}};
}

Ordered instance_to_json(const Record& record, const std::optional<Origin>& origin) {
  const InstanceCommand command = origin_command(record.instance, record.corpus, origin);
  Ordered object = {{"name", record.instance},
                    {"corpus", record.corpus},
                    {"n", record.n},
                    {"contacts", record.contacts},
                    {"active", nullptr},
                    {"sha256", record.sha256},
                    {"command", command_to_json(command)}};
  if (record.active_contacts) object["active"] = *record.active_contacts;
  const bool from_suite = origin && !origin->suite.empty();
  const auto again = from_suite ? std::nullopt : simulated_again(record.instance, record.corpus);
  if (again) object["simulated"] = command_to_json(*again);
  return object;
}

/// Figures of a row: what it stores of accuracy and work, and its times.
void add_figures(const Record& record, std::map<std::string, Ordered>& columns, std::size_t row) {
  const json object = record;
  const auto put = [&](const std::string& name, const json& value) {
    Ordered& column = columns[name];
    if (column.is_null()) column = Ordered::array();
    while (column.size() < row) column.push_back(nullptr);  // Rows before had none.
    column.push_back(Ordered(value));
  };
  if (object.contains("accuracy"))
    for (const auto& [name, value] : object.at("accuracy").items())
      put(name, name == "residual" || name == "zero_residual" ? value : rounded(value));
  for (const auto& [name, value] : object.at("work").items()) put("work." + name, value);
  put("samples", record.times_ns.size());
  if (record.times_ns.empty()) return;
  put("median_ns", *record.median_ns());
  put("least_ns", *std::min_element(record.times_ns.begin(), record.times_ns.end()));
  put("most_ns", *std::max_element(record.times_ns.begin(), record.times_ns.end()));
}

struct Gathered {
  Ordered instances = Ordered::array(), variants = Ordered::array(), strings = Ordered::array();
  Ordered rows;
};

Gathered gather(const ReportedRun& run) {
  Gathered gathered;
  Places<std::pair<Index, std::string>> instances;
  Places<std::pair<std::string, std::string>> variants;
  Places<std::string> strings;
  const auto place_of_string = [&](const std::string& text) {
    const auto [place, added] = strings(text);
    if (added) gathered.strings.push_back(text);
    return place;
  };
  const std::map<std::string, std::string> names = labels(run.rows);
  std::set<std::string> starts;
  for (const Record& record : run.rows) starts.insert(record.start);
  const std::optional<Origin> origin =
      run.settings ? std::optional(run.settings->origin) : std::nullopt;

  std::map<std::string, Ordered> columns;
  const std::vector<Verdict>& verdicts = all_values<Verdict>();
  for (std::size_t row = 0; row < run.rows.size(); ++row) {
    const Record& record = run.rows[row];
    const auto [instance, new_instance] = instances({record.place, record.instance});
    if (new_instance) gathered.instances.push_back(instance_to_json(record, origin));
    const auto [variant, new_variant] = variants({record.solver, record.start});
    if (new_variant)
      gathered.variants.push_back(
          {{"solver", record.solver},
           {"label", starts.size() > 1
                         ? fmt::format("{} [{}]", names.at(record.solver), record.start)
                         : names.at(record.solver)},
           {"row", record.row},
           {"version", record.version},
           {"start", record.start},
           {"options", record.options},
           {"arguments", solver_arguments(record)}});
    columns["instance"].push_back(instance);
    columns["variant"].push_back(variant);
    columns["verdict"].push_back(std::find(verdicts.begin(), verdicts.end(), record.verdict) -
                                 verdicts.begin());
    columns["claim"].push_back(
        decided_by_runner(record.verdict) ? Ordered() : Ordered(to_string(record.claim)));
    columns["message"].push_back(place_of_string(record.message));
    columns["tolerance"].push_back(record.tolerance);
    columns["signal"].push_back(record.exit_signal);
    columns["stderr"].push_back(place_of_string(record.stderr_end));
    columns["jobs"].push_back(record.jobs);
    columns["environment"].push_back(record.environment);
    add_figures(record, columns, row);
  }
  std::vector<std::string> registry_rows;
  for (const Ordered& variant : gathered.variants) registry_rows.push_back(variant.at("row"));
  const std::vector<Look> looks = looks_of_settings(registry_rows);
  for (std::size_t i = 0; i < looks.size(); ++i) gathered.variants[i]["look"] = to_json(looks[i]);
  gathered.rows["count"] = run.rows.size();
  for (auto& [name, column] : columns) {
    while (column.size() < run.rows.size()) column.push_back(nullptr);
    gathered.rows[name] = compact(std::move(column));
  }
  return gathered;
}

/// The rows of table.json, by quantity.
Ordered by_quantity(const Table& table) {
  const Ordered rows = Ordered::parse(render(table, TableFormat::json)).at("rows");
  Ordered columns;
  for (const Ordered& row : rows)
    for (const auto& [key, value] : row.items()) columns[key].push_back(value);
  for (auto& [key, column] : columns.items()) column = compact(std::move(column));
  return columns;
}

/// The tolerance of all rows; empty where they were judged at several.
std::optional<double> own_tolerance(const std::vector<Record>& rows) {
  const double first = rows.front().tolerance;
  const bool same = std::all_of(rows.begin(), rows.end(),
                                [&](const Record& row) { return row.tolerance == first; });
  return same ? std::optional(first) : std::nullopt;
}

/// A tolerance at which the page judges, and whether the run itself was judged at it.
struct Level {
  double tolerance;
  bool own;

  std::optional<Acceptance> acceptance() const {
    return own ? std::nullopt : std::optional(Acceptance{.tolerance = tolerance});
  }
};

std::vector<Level> levels_of(const std::vector<Record>& rows) {
  const std::optional<double> own = own_tolerance(rows);
  std::vector<double> tolerances = report_tolerances();
  if (own && std::find(tolerances.begin(), tolerances.end(), *own) == tolerances.end())
    tolerances.push_back(*own);
  std::sort(tolerances.rbegin(), tolerances.rend());
  std::vector<Level> levels;
  for (const double tolerance : tolerances) levels.push_back({tolerance, own == tolerance});
  return levels;
}

/// What judged() says of every row at every tolerance, as places in a list of what it says of any.
Ordered judgements(const std::vector<Record>& rows, const std::vector<Level>& levels) {
  Ordered kinds = Ordered::array(), at = Ordered::array();
  Places<std::pair<Verdict, std::pair<bool, bool>>> places;
  for (const Level& level : levels) {
    Ordered list = Ordered::array();
    for (const Record& record : rows) {
      const Judged result = judged(record, level.acceptance());
      const auto [place, added] = places({result.verdict, {result.trivial, result.unclaimed}});
      if (added)
        kinds.push_back({{"verdict", to_string(result.verdict)},
                         {"column", to_string(result.standing())},
                         {"unclaimed", result.unclaimed},
                         {"counted", result.counted()}});
      list.push_back(place);
    }
    at.push_back(compact(std::move(list)));
  }
  return {{"kinds", std::move(kinds)}, {"at", std::move(at)}};
}

Ordered tables(const std::vector<Record>& rows, const std::vector<Level>& levels) {
  Ordered judged_at = Ordered::array();
  Ordered shared;  // What stands in the first is left out of the others where it is the same.
  bool several_starts = false;
  for (const Level& level : levels) {
    const Table table = level.own ? make_table(rows) : make_table(rows, level.tolerance);
    several_starts = table.several_starts;
    Ordered values = by_quantity(table);
    if (shared.is_null()) {
      shared = values;
    } else {
      for (const auto& [key, column] : shared.items())
        if (values.contains(key) && values.at(key) == column) values.erase(key);
    }
    judged_at.push_back(
        {{"tolerance", level.tolerance}, {"own", level.own}, {"columns", std::move(values)}});
  }
  Ordered columns = Ordered::array();
  for (const ColumnHead& column : table_columns(several_starts))
    columns.push_back({{"key", column.key},
                       {"heading", column.heading},
                       {"meaning", column.meaning},
                       {"number", column.number},
                       {"only_if_any", column.only_if_any}});
  return {{"columns", std::move(columns)}, {"tolerances", std::move(judged_at)}};
}

std::size_t pairs_without_a_row(const ReportedRun& run) {
  std::set<std::tuple<Index, std::string>> instances;
  std::set<std::tuple<std::string, std::string>> variants;
  std::set<std::tuple<Index, std::string, std::string, std::string>> pairs;
  for (const Record& row : run.rows) {
    instances.insert({row.place, row.instance});
    variants.insert({row.solver, row.start});
    pairs.insert({row.place, row.instance, row.solver, row.start});
  }
  return instances.size() * variants.size() - pairs.size();
}

}  // namespace

std::vector<double> report_tolerances() {
  return {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
}

ReportedRun read_reported_run(const fs::path& directory) {
  const fs::path rows = directory / "rows.jsonl";
  ReportedRun run{.name = fs::absolute(directory / ".").parent_path().filename().string(),
                  .settings = {},
                  .environments = {},
                  .rows = read_run(directory)};
  if (run.rows.empty())
    throw UnreadableInput(fmt::format("{}: holds no finished row", rows.string()));
  if (fs::exists(directory / "run.json")) run.settings = read_run_header(directory).settings;
  if (fs::exists(directory / "env.json")) run.environments = read_environments(directory);
  return run;
}

std::vector<std::string> reading_notes(const ReportedRun& run) {
  std::vector<std::string> notes;
  int jobs = 1;
  std::set<std::string> environments;
  for (const Record& row : run.rows) {
    jobs = std::max(jobs, row.jobs);
    environments.insert(row.environment);
  }
  if (jobs > 1)
    notes.push_back(fmt::format("{} jobs ran at the same time: times are disturbed.", jobs));
  if (environments.size() > 1)
    notes.push_back(
        fmt::format("Rows come from {} environments ({}): compare times within one only.",
                    environments.size(), fmt::join(environments, ", ")));
  for (const json& each : run.environments) {
    if (each.value("dirty", json()) == true)
      notes.push_back(fmt::format(
          "Environment {} was built from a changed tree: the commit does not say all of the code.",
          each.value("id", "")));
    if (const std::string type = each.value("build_type", ""); type != "Release")
      notes.push_back(
          fmt::format("Environment {} is a build of type '{}', not Release: its times "
                      "say nothing of the solvers.",
                      each.value("id", ""), type));
  }
  if (!own_tolerance(run.rows))
    notes.push_back(
        "Rows were judged at several tolerances: everything here is judged anew at the tolerance "
        "that is shown.");
  if (!run.settings)
    notes.push_back(
        "The directory holds no run.json: settings and where the instances came from are unknown.");
  if (run.environments.empty())
    notes.push_back("The directory holds no env.json: on what it ran is unknown.");
  if (run.settings && run.settings->shard.count > 1)
    notes.push_back(fmt::format("This is part {} of a run that was shared out.",
                                to_string(run.settings->shard)));
  if (const std::size_t missing = pairs_without_a_row(run); missing > 0)
    notes.push_back(fmt::format(
        "{} pairs of an instance and a solver have no row: the run was not finished, or its parts "
        "differ. They are empty in the matrix and count nowhere.",
        missing));
  return notes;
}

Ordered report_data(const ReportedRun& run) {
  Gathered gathered = gather(run);
  const std::vector<Level> levels = levels_of(run.rows);
  Ordered verdicts = Ordered::array();
  for (const Verdict verdict : all_values<Verdict>())
    verdicts.push_back(
        {{"name", to_string(verdict)}, {"column", to_string(Judged{verdict}.standing())}});
  return {{"name", run.name},
          {"program", report_program},
          {"settings", run.settings ? Ordered(json(*run.settings)) : Ordered()},
          {"environments", run.environments},
          {"notes", reading_notes(run)},
          {"verdicts", verdicts},
          {"instances", std::move(gathered.instances)},
          {"variants", std::move(gathered.variants)},
          {"strings", std::move(gathered.strings)},
          {"rows", std::move(gathered.rows)},
          {"judgements", judgements(run.rows, levels)},
          {"table", tables(run.rows, levels)}};
}

}  // namespace lcp
