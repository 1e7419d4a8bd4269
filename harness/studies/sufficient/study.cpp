#include "harness/studies/sufficient/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>

#include "harness/studies/loop/tracked_runs.h"
#include "harness/studies/sufficient/combine.h"

namespace lcp {

namespace {

constexpr double kLeastPatience = 1;  // s

/// An answer acts whatever its residual, but for one that is not finite.
constexpr Acceptance kAnyResidual{Acceptance::Criterion::residual,
                                  std::numeric_limits<double>::max()};

struct Interrupted {};

struct NamedError {
  const char* name;
  double PhysicalError::*error;
  double Criteria::*tolerance;
};
constexpr std::array<NamedError, 4> kErrors{
    {{"trajectory", &PhysicalError::trajectory, &Criteria::trajectory},
     {"force", &PhysicalError::force, &Criteria::force},
     {"penetration", &PhysicalError::penetration, &Criteria::penetration},
     {"slip", &PhysicalError::slip, &Criteria::slip}}};

PhysicalError error_of(const Drift& drift) {
  return {drift.distance, drift.force, drift.depth, drift.slip};
}

/// Times of a model in each round, frame by frame.
class Rounds {
 public:
  void add(const Track& track) {
    if (track.frames() == 0) return;
    lcp_.push_back(track.lcp_s);
    step_.push_back(track.step_s);
    simulated_ = track.simulated();
  }
  bool empty() const { return step_.empty(); }
  /// s per simulated s, of the quickest round of each frame but for round `left_out`.
  double lcp(std::size_t left_out = kNone) const { return quickest(lcp_, left_out); }
  double step(std::size_t left_out = kNone) const { return quickest(step_, left_out); }
  std::size_t count() const { return step_.size(); }

  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

 private:
  double quickest(const std::vector<VectorXd>& rounds, std::size_t left_out) const {
    std::optional<VectorXd> least;
    for (std::size_t i = 0; i < rounds.size(); ++i)
      if (i != left_out) least = least ? least->cwiseMin(rounds[i]).eval() : rounds[i];
    return least ? least->sum() / simulated_ : 0;
  }

  std::vector<VectorXd> lcp_, step_;
  double simulated_ = 0;
};

/// `time` tells the time of a model with a round left out.
template <class Time>
Saving saving_of(const Rounds& model, const Rounds& reference, Time time) {
  const auto saved = [&](std::size_t left_out) {
    return 1 - time(model, left_out) / time(reference, left_out);
  };
  Saving saving{saved(Rounds::kNone), saved(Rounds::kNone), saved(Rounds::kNone)};
  if (reference.count() < 2 || model.count() < reference.count()) return saving;
  for (std::size_t i = 0; i < reference.count(); ++i) {
    saving.low = std::min(saving.low, saved(i));
    saving.high = std::max(saving.high, saved(i));
  }
  return saving;
}

/// A study while it is made.
class Studied {
 public:
  Studied(const StudyPlan& plan, const std::function<void(const Progress&)>& progress,
          const std::atomic<bool>& interrupted)
      : plan_(plan), progress_(progress), interrupted_(interrupted) {
    study_.plan = plan;
  }

  Study run() {
    reference_model_ = model_of(plan_.ladder, Rungs(axes(), 0));
    find_horizon();
    vary_each_axis_alone();
    combine_axes();
    find_cheapest();
    return std::move(study_);
  }

 private:
  std::size_t axes() const { return plan_.ladder.axes.size(); }

  TrackedTask task(const SceneModel& model, double duration, std::optional<double> limit) {
    auto scene = scenes_.find(model.scene);
    if (scene == scenes_.end()) scene = scenes_.emplace(model.scene, make_scene(model.scene)).first;
    TrackedTask made{scene->second, model.solver, limit,
                     fmt::format("{}, {}", scene->second.info.name, model.label)};
    made.scene.setup.duration = duration;
    return made;
  }
  TrackedTask disturbed_task(double duration) {
    TrackedTask made = task(reference_model_, duration, {});
    disturb_start(made.scene, plan_.disturbance);
    made.name += " disturbed";
    return made;
  }
  std::vector<Track> tracks(const std::vector<TrackedTask>& tasks) const {
    auto made = run_tracks(tasks, kAnyResidual, plan_.silence, progress_, interrupted_);
    if (!made) throw Interrupted{};
    return std::move(*made);
  }

  /// Runs the reference and its disturbed self as long as they may last.
  void find_horizon() {
    std::vector<Track> both =
        tracks({task(reference_model_, plan_.duration, {}), disturbed_task(plan_.duration)});
    reference_ = std::move(both[0]);
    if (!reference_.broken.empty())
      throw std::runtime_error(fmt::format("the reference {} with {} is none: {}",
                                           reference_model_.scene, reference_model_.solver,
                                           reference_.broken));
    floor_ = drift(both[1], reference_, plan_.criteria.window);
    study_.horizon = plan_.duration;
    for (const Drift& each : floor_)
      if (over_tolerance(error_of(each), plan_.criteria) > plan_.floor_share) {
        study_.horizon = std::min(study_.horizon, each.time);
        break;
      }
    if (study_.horizon < std::min(plan_.criteria.window, plan_.duration))
      throw std::runtime_error(fmt::format(
          "{}: after {:g} s the reference disturbed by {:g} is {:g} of a tolerance from itself, "
          "expected more than the {:g} s over which forces are averaged: raise tolerances",
          reference_model_.scene, study_.horizon, plan_.disturbance, plan_.floor_share,
          plan_.criteria.window));
  }

  double patience() const {
    return std::max(kLeastPatience,
                    plan_.patience * reference_.elapsed_s * study_.horizon / plan_.duration);
  }

  bool goes_on(const Track& track) const { return track.broken.empty(); }

  ModelRow row_of(const SceneModel& model, const std::string& axis, const Track& track,
                  const Rounds& rounds, const Rounds& reference) const {
    ModelRow row;
    row.model = model;
    row.axis = axis;
    row.error = error_of(largest(drift(track, reference_, plan_.criteria.window), study_.horizon));
    row.until = track.simulated();
    row.broken = track.broken;
    row.stopped = track.stopped;
    row.frames = track.contact_frames;
    row.failed = track.failed;
    row.n = track.n;
    row.passes = track.broken.empty() && exceeded(row.error, plan_.criteria).empty();
    if (rounds.empty()) return row;
    row.lcp = rounds.lcp();
    row.step = rounds.step();
    row.step_saved = saving_of(rounds, reference, std::mem_fn(&Rounds::step));
    if (reference.lcp() > 0)
      row.lcp_saved = saving_of(rounds, reference, std::mem_fn(&Rounds::lcp));
    return row;
  }

  /// Rows of `models`, simulated in rounds with the reference and its disturbed self. One that does
  /// not reach the end is not simulated again.
  std::vector<ModelRow> simulate(const std::vector<SceneModel>& models,
                                 const std::vector<std::string>& axis) {
    std::vector<Track> first;
    std::vector<Rounds> rounds(models.size() + 2);
    for (int round = 0; round < plan_.rounds; ++round) {
      std::vector<TrackedTask> tasks = {task(reference_model_, study_.horizon, {}),
                                        disturbed_task(study_.horizon)};
      std::vector<std::size_t> who = {0, 1};
      for (std::size_t i = 0; i < models.size(); ++i) {
        if (round > 0 && !goes_on(first[i + 2])) continue;
        tasks.push_back(task(models[i], study_.horizon, patience()));
        who.push_back(i + 2);
      }
      std::vector<Track> made = tracks(tasks);
      for (std::size_t k = 0; k < made.size(); ++k) rounds[who[k]].add(made[k]);
      if (round == 0) first = std::move(made);
    }
    const ModelRow disturbed =
        row_of(reference_model_, "disturbed", first[1], rounds[1], rounds[0]);
    if (study_.rows.empty()) {  // the rounds of single rungs
      study_.reference = row_of(reference_model_, "reference", first[0], rounds[0], rounds[0]);
      study_.disturbed = disturbed;
    }
    std::vector<ModelRow> rows;
    for (std::size_t i = 0; i < models.size(); ++i) {
      ModelRow& row =
          rows.emplace_back(row_of(models[i], axis[i], first[i + 2], rounds[i + 2], rounds[0]));
      row.time_noise = std::abs(disturbed.step_saved.all);
      row.cheaper = row.step_saved.all > row.time_noise;
    }
    return rows;
  }

  static Worth worth_of(const ModelRow& row) { return {row.passes, row.step_saved.all}; }

  void vary_each_axis_alone() {
    std::vector<SceneModel> models;
    std::vector<std::string> names;
    for (std::size_t axis = 0; axis < axes(); ++axis)
      for (std::size_t rung = 1; rung < plan_.ladder.axes[axis].rungs.size(); ++rung) {
        Rungs rungs(axes(), 0);
        rungs[axis] = rung;
        models.push_back(model_of(plan_.ladder, rungs));
        names.push_back(plan_.ladder.axes[axis].name);
        single_.push_back({axis, rung, {}});
      }
    study_.rows = simulate(models, names);
    for (std::size_t i = 0; i < single_.size(); ++i) single_[i].worth = worth_of(study_.rows[i]);
  }

  void combine_axes() {
    combine(axes(), single_, std::abs(study_.disturbed.step_saved.all), [&](const Rungs& rungs) {
      study_.rows.push_back(simulate({model_of(plan_.ladder, rungs)}, {"combination"}).front());
      return worth_of(study_.rows.back());
    });
  }

  void find_cheapest() {
    for (std::size_t i = 0; i < study_.rows.size(); ++i) {
      const ModelRow& row = study_.rows[i];
      if (!row.passes || !row.cheaper) continue;
      if (!study_.cheapest || row.step_saved.all > study_.rows[*study_.cheapest].step_saved.all)
        study_.cheapest = i;
    }
  }

  const StudyPlan& plan_;
  const std::function<void(const Progress&)>& progress_;
  const std::atomic<bool>& interrupted_;
  std::map<std::string, NamedScene> scenes_;  ///< Set up once; processes get them by forking.
  SceneModel reference_model_;
  Track reference_;
  std::vector<Drift> floor_;
  std::vector<SingleRung> single_;  ///< Of the first rows.
  Study study_;
};

void require_sensible(const StudyPlan& plan) {
  for (const auto& [what, value] : {std::pair("duration", plan.duration),
                                    {"disturbance", plan.disturbance},
                                    {"floor share", plan.floor_share},
                                    {"patience", plan.patience},
                                    {"window", plan.criteria.window},
                                    {"rounds", static_cast<double>(plan.rounds)}})
    if (!(value > 0) || !std::isfinite(value))
      throw std::invalid_argument(
          fmt::format("sufficient: {} is {:g}, expected more than 0", what, value));
}

}  // namespace

double over_tolerance(const PhysicalError& error, const Criteria& criteria) {
  double most = 0;
  for (const NamedError& each : kErrors)
    most = std::max(most, error.*each.error / criteria.*each.tolerance);
  return most;
}

std::vector<std::string> exceeded(const PhysicalError& error, const Criteria& criteria) {
  std::vector<std::string> names;
  for (const NamedError& each : kErrors)
    if (!(error.*each.error <= criteria.*each.tolerance)) names.emplace_back(each.name);
  return names;
}

std::optional<Study> study(const StudyPlan& plan,
                           const std::function<void(const Progress&)>& progress,
                           const std::atomic<bool>& interrupted) {
  require_sensible(plan);
  try {
    return Studied(plan, progress, interrupted).run();
  } catch (const Interrupted&) {
    return std::nullopt;
  }
}

}  // namespace lcp
