#include "harness/studies/table/table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "harness/observed_quantile.h"
#include "solvers/options.h"

namespace lcp {

namespace {

class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  std::optional<double> value() const {
    if (count_ == 0) return std::nullopt;
    return sum_ / static_cast<double>(count_);
  }

 private:
  double sum_ = 0;
  Index count_ = 0;
};

/// Gathers the records of one row of the table.
class Gathering {
 public:
  void add(const Record& record, const Judged& judged) {
    ++row.instances;
    ++row.verdicts[judged.verdict];
    row.restarted += record.work.restarts > 0;
    if (record.contacts > 0) {
      contacts_.add(static_cast<double>(record.contacts));
      if (record.active_contacts) active_.add(static_cast<double>(*record.active_contacts));
    }
    row.unsupported += judged.verdict == Verdict::unsupported;
    row.not_run += judged.verdict == Verdict::not_run;
    row.trivial += judged.standing() == Standing::trivial;
    if (judged.counted()) add_counted(record, judged);
  }

  /// Counts what the start gave or took; `cold` is the same solver's cold row of the instance.
  void add_against(const Record& record, const Judged& judged, const Record& cold,
                   const Judged& cold_judged) {
    const auto counts = [](Verdict verdict) {
      return verdict != Verdict::unsupported && verdict != Verdict::not_run;
    };
    if (!row.gained) row.gained = row.lost = 0;
    if (!counts(judged.verdict) || !counts(cold_judged.verdict)) return;
    const bool solved = judged.verdict == Verdict::solved;
    const bool solved_cold = cold_judged.verdict == Verdict::solved;
    *row.gained += solved && !solved_cold;
    *row.lost += !solved && solved_cold;
    const auto time = record.median_ns(), cold_time = cold.median_ns();
    if (solved && solved_cold && time && cold_time && *cold_time > 0)
      time_ratios_.push_back(static_cast<double>(*time) / static_cast<double>(*cold_time));
  }

  TableRow finish() {
    row.contacts = contacts_.value();
    row.active = active_.value();
    row.pivots = pivots_.value();
    row.nodes = nodes_.value();
    row.sweeps = sweeps_.value();
    row.time_ratio = observed_quantile(time_ratios_, 0.5);
    row.time_median_ms = observed_quantile(times_ms_, 0.5);
    row.residual_median = observed_quantile(residuals_, 0.5);
    row.residual_max = observed_quantile(residuals_, 1.0);
    return row;
  }

  TableRow row;

 private:
  void add_counted(const Record& record, const Judged& judged) {
    if (judged.success()) {
      ++row.success;
      if (const auto time = record.median_ns())
        times_ms_.push_back(1e-6 * static_cast<double>(*time));
      residuals_.push_back(record.accuracy.value().residual);
    } else {
      ++row.failure;
      const Standing column = judged.standing();
      ++(column == Standing::no_solution ? row.no_solution
         : column == Standing::cycle     ? row.cycle
                                         : row.error);
    }
    if (judged.verdict == Verdict::wrong) ++row.wrong;
    if (judged.unclaimed) ++row.unclaimed;
    if (record.accuracy) {
      pivots_.add(static_cast<double>(record.work.pivots));
      nodes_.add(static_cast<double>(record.work.nodes));
      sweeps_.add(static_cast<double>(record.work.sweeps));
    }
  }

  Mean contacts_, active_, pivots_, nodes_, sweeps_;
  std::vector<double> times_ms_, residuals_, time_ratios_;
};

std::string option_text(const nlohmann::json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::map<std::string, std::string> labels(const std::vector<Record>& records) {
  std::map<std::string, std::map<std::string, std::set<std::string>>> values;  // row, option
  for (const Record& record : records)
    for (const auto& [option, value] : record.options.items())
      values[record.row][option].insert(option_text(value));

  std::map<std::string, std::string> labels;
  for (const Record& record : records) {
    if (labels.count(record.solver) > 0) continue;
    std::map<std::string, std::string> settings;
    for (const auto& [option, value] : record.options.items())
      if (values[record.row][option].size() > 1) settings[option] = option_text(value);
    const Spelling spelling = parse_spelling(record.solver);
    settings.insert(spelling.settings.begin(), spelling.settings.end());
    std::string label = spelling.name;
    for (const auto& [option, value] : settings)
      label += fmt::format("{}{}={}", label == spelling.name ? ':' : ',', option, value);
    labels.emplace(record.solver, label);
  }
  return labels;
}

namespace {

/// The same solver on the same instance from another start. Rows of one instance share no hash where
/// they start differently, so it is left out.
PairKey beside(const Record& record, const std::string& start) {
  return {record.instance, "", record.solver, start};
}

std::map<PairKey, const Record*> cold_rows(const std::vector<Record>& records) {
  std::map<PairKey, const Record*> rows;
  for (const Record& record : records)
    if (record.start == "cold") rows.try_emplace(beside(record, "cold"), &record);
  return rows;
}

/// Counts records, judged anew if `acceptance` says by what.
Table count(const std::vector<Record>& records, const std::optional<Acceptance>& acceptance) {
  Table table;
  if (acceptance) {
    table.tolerance = acceptance->tolerance;
    table.criterion = acceptance->criterion;
  } else {
    table.tolerance = common_tolerance(records);
  }
  std::vector<std::string> corpora;
  std::set<std::string> starts;
  for (const Record& record : records) starts.insert(record.start);
  table.several_starts = starts.size() > 1;
  const std::map<PairKey, const Record*> cold = cold_rows(records);
  std::map<std::string, std::vector<Gathering>> by_corpus;
  const std::map<std::string, std::string> names = labels(records);
  for (const Record& record : records) {
    table.jobs = std::max(table.jobs, record.jobs);
    if (by_corpus.count(record.corpus) == 0) corpora.push_back(record.corpus);
    std::vector<Gathering>& rows = by_corpus[record.corpus];
    auto place = std::find_if(rows.begin(), rows.end(), [&](const Gathering& gathering) {
      return gathering.row.solver == record.solver && gathering.row.start == record.start;
    });
    if (place == rows.end()) {
      place = rows.emplace(rows.end());
      place->row.corpus = record.corpus;
      place->row.solver = record.solver;
      place->row.start = record.start;
      place->row.label = names.at(record.solver);
      if (table.several_starts) place->row.label += fmt::format(" [{}]", record.start);
    }
    const Judged result = judged(record, acceptance);
    place->add(record, result);
    if (record.start == "cold") continue;
    if (const auto found = cold.find(beside(record, "cold")); found != cold.end())
      place->add_against(record, result, *found->second, judged(*found->second, acceptance));
  }
  table.start = fmt::format("{}", fmt::join(starts, ", "));
  for (const std::string& corpus : corpora)
    for (Gathering& gathering : by_corpus[corpus]) table.rows.push_back(gathering.finish());
  return table;
}

}  // namespace

double common_tolerance(const std::vector<Record>& records) {
  for (const Record& record : records)
    if (record.tolerance != records.front().tolerance)
      throw std::invalid_argument(
          fmt::format("rows were judged at {} and at {}: a tolerance is needed to compare them",
                      records.front().tolerance, record.tolerance));
  return records.empty() ? 0 : records.front().tolerance;
}

Table make_table(const std::vector<Record>& records, std::optional<double> tolerance) {
  if (!tolerance) return count(records, {});
  return count(records, Acceptance{Acceptance::Criterion::residual, *tolerance});
}

Table make_table(const std::vector<Record>& records, const Acceptance& acceptance) {
  return count(records, acceptance);
}

}  // namespace lcp
