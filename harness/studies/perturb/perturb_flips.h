#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/studies/perturb/perturb_plan.h"
#include "harness/studies/wilson.h"

namespace lcp {

/// What a solver did under one kind of disturbance, or (`baseline`) without any, on one corpus.
struct FlipRow {
  std::string corpus = {};
  std::string solver = {};  ///< Full spelling.
  std::string start = {};
  std::string label = {};  ///< As in a table.
  std::string kind = {};   ///< `baseline` or that of a disturbance.
  Index instances = 0;     ///< That count: met, and neither trivial nor out of the solver's reach.
  Index trials = 0;        ///< Runs that count, of all of them; of `baseline`, the instances.
  Index solved = 0;        ///< Of the trials.
  Index baseline_solved = 0;    ///< Of the trials: their instance is solved undisturbed.
  Index lost = 0;               ///< Solved undisturbed, not solved disturbed.
  Index gained = 0;             ///< Not solved undisturbed, solved disturbed.
  Index other_changes = 0;      ///< Solved in neither, and another verdict (ray -> wrong).
  Index instances_flipped = 0;  ///< Instances with at least one flip.

  Index compared = 0;       ///< Instances solved in two runs at least, undisturbed or disturbed.
  Index several = 0;        ///< Instances compared whose z, mapped back, are not all the same.
  Index most_distinct = 0;  ///< The most z that were told apart on one instance.
  /// Solved runs whose z is not that of the first solved run (the undisturbed one comes first).
  Index other_z = 0;
  Index other_z_same_w = 0;  ///< Of other_z, the runs whose w = M z + q is that of the first.
  /// Of other_z, the runs that move the contacts alike: v+ = W f + vbar, within `same` of the scale of
  /// velocities. Forces may be undetermined (and with them z and the w of rows lambda) where motion is
  /// not. Without friction blocks the same as other_z_same_w.
  Index other_z_same_motion = 0;

  std::optional<double> pivots = {};  ///< Median over solved runs.
  /// Most over least pivots of the solved runs of one instance: median over the instances `compared`.
  std::optional<double> pivot_ratio = {};
  std::optional<double> pivot_ratio_max = {};  ///< The largest such ratio.

  Index trivial = 0;      ///< Instances that z = 0 solves; not counted above.
  Index unsupported = 0;  ///< Runs that the solver refuses disturbed or not; not counted above.
  Index not_run = 0;      ///< Instances too large; not counted above.

  Index flips() const { return lost + gained; }
  Interval rate() const { return wilson_interval(flips(), trials); }
};

/// Instances of a corpus that a kind of disturbance does not apply to.
struct NotApplicable {
  std::string corpus;
  std::string kind;
  std::string reason;
  Index instances = 0;
};

struct Flips {
  PerturbOptions options;
  double same = 0;       ///< Largest |dz_i| / s_z,i (|dw_i| / s_w,i) of equal solutions.
  double tolerance = 0;  ///< At which `solved` was judged.
  /// By corpus, then solver and start, then kind, baseline first. Where there are several corpora,
  /// those of `all corpora` follow, which pool them.
  std::vector<FlipRow> rows;
  std::vector<NotApplicable> not_applicable;
};

/// Counts the rows of a run of `instances` (undisturbed) that kept its answers. Rows that belong to no
/// disturbance in `options` are left out, and so are instances whose undisturbed run has no row, and
/// disturbances without one: an interrupted run can be counted. Two z are the same where no component
/// differs by more than `same` in the original problem's scales; each is compared with the first z of
/// every group found so far. Costs a disturbance per row at most.
Flips count_flips(const std::vector<Instance>& instances, const std::vector<Record>& records,
                  const PerturbOptions& options, double same);

}  // namespace lcp
