#include "harness/runs/settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <stdexcept>
#include <tuple>

#include "harness/fields.h"

namespace lcp {

namespace {

using nlohmann::json;

/// Reads all of `text` as a count of at least 1; 0 when it is not one.
Index count_in(std::string_view text) {
  Index number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number >= 1 ? number : 0;
}

std::string printed(const Origin& origin) {
  std::string text = origin.suite.empty()
                         ? fmt::format("--corpus {}", fmt::join(origin.corpora, " "))
                         : fmt::format("--suite {}", origin.suite);
  if (origin.every > 1) text += fmt::format(" --every {}", origin.every);
  if (origin.limit > 0) text += fmt::format(" --limit {}", origin.limit);
  return text;
}

/// But for the schema and the shard.
constexpr auto run_settings_fields = [](auto& settings, const auto& field) {
  field("suite", settings.origin.suite);
  field("corpora", settings.origin.corpora);
  field("every", settings.origin.every);
  field("limit", settings.origin.limit);
  field("instances", settings.instances);
  field("start", settings.start);
  field("tolerance", settings.tolerance);
  field("timeout_s", settings.timeout_s);
  field("memory_bytes", settings.memory_bytes);
  field("max_contacts", settings.max_contacts);
  field("solvers", settings.solvers);
  field("seconds", settings.seconds);
};

}  // namespace

RunSettings settings_of(const RunPlan& plan, const Origin& origin) {
  RunSettings settings;
  settings.origin = origin;
  settings.instances = static_cast<Index>(plan.instances.size());
  settings.shard = plan.shard;
  settings.start.clear();
  for (const StartKind start : plan.starts)
    settings.start += (settings.start.empty() ? "" : ", ") + to_string(start);
  settings.tolerance = plan.tolerance;
  settings.timeout_s = std::chrono::duration<double>(plan.timeout).count();
  settings.memory_bytes = plan.memory_bytes;
  settings.max_contacts = plan.max_contacts;
  for (const NamedSolver& solver : plan.solvers) settings.solvers.push_back(solver.spelling);
  return settings;
}

std::vector<std::string> conflicts(const RunSettings& a, const RunSettings& b) {
  std::vector<std::string> found;
  const auto compare = [&found](const char* what, const auto& x, const auto& y) {
    if (x != y) found.push_back(fmt::format("{} {}, {}", what, x, y));
  };
  if (!(a.origin == b.origin))
    found.push_back(fmt::format("instances {}, {}", printed(a.origin), printed(b.origin)));
  compare("start", a.start, b.start);
  compare("tolerance", a.tolerance, b.tolerance);
  compare("timeout in s", a.timeout_s, b.timeout_s);
  compare("memory in bytes", a.memory_bytes, b.memory_bytes);
  compare("max-contacts", a.max_contacts, b.max_contacts);
  return found;
}

void append_missing(std::vector<std::string>& all, const std::vector<std::string>& more) {
  for (const std::string& each : more)
    if (std::find(all.begin(), all.end(), each) == all.end()) all.push_back(each);
}

void sort_rows(std::vector<Record>& rows, const std::vector<std::string>& solvers) {
  std::map<std::string, std::size_t> turn;
  for (const std::string& solver : solvers) turn.try_emplace(solver, turn.size());
  std::map<std::string, std::size_t> start_turn;
  for (const StartKind start : all_values<StartKind>())
    start_turn.try_emplace(to_string(start), start_turn.size());
  const auto turn_of = [](const auto& turns, const std::string& name) {
    const auto found = turns.find(name);
    return found == turns.end() ? turns.size() : found->second;
  };
  const auto position = [&](const Record& row) {
    return std::tuple(row.place, turn_of(turn, row.solver), turn_of(start_turn, row.start));
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const Record& a, const Record& b) { return position(a) < position(b); });
}

std::string to_string(const Shard& shard) {
  return fmt::format("{}/{}", shard.index + 1, shard.count);
}

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const Index place = count_in(std::string_view(text).substr(0, slash));
    const Index count = count_in(std::string_view(text).substr(slash + 1));
    if (place >= 1 && place <= count) return {place - 1, count};
  }
  throw std::invalid_argument(
      fmt::format("--shard {}: expected I/N with 1 <= I <= N, for example 2/4", text));
}

void to_json(json& object, const RunSettings& settings) {
  object = fields_to_json(settings, run_settings_fields);
  object["schema"] = RunSettings::schema;
  object["shard"] = to_string(settings.shard);
}

void from_json(const json& object, RunSettings& settings) {
  try {
    if (const int found = object.at("schema"); found != RunSettings::schema)
      throw std::invalid_argument(
          fmt::format("field 'schema': {}, expected {}", found, RunSettings::schema));
    settings.shard = parse_shard(object.at("shard").get<std::string>());
  } catch (const json::exception& error) {
    throw std::invalid_argument(error.what());
  }
  fields_from_json(object, settings, run_settings_fields, "settings of a run");
}

}  // namespace lcp
