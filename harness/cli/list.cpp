#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "harness/cli/quantity.h"
#include "harness/cli/verbs.h"
#include "harness/runs/history.h"
#include "harness/studies/suites.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp::cli {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const OptionTable& table) {
  Json json = Json::array();
  for (const Option& option : table)
    json.push_back({{"name", option.name},
                    {"default", option.get()},
                    {"accepts", option.accepts},
                    {"doc", option.doc},
                    {"accuracy_ladder", option.accuracy_ladder}});
  return json;
}

void print(const OptionTable& table) {
  for (const Option& option : table) {
    fmt::print("    {:<24} {}; {}\n", option.name + "=" + option.get(), option.doc, option.accepts);
    if (!option.accuracy_ladder.empty())
      fmt::print("    {:<24} speed against accuracy: {}\n", "",
                 fmt::join(option.accuracy_ladder, ", "));
  }
}

void list_solvers(bool json) {
  Json all = Json::array();
  for (const Row& row : registry()) {
    const std::unique_ptr<Solver> solver = row.make();
    const bool pivoting = row.info.kind == RowInfo::Kind::pivoting;
    if (json) {
      all.push_back({{"name", row.info.name},
                     {"summary", row.info.summary},
                     {"source", row.info.source},
                     {"kind", pivoting ? "pivoting" : "iterative"},
                     {"version", row.info.version},
                     {"supports", row.info.supports},
                     {"library", row.info.outside_library},
                     {"library_constants", row.info.outside_constants},
                     {"options", to_json(solver->options())}});
      continue;
    }
    fmt::print("{}\n    {}\n    Source: {}\n    Supports: {}\n", row.info.name, row.info.summary,
               row.info.source, row.info.supports);
    if (row.info.peer())
      fmt::print("    Peer: {}\n    Its own tolerances: {}\n", row.info.outside_library,
                 row.info.outside_constants);
    print(solver->options());
    fmt::print("\n");
  }
  if (json) {
    Json absent = Json::array();
    for (const AbsentPeer& peer : absent_peers())
      absent.push_back(
          {{"name", peer.name}, {"library", peer.outside_library}, {"package", peer.package}});
    fmt::print("{}\n", Json{{"solvers", all}, {"absent", absent}}.dump(1));
    return;
  }
  for (const AbsentPeer& peer : absent_peers())
    fmt::print("{}\n    Peer, not built in: {}, Debian package {}\n\n", peer.name,
               peer.outside_library, peer.package);
}

void list_families(bool json) {
  Json all = Json::array();
  for (const FamilyRow& row : families()) {
    const std::unique_ptr<Family> family = row.make();
    if (json) {
      all.push_back({{"name", row.info.name},
                     {"summary", row.info.summary},
                     {"source", row.info.source},
                     {"default_count", row.info.default_count},
                     {"options", to_json(family->options())}});
      continue;
    }
    fmt::print("{}\n    {}\n    Source: {}\n    {} instances unless --count says otherwise\n",
               row.info.name, row.info.summary, row.info.source, row.info.default_count);
    print(family->options());
    fmt::print("\n");
  }
  if (json) fmt::print("{}\n", Json{{"families", all}}.dump(1));
}

void list_scenes(bool json) {
  Json all = Json::array();
  for (const SceneRow& row : scenes()) {
    const std::unique_ptr<Scene> scene = row.make();
    if (json) {
      all.push_back({{"name", row.info.name},
                     {"summary", row.info.summary},
                     {"source", row.info.source},
                     {"options", to_json(scene->options())}});
      continue;
    }
    fmt::print("{}\n    {}\n    Source: {}\n", row.info.name, row.info.summary, row.info.source);
    print(scene->options());
    fmt::print("\n");
  }
  if (json) fmt::print("{}\n", Json{{"scenes", all}}.dump(1));
}

/// The most recent of `runs` that measured the suite as it is, cold; null when there is none.
const PastRun* last_run_of(const Suite& suite, const std::vector<PastRun>& runs) {
  const Origin whole{suite.name, {}};
  for (const PastRun& run : runs)
    if (run.settings.origin == whole && run.settings.shard == Shard{} &&
        run.settings.start == to_string(StartKind::cold) && run.settings.instances == size(suite))
      return &run;
  return nullptr;
}

void list_suites(bool json) {
  Json all = Json::array();
  const std::vector<PastRun> runs = past_runs({"runs", "results"});
  for (const Suite& suite : suites()) {
    const PastRun* last = last_run_of(suite, runs);
    if (json) {
      all.push_back({{"name", suite.name},
                     {"summary", suite.summary},
                     {"instances", size(suite)},
                     {"solvers", suite.solvers},
                     {"last_seconds", last ? Json(*last->settings.seconds) : Json()},
                     {"last_run", last ? Json(last->directory.string()) : Json()}});
      continue;
    }
    fmt::print("{}\n    {}\n    {} instances, {} solvers, {} pairs\n", suite.name, suite.summary,
               size(suite), suite.solvers.size(),
               size(suite) * static_cast<Index>(suite.solvers.size()));
    if (last)
      fmt::print("    last measured: {} with {} solvers, {} job{} on {} ({})\n",
                 printed_duration(*last->settings.seconds), last->settings.solvers.size(),
                 last->jobs, last->jobs == 1 ? "" : "s", last->cpu, last->directory.string());
    else
      fmt::print("    not measured below runs/ or results/\n");
    for (const SuitePart& part : suite.parts)
      fmt::print("    {}{}\n", part.spelling(),
                 part.every > 1 ? fmt::format(", one in {}", part.every) : std::string());
    fmt::print("\n");
  }
  if (json) fmt::print("{}\n", Json{{"suites", all}}.dump(1));
}

struct ListArguments {
  std::string what;
  bool json = false;
};

int list(const ListArguments& arguments) {
  if (arguments.what == "solvers") list_solvers(arguments.json);
  if (arguments.what == "families") list_families(arguments.json);
  if (arguments.what == "scenes") list_scenes(arguments.json);
  if (arguments.what == "suites") list_suites(arguments.json);
  return done;
}

}  // namespace

Verb add_list(CLI::App& program) {
  CLI::App* page = program.add_subcommand("list", "Print what there is, with options and sources");
  auto arguments = std::make_shared<ListArguments>();
  page->add_option("WHAT", arguments->what, "solvers, families, scenes or suites")
      ->required()
      ->check(CLI::IsMember({"solvers", "families", "scenes", "suites"}));
  page->add_flag("--json", arguments->json, "As JSON");
  page->footer("Example:\n  lcpbench list solvers");
  return {page, [arguments] { return list(*arguments); }};
}

}  // namespace lcp::cli
