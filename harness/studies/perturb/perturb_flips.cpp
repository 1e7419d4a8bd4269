#include "harness/studies/perturb/perturb_flips.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "harness/observed_quantile.h"
#include "harness/studies/suites.h"
#include "harness/studies/table/table.h"
#include "problems/contact/friction_lcp.h"

namespace lcp {

namespace {

/// A disturbed run with its answer in the original problem's terms.
struct Run {
  const Record* record;
  VectorXd z, w;    ///< Empty unless solved.
  VectorXd motion;  ///< Contact velocities v+; w where there are no contacts.

  bool solved() const { return record->verdict == Verdict::solved; }
};

Run run_of(const Record& record, const Problem& original,
           const std::function<VectorXd(const VectorXd&)>& back) {
  Run run{&record, {}, {}, {}};
  if (run.solved() && record.z) {
    run.z = back ? back(*record.z) : *record.z;
    run.w = original.M * run.z + original.q;
    run.motion = original.friction ? post_velocities(*original.friction,
                                                     contact_forces(*original.friction, run.z))
                                   : run.w;
  }
  return run;
}

/// What velocities (w, without contacts) are compared in.
VectorXd motion_scales(const Problem& problem) {
  if (!problem.friction || problem.friction->contacts() == 0) return problem.s_w;
  const FrictionBlocks& blocks = *problem.friction;
  VectorXd scales(3 * blocks.contacts());
  for (Index i = 0; i < blocks.contacts(); ++i)
    scales.segment<3>(3 * i).setConstant(problem.s_w(blocks.normal_row[i]));
  return scales;
}

bool same_vector(const VectorXd& one, const VectorXd& two, const VectorXd& scales, double same) {
  return ((one - two).cwiseAbs().array() <= same * scales.array()).all();
}

/// Numbers of FlipRow that come of many instances.
struct Samples {
  std::vector<double> pivots, ratios;
};

using Key = std::tuple<std::string, std::string, std::string, std::string>;

/// Rows in the making, in order of first appearance.
class Tally {
 public:
  FlipRow& row(const Key& key) {
    const auto [place, is_new] = places_.try_emplace(key, rows_.size());
    if (is_new) {
      FlipRow& row = rows_.emplace_back();
      std::tie(row.corpus, row.solver, row.start, row.kind) = key;
      samples_.emplace_back();
    }
    return rows_[place->second];
  }
  Samples& samples(const Key& key) {
    row(key);
    return samples_[places_.at(key)];
  }
  std::vector<FlipRow> finished() {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      rows_[k].pivots = observed_quantile(samples_[k].pivots, 0.5);
      rows_[k].pivot_ratio = observed_quantile(samples_[k].ratios, 0.5);
      rows_[k].pivot_ratio_max = observed_quantile(samples_[k].ratios, 1.0);
    }
    return rows_;
  }

 private:
  std::map<Key, std::size_t> places_;
  std::vector<FlipRow> rows_;
  std::vector<Samples> samples_;
};

void count_verdicts(FlipRow& row, const Run& baseline, const std::vector<Run>& trials) {
  Index flips = 0;
  for (const Run& trial : trials) {
    ++row.trials;
    row.solved += trial.solved();
    row.baseline_solved += baseline.solved();
    row.lost += baseline.solved() && !trial.solved();
    row.gained += !baseline.solved() && trial.solved();
    flips += baseline.solved() != trial.solved();
    row.other_changes +=
        !baseline.solved() && !trial.solved() && baseline.record->verdict != trial.record->verdict;
  }
  row.instances_flipped += flips > 0;
}

void count_answers(FlipRow& row, Samples& samples, const Problem& original,
                   const std::vector<const Run*>& solved, double same) {
  for (const Run* run : solved)
    samples.pivots.push_back(static_cast<double>(run->record->work.pivots));
  if (solved.size() < 2) return;
  ++row.compared;
  std::vector<const Run*> distinct;
  for (const Run* run : solved) {
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const Run* other) {
      return same_vector(run->z, other->z, original.s_z, same);
    });
    if (!known) distinct.push_back(run);
    if (!same_vector(run->z, solved.front()->z, original.s_z, same)) {
      ++row.other_z;
      row.other_z_same_w += same_vector(run->w, solved.front()->w, original.s_w, same);
      row.other_z_same_motion +=
          same_vector(run->motion, solved.front()->motion, motion_scales(original), same);
    }
  }
  row.several += distinct.size() > 1;
  row.most_distinct = std::max(row.most_distinct, static_cast<Index>(distinct.size()));

  const auto by_pivots = [](const Run* a, const Run* b) {
    return a->record->work.pivots < b->record->work.pivots;
  };
  const auto [least, most] = std::minmax_element(solved.begin(), solved.end(), by_pivots);
  const Index fewest = (*least)->record->work.pivots;
  if (fewest > 0)
    samples.ratios.push_back(static_cast<double>((*most)->record->work.pivots) /
                             static_cast<double>(fewest));
}

/// One instance met by one solver: what is known of it undisturbed and under one kind.
void count_instance(Tally& tally, const Key& key, const Problem& original, const Run& baseline,
                    const std::vector<Run>& runs, double same) {
  FlipRow& row = tally.row(key);
  const Verdict verdict = baseline.record->verdict;
  if (baseline.record->trivial) {
    ++row.trivial;
    return;
  }
  if (verdict == Verdict::not_run) {
    ++row.not_run;
    return;
  }
  const bool is_baseline = row.kind == "baseline";
  std::vector<Run> trials;
  for (const Run& run : is_baseline ? std::vector<Run>{baseline} : runs) {
    if (verdict == Verdict::unsupported && run.record->verdict == Verdict::unsupported)
      ++row.unsupported;
    else
      trials.push_back(run);
  }
  if (trials.empty()) return;
  ++row.instances;
  count_verdicts(row, baseline, trials);
  std::vector<const Run*> solved;
  if (baseline.solved() && baseline.z.size() > 0) solved.push_back(&baseline);
  for (const Run& trial : trials)
    if (!is_baseline && trial.solved() && trial.z.size() > 0) solved.push_back(&trial);
  count_answers(row, tally.samples(key), original, solved, same);
}

/// Counts one more instance that a kind does not apply to.
void add_reason(std::vector<NotApplicable>& all, const NotApplicable& one) {
  for (NotApplicable& known : all) {
    if (known.corpus != one.corpus || known.kind != one.kind || known.reason != one.reason)
      continue;
    ++known.instances;
    return;
  }
  all.push_back(one);
}

/// Records by what makes them the same piece of work.
class Rows {
 public:
  explicit Rows(const std::vector<Record>& records) {
    for (const Record& record : records) {
      by_key_[key_of(record)] = &record;
      const std::pair entrant{record.solver, record.start};
      if (std::find(entrants_.begin(), entrants_.end(), entrant) == entrants_.end())
        entrants_.push_back(entrant);
    }
  }
  const Record* find(const Instance& instance, const std::pair<std::string, std::string>& entrant,
                     const std::string& hash) const {
    const auto found = by_key_.find({instance.name, hash, entrant.first, entrant.second});
    return found == by_key_.end() ? nullptr : found->second;
  }
  const std::vector<std::pair<std::string, std::string>>& entrants() const { return entrants_; }

 private:
  std::map<PairKey, const Record*> by_key_;
  std::vector<std::pair<std::string, std::string>> entrants_;  ///< Solver, start.
};

std::string hash_from(const Instance& instance, const std::string& start) {
  return start == to_string(StartKind::previous) ? hash_with_previous(instance) : instance.sha256;
}

}  // namespace

Flips count_flips(const std::vector<Instance>& instances, const std::vector<Record>& records,
                  const PerturbOptions& options, double same) {
  Flips flips{options, same, records.empty() ? 0 : records.front().tolerance, {}, {}};
  std::vector<std::string> corpora;
  for (const Instance& instance : instances) {
    const std::string corpus = corpus_of(instance.name);
    if (std::find(corpora.begin(), corpora.end(), corpus) == corpora.end())
      corpora.push_back(corpus);
  }
  const Rows rows(records);
  // Every row exists, in order, before anything is counted.
  Tally tally;
  std::vector<std::string> kinds = {"baseline"};
  for (const DisturbanceKind kind : options.kinds) kinds.push_back(to_string(kind));
  std::vector<std::string> blocks = corpora;
  if (corpora.size() > 1) blocks.push_back("all corpora");
  for (const std::string& block : blocks)
    for (const auto& [solver, start] : rows.entrants())
      for (const std::string& kind : kinds) tally.row({block, solver, start, kind});

  for (const Instance& instance : instances) {
    const std::string corpus = corpus_of(instance.name);
    std::vector<std::pair<std::string, Disturbed>> disturbed;  // kind, what it makes
    for (const Disturbance& each : disturbances_of(instance, options))
      disturbed.emplace_back(to_string(each.kind), disturb(instance, each, options));
    for (const DisturbanceKind kind : options.kinds)
      if (const std::string reason = reason_against(kind, instance.problem); !reason.empty())
        add_reason(flips.not_applicable, {corpus, to_string(kind), reason, 1});
    for (const auto& entrant : rows.entrants()) {
      const Record* undisturbed = rows.find(instance, entrant, hash_from(instance, entrant.second));
      if (!undisturbed) continue;
      const Run baseline = run_of(*undisturbed, instance.problem, {});
      for (const std::string& kind : kinds) {
        std::vector<Run> runs;
        for (const auto& [of_kind, version] : disturbed) {
          if (of_kind != kind) continue;
          if (const Record* record =
                  rows.find(version.instance, entrant, hash_from(version.instance, entrant.second)))
            runs.push_back(run_of(*record, instance.problem, version.back));
        }
        if (runs.empty() && kind != "baseline") continue;
        for (const std::string& block : {corpus, std::string("all corpora")})
          if (block == corpus || corpora.size() > 1)
            count_instance(tally, {block, entrant.first, entrant.second, kind}, instance.problem,
                           baseline, runs, same);
      }
    }
  }

  flips.rows = tally.finished();
  const std::map<std::string, std::string> label_of = labels(records);
  const bool several_starts =
      std::any_of(records.begin(), records.end(),
                  [&](const Record& record) { return record.start != records.front().start; });
  for (FlipRow& row : flips.rows) {
    row.label = label_of.at(row.solver);
    if (several_starts) row.label += " [" + row.start + "]";
  }
  return flips;
}

}  // namespace lcp
