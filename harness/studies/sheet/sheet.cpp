#include "harness/studies/sheet/sheet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "harness/observed_quantile.h"
#include "harness/studies/sheet/entries.h"
#include "harness/studies/sheet/render.h"
#include "harness/studies/table/table.h"

namespace lcp {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::string> corpora_of(const std::vector<Record>& records) {
  std::vector<std::string> corpora;
  for (const Record& record : records)
    if (std::find(corpora.begin(), corpora.end(), record.corpus) == corpora.end())
      corpora.push_back(record.corpus);
  return corpora;
}

/// Those of `all` that fit one of `patterns`, or all of them.
std::vector<std::string> chosen(const std::vector<std::string>& all,
                                const std::vector<std::string>& patterns) {
  if (patterns.empty()) return all;
  std::set<std::string> fitting;
  for (const std::string& pattern : patterns) {
    bool any = false;
    for (const std::string& corpus : all)
      if (corpus == pattern || fnmatch(pattern.c_str(), corpus.c_str(), 0) == 0) {
        fitting.insert(corpus);
        any = true;
      }
    if (!any)
      throw std::invalid_argument(
          fmt::format("no corpus matches '{}', the run has: {}", pattern, fmt::join(all, ", ")));
  }
  std::vector<std::string> kept = all;
  std::erase_if(kept, [&](const std::string& corpus) { return fitting.count(corpus) == 0; });
  return kept;
}

/// Registry rows of which some pair brought an answer and none counted any work.
std::set<std::string> rows_without(Measure measure, const std::vector<Record>& records) {
  std::set<std::string> answered, worked;
  for (const Record& record : records) {
    if (record.accuracy && record.verdict != Verdict::unsupported) answered.insert(record.row);
    if (cost_of(record, measure) > 0) worked.insert(record.row);
  }
  std::set<std::string> without;
  std::set_difference(answered.begin(), answered.end(), worked.begin(), worked.end(),
                      std::inserter(without, without.end()));
  return without;
}

/// Registry rows whose settings differ in more than one option: there the spelling, which names what
/// is no default, reads better than a label that names every option in which they differ.
std::set<std::string> rows_of_many_options(const std::vector<Record>& records) {
  std::map<std::string, std::map<std::string, std::set<nlohmann::json>>> values;  // row, option
  for (const Record& record : records)
    for (const auto& [option, value] : record.options.items())
      values[record.row][option].insert(value);
  std::set<std::string> rows;
  for (const auto& [row, options] : values)
    if (std::count_if(options.begin(), options.end(),
                      [](const auto& option) { return option.second.size() > 1; }) > 1)
      rows.insert(row);
  return rows;
}

/// Numbers settings in order of appearance.
class Settings {
 public:
  Settings(const std::vector<Record>& records, std::vector<Setting>& all)
      : all_(all), labels_(labels(records)), many_options_(rows_of_many_options(records)) {
    std::set<std::string> starts;
    for (const Record& record : records) starts.insert(record.start);
    several_starts_ = starts.size() > 1;
  }

  std::size_t operator()(const Record& record) {
    const auto [place, is_new] = numbers_.try_emplace({record.solver, record.start}, all_.size());
    if (is_new) {
      const std::string start = several_starts_ ? fmt::format(" [{}]", record.start) : "";
      const bool spelled = many_options_.count(record.row) > 0;
      all_.push_back({record.solver, record.start, record.row + start,
                      (spelled ? record.solver : labels_.at(record.solver)) + start});
    }
    return place->second;
  }

 private:
  std::vector<Setting>& all_;
  std::map<std::string, std::string> labels_;
  std::set<std::string> many_options_;
  std::map<std::pair<std::string, std::string>, std::size_t> numbers_;
  bool several_starts_ = false;
};

/// exp(mean log(c + h)) - h; empty without values.
std::optional<double> shifted_mean(const std::vector<double>& costs, double shift) {
  if (costs.empty()) return std::nullopt;
  double sum = 0;
  for (const double cost : costs) sum += std::log(cost + shift);
  return std::exp(sum / static_cast<double>(costs.size())) - shift;
}

std::optional<Spread> spread_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return Spread{*observed_quantile(values, 0.25), *observed_quantile(values, 0.5),
                *observed_quantile(values, 0.75)};
}

Curve curve_of(Index counted, std::vector<double> reached) {
  std::erase_if(reached, [](double value) { return !std::isfinite(value); });
  std::sort(reached.begin(), reached.end());
  return {counted, std::move(reached)};
}

/// Costs of one setting that came within an accuracy.
Curve within(const std::vector<const Entry*>& entries, double accuracy) {
  Mass mass;
  std::vector<double> costs;
  for (const Entry* entry : entries) {
    const Judged at = judged(*entry->record, Acceptance{.tolerance = accuracy});
    mass.add(at);
    if (at.success()) costs.push_back(entry->cost);
  }
  return curve_of(mass.counted(), std::move(costs));
}

/// Residuals of one setting's answers that came within a budget of time.
Curve accuracy_in_time(const std::vector<const Entry*>& entries, Index counted, double budget_ms) {
  std::vector<double> residuals;
  for (const Entry* entry : entries) {
    const Record& record = *entry->record;
    const bool is_counted = entry->judged.counted();
    if (is_counted && record.claim == Claim::solved && record.accuracy && entry->cost <= budget_ms)
      residuals.push_back(record.accuracy->residual);
  }
  return curve_of(counted, std::move(residuals));
}

/// The least cost of each instance of a group; infinite where nobody solves it.
std::map<std::size_t, double> least_costs(const std::vector<Entry>& entries) {
  std::map<std::size_t, double> least;
  for (const Entry& entry : entries) {
    if (!entry.judged.counted()) continue;
    double& cost = least.try_emplace(entry.instance, infinity).first->second;
    if (entry.judged.success()) cost = std::min(cost, entry.cost);
  }
  return least;
}

SheetRow make_row(const std::vector<const Entry*>& entries,
                  const std::map<std::size_t, double>& least, const Group& group,
                  const SheetOptions& options) {
  const bool timed = options.measure == Measure::time;
  const double offset = timed ? 0 : options.count_offset;
  SheetRow row;
  row.setting = entries.front()->setting;
  std::vector<double> costs, residuals, ratios, least_of_same;
  for (const Entry* entry : entries) {
    row.mass.add(entry->judged);
    if (!entry->judged.success()) continue;
    const double best = least.at(entry->instance);
    costs.push_back(entry->cost);
    residuals.push_back(entry->record->accuracy.value().residual);
    ratios.push_back((entry->cost + offset) / (best + offset));
    least_of_same.push_back(best);
    row.best += entry->cost <= best;
  }
  row.cost = spread_of(costs);
  row.residual = spread_of(residuals);
  row.shifted_mean = shifted_mean(costs, group.shift);
  if (row.shifted_mean)
    row.slowdown =
        (*row.shifted_mean + offset) / (*shifted_mean(least_of_same, group.shift) + offset);
  row.profile = curve_of(row.mass.counted(), std::move(ratios));
  for (const double accuracy : options.accuracies) row.within.push_back(within(entries, accuracy));
  if (timed)
    for (const double budget : options.budgets_ms)
      row.accuracy_in_time.push_back(accuracy_in_time(entries, row.mass.counted(), budget));
  return row;
}

bool dominates(const SheetRow& a, const SheetRow& b) {
  const double share_a = a.mass.share_solved(), share_b = b.mass.share_solved();
  const bool as_good = a.cost->median <= b.cost->median &&
                       a.residual->median <= b.residual->median && share_a >= share_b;
  const bool better = a.cost->median < b.cost->median || a.residual->median < b.residual->median ||
                      share_a > share_b;
  return as_good && better;
}

void mark_front(std::vector<SheetRow>& rows) {
  for (SheetRow& row : rows)
    row.front = row.cost && std::none_of(rows.begin(), rows.end(), [&](const SheetRow& other) {
                  return other.cost && dominates(other, row);
                });
}

Group make_group(const std::string& name, const std::vector<Entry>& entries, std::size_t settings,
                 const SheetOptions& options) {
  Group group;
  group.name = name;
  std::set<std::size_t> instances;
  std::vector<std::vector<const Entry*>> of_setting(settings);
  for (const Entry& entry : entries) {
    instances.insert(entry.instance);
    of_setting[entry.setting].push_back(&entry);
  }
  group.instances = static_cast<Index>(instances.size());
  const std::map<std::size_t, double> least = least_costs(entries);
  std::vector<double> finite;
  for (const auto& [instance, cost] : least)
    if (std::isfinite(cost)) finite.push_back(cost);
  group.unsolved_by_all = static_cast<Index>(least.size() - finite.size());
  const double offset = options.measure == Measure::time ? 0 : options.count_offset;
  if (const auto median = observed_quantile(finite, 0.5)) group.shift = *median + offset;
  for (const std::vector<const Entry*>& each : of_setting)
    if (!each.empty()) group.rows.push_back(make_row(each, least, group, options));
  mark_front(group.rows);
  group.ladders = make_ladders(entries, group.rows);
  return group;
}

}  // namespace

Sheet make_sheet(const std::vector<Record>& records, const SheetOptions& options) {
  Sheet sheet;
  sheet.options = options;
  sheet.tolerance = options.tolerance ? *options.tolerance : common_tolerance(records);
  const std::vector<std::string> corpora = chosen(corpora_of(records), options.corpora);
  const std::set<std::string> without = options.measure == Measure::time
                                            ? std::set<std::string>{}
                                            : rows_without(options.measure, records);
  Settings number(records, sheet.settings);
  std::vector<Setting> left_out;
  Settings number_left_out(records, left_out);
  std::map<std::tuple<std::string, std::string, Index>, std::size_t> instances;
  std::vector<Entry> entries;
  for (const Record& record : records) {
    if (std::find(corpora.begin(), corpora.end(), record.corpus) == corpora.end()) continue;
    sheet.jobs = std::max(sheet.jobs, record.jobs);
    if (without.count(record.row) > 0) {
      number_left_out(record);
      continue;
    }
    const std::size_t instance =
        instances.try_emplace({record.corpus, record.instance, record.place}, instances.size())
            .first->second;
    entries.push_back({&record, number(record), instance,
                       judged(record, Acceptance{.tolerance = sheet.tolerance}),
                       cost_of(record, options.measure)});
  }
  for (const Setting& setting : left_out) sheet.without_work.push_back(setting.label);
  if (corpora.size() > 1)
    sheet.groups.push_back(make_group(all_corpora, entries, sheet.settings.size(), options));
  for (const std::string& corpus : corpora) {
    std::vector<Entry> of_corpus;
    for (const Entry& entry : entries)
      if (entry.record->corpus == corpus) of_corpus.push_back(entry);
    sheet.groups.push_back(make_group(corpus, of_corpus, sheet.settings.size(), options));
  }
  return sheet;
}

namespace {

/// Mean over the counted of 1 - log r / log `longest`: the area under the profile on a logarithmic axis
/// of ratios up to `longest`.
double area(const Curve& profile, double longest) {
  if (profile.counted == 0) return 0;
  double sum = 0;
  for (const double ratio : profile.reached)
    sum += longest > 1 ? 1 - std::log(ratio) / std::log(longest) : 1;
  return sum / static_cast<double>(profile.counted);
}

}  // namespace

std::vector<std::size_t> highlights(const Sheet& sheet, const Group& group, std::size_t most) {
  double longest = 1;
  for (const SheetRow& row : group.rows)
    if (!row.profile.reached.empty()) longest = std::max(longest, row.profile.reached.back());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < group.rows.size(); ++i)
    if (group.rows[i].mass.counted() > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return area(group.rows[a].profile, longest) > area(group.rows[b].profile, longest);
  });
  std::set<std::string> seen;
  const auto first_of_row = [&](std::size_t i) {
    return seen.insert(sheet.settings[group.rows[i].setting].row).second;
  };
  std::stable_partition(order.begin(), order.end(), first_of_row);
  order.resize(std::min(order.size(), most));
  return order;
}

std::vector<std::size_t> best_solving_front(const Group& group) {
  double share = 0;
  for (const SheetRow& row : group.rows)
    if (row.front) share = std::max(share, row.mass.share_solved());
  std::vector<std::size_t> most;
  for (std::size_t i = 0; i < group.rows.size(); ++i)
    if (group.rows[i].front && group.rows[i].mass.share_solved() == share) most.push_back(i);
  return most;
}

}  // namespace lcp
