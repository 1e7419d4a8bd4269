#include <fmt/format.h>
#include <fmt/ranges.h>

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

void print(const OptionTable& table) {
  for (const Option& option : table) {
    fmt::print("    {:<24} {}; {}\n", option.name + "=" + option.get(), option.doc, option.accepts);
    if (!option.accuracy_ladder.empty())
      fmt::print("    {:<24} speed against accuracy: {}\n", "",
                 fmt::join(option.accuracy_ladder, ", "));
  }
}

/// What is said of a row besides its name, summary, source and options.
struct RowRemarks {
  Json json = Json::object();
  std::string text = {};  ///< Lines.
};

/// Prints the rows of a registry, or gathers them; `remarks` says what is particular about one.
template <class Rows, class Remarks>
Json list_rows(const Rows& rows, bool json, const Remarks& remarks) {
  Json all = Json::array();
  for (const auto& row : rows) {
    const auto made = row.make();
    const RowRemarks more = remarks(row.info);
    Json& object = all.emplace_back(
        Json{{"name", row.info.name}, {"summary", row.info.summary}, {"source", row.info.source}});
    object.update(more.json);
    object["options"] = to_json(made->options());
    if (json) continue;
    fmt::print("{}\n    {}\n    Source: {}\n{}", row.info.name, row.info.summary, row.info.source,
               more.text);
    print(made->options());
    fmt::print("\n");
  }
  return all;
}

RowRemarks remarks_on(const RowInfo& row) {
  RowRemarks more{{{"kind", row.kind == RowInfo::Kind::pivoting ? "pivoting" : "iterative"},
                   {"version", row.version},
                   {"supports", row.supports},
                   {"library", row.outside_library},
                   {"library_constants", row.outside_constants}},
                  fmt::format("    Supports: {}\n", row.supports)};
  if (row.peer())
    more.text += fmt::format("    Peer: {}\n    Its own tolerances: {}\n", row.outside_library,
                             row.outside_constants);
  return more;
}

Json list_solvers(bool json) {
  Json absent = Json::array();
  const Json all = list_rows(registry(), json, remarks_on);
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
  return {{"families", list_rows(families(), json, [](const FamilyInfo& info) {
             return RowRemarks{{{"default_count", info.default_count}},
                               fmt::format("    {} instances unless --count says otherwise\n",
                                           info.default_count)};
           })}};
}

Json list_scenes(bool json) {
  return {{"scenes", list_rows(scenes(), json, [](const SceneInfo&) { return RowRemarks{}; })}};
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
