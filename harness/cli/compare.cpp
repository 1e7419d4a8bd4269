#include "harness/runs/compare.h"

#include <fmt/format.h>

#include <cstdio>

#include "harness/cli/page.h"
#include "harness/present/columns.h"
#include "harness/runs/run_directory.h"

namespace lcp::cli {

namespace {

struct CompareArguments {
  std::string before;
  std::string after;
  CompareOptions options;
  bool json = false;
};

Cell ratio_of(const Regression& r) {
  return r.kind == Regression::Kind::lost ? Cell() : Cell(r.ratio);
}

const std::vector<Column<Regression>>& regression_columns() {
  static const std::vector<Column<Regression>> columns = {
      {{"kind", "worse"}, [](const Regression& r) { return to_string(r.kind); }},
      {{.heading = "ratio", .number = "x{:.2f}"}, [](const Regression& r) { return ratio_of(r); }},
      {{"instance", "instance"}, [](const Regression& r) { return r.pair.instance; }},
      {{"solver"}, [](const Regression& r) { return r.pair.solver; }},
      {{"start"}, [](const Regression& r) { return r.pair.start; }},
      {{"", "solver"},
       [](const Regression& r) {
         return r.pair.start == "cold" ? r.pair.solver
                                       : fmt::format("{} [{}]", r.pair.solver, r.pair.start);
       }},
      {{"ratio"}, [](const Regression& r) { return ratio_of(r); }},
      {{"before", "before"}, &Regression::before},
      {{"after", "after"}, &Regression::after}};
  return columns;
}

Cell json_of(const Comparison& comparison) {
  Cell json = {{"compared", comparison.compared},
               {"gained", comparison.gained},
               {"only_old", comparison.only_old},
               {"only_new", comparison.only_new},
               {"regressions", Cell::array()}};
  for (const Regression& each : comparison.regressions)
    json["regressions"].push_back(json_object(regression_columns(), each));
  return json;
}

/// Says on stderr what stands against comparing the times of two runs.
void note_environments(const StoredRun& before, const StoredRun& after) {
  for (const char* field : {"cpu", "cores", "jobs", "compiler", "flags", "build_type"}) {
    const nlohmann::json& a = before.environments.front();
    const nlohmann::json& b = after.environments.front();
    if (a.contains(field) && b.contains(field) && a.at(field) != b.at(field))
      fmt::print(stderr, "times were taken in different conditions: {} {}, {}\n", field,
                 a.at(field).dump(), b.at(field).dump());
  }
}

int compare_runs(const CompareArguments& arguments) {
  const StoredRun before = read_stored_run(arguments.before);
  const StoredRun after = read_stored_run(arguments.after);
  const Comparison comparison = compare(before.rows, after.rows, arguments.options);
  if (arguments.json)
    fmt::print("{}\n", json_of(comparison).dump(1));
  else if (!comparison.regressions.empty())
    fmt::print("{}", text_table(cells_of(regression_columns(), comparison.regressions)));
  note_environments(before, after);
  fmt::print(stderr,
             "{} pairs compared: {} regressions, {} newly solved; {} only in {}, {} only in {}\n",
             comparison.compared, comparison.regressions.size(), comparison.gained,
             comparison.only_old, arguments.before, comparison.only_new, arguments.after);
  return comparison.regressions.empty() ? done : regression;
}

void compare_options(CLI::App& page, CompareArguments& arguments) {
  add(page, "OLD", arguments.before, "Run directory")->required();
  add(page, "NEW", arguments.after, "Run directory")->required();
  add_with_default(page, "--pivot-growth", arguments.options.pivot_growth,
                   "Share by which the pivots of a solved pair may grow", CLI::NonNegativeNumber);
  add_with_default(
      page, "--time-ratio", arguments.options.time_ratio,
      "Ratio of median times that counts, where no sample of one run is among the other's",
      CLI::PositiveNumber);
  page.add_flag("--json", arguments.json, "As JSON");
}

}  // namespace

Verb add_compare(CLI::App& program) {
  return make_verb<CompareArguments>(
      program, "compare",
      "List what got worse from one run to another; exit status 1 if anything did", compare_options,
      compare_runs,
      "Lists pairs that lost `solved`, then those with more pivots, then slower ones, worst "
      "first.\n"
      "Example:\n"
      "  lcpbench compare runs/before runs/after");
}

}  // namespace lcp::cli
