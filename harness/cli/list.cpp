#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "harness/cli/page.h"
#include "harness/cli/quantity.h"
#include "harness/runs/history.h"
#include "harness/studies/suites.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp::cli {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(OptionTable table) {
  Json json = Json::array();
  for (const Option& option : table)
    json.push_back({{"name", option.name},
                    {"default", option.get()},
                    {"accepts", option.accepts},
                    {"doc", option.doc},
                    {"accuracy_ladder", option.accuracy_ladder}});
  return json;
}

/// What JSON says of a row, for a reader.
void print_row(const Json& row) {
  fmt::print("{}\n    {}\n", row["name"].get<std::string>(), row["summary"].get<std::string>());
  for (const auto& [key, value] : row.items()) {
    if (key == "name" || key == "summary" || key == "options" || value == "") continue;
    std::string label = key;
    std::replace(label.begin(), label.end(), '_', ' ');
    fmt::print("    {}: {}\n", label, value.is_string() ? value.get<std::string>() : value.dump());
  }
  for (const Json& option : row["options"]) {
    const auto of = [&option](const char* key) { return option[key].get<std::string>(); };
    fmt::print("    {:<24} {}; {}\n", of("name") + "=" + of("default"), of("doc"), of("accepts"));
    if (!option["accuracy_ladder"].empty())
      fmt::print("    {:<24} speed against accuracy: {}\n", "",
                 fmt::join(option["accuracy_ladder"].get<std::vector<std::string>>(), ", "));
  }
  fmt::print("\n");
}

/// The rows of a registry, printed unless they are for JSON; `more` says what is particular about one.
template <class Rows, class More>
Json list_rows(const Rows& rows, bool json, const More& more) {
  Json all = Json::array();
  for (const auto& row : rows) {
    const auto made = row.make();
    Json object = {
        {"name", row.info.name}, {"summary", row.info.summary}, {"source", row.info.source}};
    object.update(more(row.info));
    object["options"] = to_json(made->options());
    if (!json) print_row(object);
    all.push_back(std::move(object));
  }
  return all;
}

Json list_solvers(bool json) {
  Json absent = Json::array();
  const Json all = list_rows(registry(), json, [](const RowInfo& row) -> Json {
    return {{"kind", row.kind == RowInfo::Kind::pivoting ? "pivoting" : "iterative"},
            {"version", row.version},
            {"supports", row.supports},
            {"library", row.outside_library},
            {"library_constants", row.outside_constants}};
  });
  for (const AbsentPeer& peer : absent_peers()) {
    absent.push_back(
        {{"name", peer.name}, {"library", peer.outside_library}, {"package", peer.package}});
    if (!json)
      fmt::print("{}\n    Peer, not built in: {}, Debian package {}\n\n", peer.name,
                 peer.outside_library, peer.package);
  }
  return {{"solvers", all}, {"absent", absent}};
}

Json list_families(bool json) {
  return {{"families", list_rows(families(), json, [](const FamilyInfo& info) -> Json {
             return {{"default_count", info.default_count}};
           })}};
}

Json list_scenes(bool json) {
  return {{"scenes", list_rows(scenes(), json, [](const SceneInfo&) { return Json::object(); })}};
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

Json list_suites(bool json) {
  Json all = Json::array();
  const std::vector<PastRun> runs = past_runs({"runs", "results"});
  for (const Suite& suite : suites()) {
    const PastRun* last = last_run_of(suite, runs);
    all.push_back({{"name", suite.name},
                   {"summary", suite.summary},
                   {"instances", size(suite)},
                   {"solvers", suite.solvers},
                   {"last_seconds", last ? Json(*last->settings.seconds) : Json()},
                   {"last_run", last ? Json(last->directory.string()) : Json()}});
    if (json) continue;
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
  return {{"suites", all}};
}

struct ListArguments {
  std::string what;
  bool json = false;
};

const std::map<std::string, Json (*)(bool)> lists = {{"solvers", list_solvers},
                                                     {"families", list_families},
                                                     {"scenes", list_scenes},
                                                     {"suites", list_suites}};

int list(const ListArguments& arguments) {
  const Json all = lists.at(arguments.what)(arguments.json);
  if (arguments.json) fmt::print("{}\n", all.dump(1));
  return done;
}

void list_options(CLI::App& page, ListArguments& arguments) {
  add(page, "WHAT", arguments.what, "solvers, families, scenes or suites",
      CLI::IsMember({"solvers", "families", "scenes", "suites"}))
      ->required();
  page.add_flag("--json", arguments.json, "As JSON");
}

}  // namespace

Verb add_list(CLI::App& program) {
  return make_verb<ListArguments>(program, "list", "Print what there is, with options and sources",
                                  list_options, list, "Example:\n  lcpbench list solvers");
}

}  // namespace lcp::cli
