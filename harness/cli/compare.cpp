#include "harness/runs/compare.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "harness/cli/verbs.h"
#include "harness/runs/run_directory.h"

namespace lcp::cli {

namespace {

using Json = nlohmann::ordered_json;

struct CompareArguments {
  std::string before;
  std::string after;
  CompareOptions options;
  bool json = false;
};

Json to_json(const Comparison& comparison) {
  Json json = {{"compared", comparison.compared},
               {"gained", comparison.gained},
               {"only_old", comparison.only_old},
               {"only_new", comparison.only_new},
               {"regressions", Json::array()}};
  for (const Regression& each : comparison.regressions)
    json["regressions"].push_back(
        {{"kind", to_string(each.kind)},
         {"instance", each.pair.instance},
         {"solver", each.pair.solver},
         {"start", each.pair.start},
         {"ratio", each.kind == Regression::Kind::lost ? Json() : Json(each.ratio)},
         {"before", each.before},
         {"after", each.after}});
  return json;
}

/// The solver, and its start unless it is cold.
std::string spelled(const PairKey& pair) {
  return pair.start == "cold" ? pair.solver : fmt::format("{} [{}]", pair.solver, pair.start);
}

void print(const Comparison& comparison) {
  std::size_t instance = 0, solver = 0;
  for (const Regression& each : comparison.regressions) {
    instance = std::max(instance, each.pair.instance.size());
    solver = std::max(solver, spelled(each.pair).size());
  }
  for (const Regression& each : comparison.regressions) {
    const std::string ratio =
        each.kind == Regression::Kind::lost ? "" : fmt::format("x{:.2f}", each.ratio);
    fmt::print("{:<6} {:>8}  {:<{}}  {:<{}}  {} -> {}\n", to_string(each.kind), ratio,
               each.pair.instance, instance, spelled(each.pair), solver, each.before, each.after);
  }
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
    fmt::print("{}\n", to_json(comparison).dump(1));
  else
    print(comparison);
  note_environments(before, after);
  fmt::print(stderr,
             "{} pairs compared: {} regressions, {} newly solved; {} only in {}, {} only in {}\n",
             comparison.compared, comparison.regressions.size(), comparison.gained,
             comparison.only_old, arguments.before, comparison.only_new, arguments.after);
  return comparison.regressions.empty() ? done : regression;
}

}  // namespace

Verb add_compare(CLI::App& program) {
  CLI::App* page = program.add_subcommand(
      "compare", "List what got worse from one run to another; exit status 1 if anything did");
  auto arguments = std::make_shared<CompareArguments>();
  page->add_option("OLD", arguments->before, "Run directory")->required();
  page->add_option("NEW", arguments->after, "Run directory")->required();
  page->add_option("--pivot-growth", arguments->options.pivot_growth,
                   "Share by which the pivots of a solved pair may grow")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  page->add_option("--time-ratio", arguments->options.time_ratio,
                   "Ratio of median times that counts, where no sample of one run is among the "
                   "other's")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  page->add_flag("--json", arguments->json, "As JSON");
  page->footer(
      "Lists pairs that lost `solved`, then those with more pivots, then slower ones, worst "
      "first.\n"
      "Example:\n"
      "  lcpbench compare runs/before runs/after");
  return {page, [arguments] { return compare_runs(*arguments); }};
}

}  // namespace lcp::cli
