#include "harness/studies/perturb/perturb_flips.h"

#include <algorithm>
#include <map>
#include <utility>

#include "harness/observed_quantile.h"
#include "harness/runs/settings.h"
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

/// A row in the making, with the numbers of all its instances that it keeps the middle of.
struct Tally {
  FlipRow row;
  std::vector<double> pivots = {}, ratios = {};
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

void count_answers(Tally& tally, const Problem& original, const std::vector<const Run*>& solved,
                   double same) {
  const auto pivots = [](const Run* run) { return static_cast<double>(run->record->work.pivots); };
  for (const Run* run : solved) tally.pivots.push_back(pivots(run));
  if (solved.size() < 2) return;
  FlipRow& row = tally.row;
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
  const auto [least, most] = std::minmax_element(
      tally.pivots.end() - static_cast<std::ptrdiff_t>(solved.size()), tally.pivots.end());
  if (*least > 0) tally.ratios.push_back(*most / *least);
}

/// One instance met by one solver: what is known of it undisturbed and under one kind.
void count_instance(Tally& tally, const Problem& original, const Run& baseline,
                    const std::vector<Run>& runs, double same) {
  FlipRow& row = tally.row;
  const Verdict verdict = baseline.record->verdict;
  if (baseline.record->trivial || verdict == Verdict::not_run) {
    ++(baseline.record->trivial ? row.trivial : row.not_run);
    return;
  }
  const bool is_baseline = row.kind == "baseline";
  std::vector<Run> trials = is_baseline ? std::vector<Run>{baseline} : runs;
  row.unsupported += static_cast<Index>(std::erase_if(trials, [verdict](const Run& run) {
    return verdict == Verdict::unsupported && run.record->verdict == verdict;
  }));
  if (trials.empty()) return;
  ++row.instances;
  count_verdicts(row, baseline, trials);
  std::vector<const Run*> solved;
  if (baseline.z.size() > 0) solved.push_back(&baseline);
  for (const Run& trial : trials)
    if (!is_baseline && trial.z.size() > 0) solved.push_back(&trial);
  count_answers(tally, original, solved, same);
}

/// Counts one more instance that a kind does not apply to.
void add_reason(std::vector<NotApplicable>& all, const NotApplicable& one) {
  for (NotApplicable& known : all)
    if (known.corpus == one.corpus && known.kind == one.kind && known.reason == one.reason) {
      ++known.instances;
      return;
    }
  all.push_back(one);
}

/// Who solved: full spelling, and from which start.
using Entrant = std::pair<std::string, std::string>;

/// Records by what makes them the same piece of work.
class DisturbedRows {
 public:
  explicit DisturbedRows(const std::vector<Record>& records) {
    for (const Record& record : records) {
      by_key_[key_of(record)] = &record;
      const Entrant entrant{record.solver, record.start};
      if (std::find(entrants.begin(), entrants.end(), entrant) == entrants.end())
        entrants.push_back(entrant);
    }
  }
  const Record* find(const Instance& instance, const Entrant& entrant) const {
    const bool warm = entrant.second == to_string(StartKind::previous);
    const auto found =
        by_key_.find({instance.name, warm ? hash_with_previous(instance) : instance.sha256,
                      entrant.first, entrant.second});
    return found == by_key_.end() ? nullptr : found->second;
  }

  std::vector<Entrant> entrants;

 private:
  std::map<PairKey, const Record*> by_key_;
};

}  // namespace

Flips count_flips(const std::vector<Instance>& instances, const std::vector<Record>& records,
                  const PerturbOptions& options, double same) {
  Flips flips{options, same, records.empty() ? 0 : records.front().tolerance, {}, {}};
  const DisturbedRows rows(records);
  std::vector<std::string> corpora, kinds = {"baseline"};
  for (const Instance& instance : instances) append_missing(corpora, {corpus_of(instance.name)});
  for (const DisturbanceKind kind : options.kinds) kinds.push_back(to_string(kind));
  std::vector<std::string> blocks = corpora;
  if (corpora.size() > 1) blocks.push_back("all corpora");
  const std::map<std::string, std::string> label_of = labels(records);
  const bool several_starts =
      std::any_of(records.begin(), records.end(),
                  [&](const Record& record) { return record.start != records.front().start; });
  std::vector<Tally> tallies;
  for (const std::string& block : blocks)
    for (const auto& [solver, start] : rows.entrants)
      for (const std::string& kind : kinds) {
        tallies.push_back({{.corpus = block, .solver = solver, .start = start, .kind = kind}});
        tallies.back().row.label = label_of.at(solver) + (several_starts ? " [" + start + "]" : "");
      }

  for (const Instance& instance : instances) {
    const std::string corpus = corpus_of(instance.name);
    std::vector<std::pair<std::string, Disturbed>> disturbed;  // kind, what it makes
    for (const Disturbance& each : disturbances_of(instance, options))
      disturbed.emplace_back(to_string(each.kind), disturb(instance, each, options));
    for (const DisturbanceKind kind : options.kinds)
      if (const std::string reason = reason_against(kind, instance.problem); !reason.empty())
        add_reason(flips.not_applicable, {corpus, to_string(kind), reason, 1});
    for (Tally& tally : tallies) {
      const FlipRow& row = tally.row;
      if (row.corpus != corpus && !(corpora.size() > 1 && row.corpus == blocks.back())) continue;
      const Entrant entrant{row.solver, row.start};
      const Record* undisturbed = rows.find(instance, entrant);
      if (!undisturbed) continue;
      std::vector<Run> runs;
      for (const auto& [kind, version] : disturbed)
        if (const Record* record =
                kind == row.kind ? rows.find(version.instance, entrant) : nullptr)
          runs.push_back(run_of(*record, instance.problem, version.back));
      if (!runs.empty() || row.kind == "baseline")
        count_instance(tally, instance.problem, run_of(*undisturbed, instance.problem, {}), runs,
                       same);
    }
  }
  for (Tally& tally : tallies) {
    tally.row.pivots = observed_quantile(tally.pivots, 0.5);
    tally.row.pivot_ratio = observed_quantile(tally.ratios, 0.5);
    tally.row.pivot_ratio_max = observed_quantile(tally.ratios, 1.0);
    flips.rows.push_back(std::move(tally.row));
  }
  return flips;
}

}  // namespace lcp
