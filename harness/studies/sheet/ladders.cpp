#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "harness/observed_quantile.h"
#include "harness/studies/sheet/entries.h"
#include "solvers/options.h"

namespace lcp {

namespace {

/// Options arrive as they are spelled.
std::optional<double> numeric(const nlohmann::json& value) {
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) return std::nullopt;
  const std::string text = value.get<std::string>();
  char* end = nullptr;
  const double read = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(read)) return std::nullopt;
  return read;
}

std::string spelled(const nlohmann::json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Null where the row knows no such option.
nlohmann::json option_of(const Record& record, const std::string& name) {
  return record.options.contains(name) ? record.options.at(name) : nlohmann::json();
}

/// The settings of one registry row from one start: place in the group's rows, and options.
struct RowSettings {
  struct Member {
    std::size_t row;
    const Record* record;
  };
  std::vector<Member> members;

  /// The value that most members have, the first of them on a tie.
  nlohmann::json commonest(const std::string& option) const {
    std::map<nlohmann::json, Index> counts;
    for (const Member& member : members) ++counts[option_of(*member.record, option)];
    nlohmann::json best = option_of(*members.front().record, option);
    for (const auto& [value, count] : counts)
      if (count > counts[best]) best = value;
    return best;
  }
};

std::map<std::pair<std::string, std::string>, RowSettings> families(
    const std::vector<Entry>& entries, const std::vector<SheetRow>& rows) {
  std::map<std::size_t, const Record*> record_of;
  for (const Entry& entry : entries) record_of.try_emplace(entry.setting, entry.record);
  std::map<std::pair<std::string, std::string>, RowSettings> all;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const Record* record = record_of.at(rows[row].setting);
    all[{record->row, record->start}].members.push_back({row, record});
  }
  return all;
}

/// Cost and residual of one setting on what it solved.
using Solved = std::map<std::size_t, const Entry*>;

void compare_with(const Solved& base, const Solved& other, Step& step) {
  std::vector<double> costs, residuals;
  const auto floored = [](const Entry* entry) {
    return std::max(entry->record->accuracy.value().residual, residual_floor);
  };
  for (const auto& [instance, entry] : other) {
    const auto found = base.find(instance);
    if (found == base.end()) continue;
    ++step.common;
    residuals.push_back(floored(entry) / floored(found->second));
    if (found->second->cost > 0) costs.push_back(entry->cost / found->second->cost);
  }
  step.cost_ratio = observed_quantile(costs, 0.5);
  step.residual_ratio = observed_quantile(residuals, 0.5);
}

/// What the settings of a ladder have in common, spelled.
std::string common_name(const Record& record, const std::string& option) {
  const Spelling spelling = parse_spelling(record.solver);
  std::string name = spelling.name;
  char separator = ':';
  for (const auto& [key, value] : spelling.settings) {
    if (key == option) continue;
    name += fmt::format("{}{}={}", separator, key, value);
    separator = ',';
  }
  return record.start == "cold" ? name : fmt::format("{} [{}]", name, record.start);
}

}  // namespace

std::vector<Ladder> make_ladders(const std::vector<Entry>& entries,
                                 const std::vector<SheetRow>& rows) {
  std::map<std::size_t, Solved> solved;  // by setting
  for (const Entry& entry : entries)
    if (entry.judged.success()) solved[entry.setting][entry.instance] = &entry;

  std::vector<Ladder> ladders;
  for (const auto& [name, family] : families(entries, rows)) {
    for (const auto& [option, unused] : family.members.front().record->options.items()) {
      std::map<nlohmann::json, std::vector<RowSettings::Member>> clusters;  // by all other options
      for (const RowSettings::Member& member : family.members) {
        if (!numeric(option_of(*member.record, option))) continue;
        nlohmann::json others = member.record->options;
        others.erase(option);
        clusters[others].push_back(member);
      }
      for (auto& [others, members] : clusters) {
        if (members.size() < 2) continue;
        const auto value = [&](const RowSettings::Member& member) {
          return *numeric(member.record->options.at(option));
        };
        std::stable_sort(members.begin(), members.end(),
                         [&](const RowSettings::Member& a, const RowSettings::Member& b) {
                           return value(a) > value(b);
                         });
        const nlohmann::json usual = family.commonest(option);
        const auto base = std::find_if(members.begin(), members.end(), [&](const auto& member) {
          return member.record->options.at(option) == usual;
        });
        Ladder ladder;
        ladder.option = option;
        ladder.base = base == members.end() ? 0 : static_cast<std::size_t>(base - members.begin());
        const RowSettings::Member& reference = members[ladder.base];
        ladder.name = common_name(*reference.record, option);
        for (const RowSettings::Member& member : members) {
          Step step;
          step.value = spelled(member.record->options.at(option));
          step.row = member.row;
          compare_with(solved[rows[reference.row].setting], solved[rows[member.row].setting], step);
          ladder.steps.push_back(step);
        }
        ladders.push_back(std::move(ladder));
      }
    }
  }
  return ladders;
}

}  // namespace lcp
