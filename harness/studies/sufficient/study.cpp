#include "harness/studies/sufficient/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "harness/studies/sufficient/combine.h"

namespace lcp {

namespace {

constexpr double kLeastPatience = 1;  // s

/// An answer acts whatever its residual, but for one that is not finite.
constexpr Acceptance kAnyResidual{Acceptance::Criterion::residual,
                                  std::numeric_limits<double>::max()};

/// Times of a model in each round, frame by frame.
struct Rounds {
  std::vector<VectorXd> lcp = {}, step = {};  // s
  double simulated = 0;                       // s

  void add(const Track& track) {
    if (track.frames() == 0) return;
    lcp.push_back(track.lcp_s);
    step.push_back(track.step_s);
    simulated = track.simulated();
  }
  /// s per simulated s, of the quickest round of each frame but for round `left_out`.
  double rate(std::vector<VectorXd> Rounds::*times, std::size_t left_out = -1) const {
    std::optional<VectorXd> least;
    for (std::size_t i = 0; i < (this->*times).size(); ++i)
      if (const VectorXd& round = (this->*times)[i]; i != left_out)
        least = least ? least->cwiseMin(round).eval() : round;
    return least ? least->sum() / simulated : 0;
  }
};

Saving saving_of(const Rounds& model, const Rounds& reference,
                 std::vector<VectorXd> Rounds::*times) {
  const auto saved = [&](std::size_t left_out) {
    return 1 - model.rate(times, left_out) / reference.rate(times, left_out);
  };
  const double all = saved(-1);
  Saving saving{all, all, all};
  const std::size_t rounds = (reference.*times).size();
  if (rounds < 2 || (model.*times).size() < rounds) return saving;
  for (std::size_t i = 0; i < rounds; ++i) {
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
      : plan_(plan),
        runs_{kAnyResidual, plan.criteria.window, plan.silence, progress, interrupted} {
    study_.plan = plan;
  }

  Study run() {
    const Rungs none(plan_.ladder.axes.size(), 0);
    reference_model_ = model_of(plan_.ladder, none);
    find_horizon();
    std::vector<SingleRung> singles;
    std::vector<SceneModel> models;
    std::vector<std::string> names;
    for (std::size_t axis = 0; axis < none.size(); ++axis)
      for (std::size_t rung = 1; rung < plan_.ladder.axes[axis].rungs.size(); ++rung) {
        Rungs rungs = none;
        rungs[axis] = rung;
        models.push_back(model_of(plan_.ladder, rungs));
        names.push_back(plan_.ladder.axes[axis].name);
        singles.push_back({axis, rung, {}});
      }
    study_.rows = simulate(models, names);
    for (std::size_t i = 0; i < singles.size(); ++i) singles[i].worth = worth_of(study_.rows[i]);
    combine(
        none.size(), singles, std::abs(study_.disturbed.step_saved.all), [&](const Rungs& rungs) {
          study_.rows.push_back(simulate({model_of(plan_.ladder, rungs)}, {"combination"}).front());
          return worth_of(study_.rows.back());
        });
    double most_saved = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < study_.rows.size(); ++i) {
      const ModelRow& row = study_.rows[i];
      if (!row.passes || !row.cheaper || row.step_saved.all <= most_saved) continue;
      study_.cheapest = i;
      most_saved = row.step_saved.all;
    }
    return std::move(study_);
  }

 private:
  static Worth worth_of(const ModelRow& row) { return {row.passes, row.step_saved.all}; }

  TrackedTask task(const SceneModel& model, double duration, std::optional<double> limit = {}) {
    auto scene = scenes_.find(model.scene);
    if (scene == scenes_.end()) scene = scenes_.emplace(model.scene, make_scene(model.scene)).first;
    TrackedTask made{scene->second, model.solver, limit,
                     fmt::format("{}, {}", scene->second.info.name, model.label)};
    made.scene.setup.duration = duration;
    return made;
  }
  /// The reference and its disturbed self.
  std::vector<TrackedTask> controls(double duration) {
    const TrackedTask reference = task(reference_model_, duration);
    std::vector<TrackedTask> both = {reference, disturbed(reference, plan_.disturbance)};
    both[1].name += " disturbed";
    return both;
  }

  /// Runs the reference and its disturbed self as long as they may last.
  void find_horizon() {
    const std::vector<DriftLine> both = runs_.simulate(controls(plan_.duration));
    if (const Track& reference = runs_.reference; !reference.broken.empty())
      throw std::runtime_error(fmt::format("the reference {} with {} is none: {}", reference.scene,
                                           reference.solver, reference.broken));
    const auto parted = [&](const Drift& each) {
      return over_tolerance(each, plan_.criteria) > plan_.floor_share;
    };
    const std::vector<Drift>& floor = both[1].drifts;
    const auto first = std::find_if(floor.begin(), floor.end(), parted);
    study_.horizon = first == floor.end() ? plan_.duration : std::min(plan_.duration, first->time);
    if (study_.horizon < std::min(plan_.criteria.window, plan_.duration))
      throw std::runtime_error(fmt::format(
          "{}: after {:g} s the reference disturbed by {:g} is {:g} of a tolerance from itself, "
          "expected more than the {:g} s over which forces are averaged: raise tolerances",
          reference_model_.scene, study_.horizon, plan_.disturbance, plan_.floor_share,
          plan_.criteria.window));
  }

  ModelRow row_of(const SceneModel& model, const std::string& axis, const DriftLine& line,
                  const Rounds& rounds, const Rounds& reference) const {
    const Track& track = line.track;
    ModelRow row{.model = model,
                 .axis = axis,
                 .error = largest(line.drifts, study_.horizon),
                 .until = track.simulated(),
                 .broken = track.broken,
                 .stopped = track.stopped,
                 .frames = track.contact_frames,
                 .failed = track.failed,
                 .n = track.n};
    row.passes = track.broken.empty() && exceeded(row.error, plan_.criteria).empty();
    if (rounds.step.empty()) return row;
    row.lcp = rounds.rate(&Rounds::lcp);
    row.step = rounds.rate(&Rounds::step);
    row.step_saved = saving_of(rounds, reference, &Rounds::step);
    if (reference.rate(&Rounds::lcp) > 0)
      row.lcp_saved = saving_of(rounds, reference, &Rounds::lcp);
    return row;
  }

  /// Rows of `models`, simulated in rounds with the reference and its disturbed self. One that does
  /// not reach the end is not simulated again.
  std::vector<ModelRow> simulate(const std::vector<SceneModel>& models,
                                 const std::vector<std::string>& axis) {
    const double patience = std::max(kLeastPatience, plan_.patience * runs_.reference.elapsed_s *
                                                         study_.horizon / plan_.duration);
    std::vector<DriftLine> first;
    std::vector<Rounds> rounds(models.size() + 2);
    for (int round = 0; round < plan_.rounds; ++round) {
      std::vector<TrackedTask> tasks = controls(study_.horizon);
      std::vector<std::size_t> who = {0, 1};
      for (std::size_t i = 0; i < models.size(); ++i) {
        if (round > 0 && !first[i + 2].track.broken.empty()) continue;
        tasks.push_back(task(models[i], study_.horizon, patience));
        who.push_back(i + 2);
      }
      std::vector<DriftLine> made = runs_.simulate(tasks);
      for (std::size_t k = 0; k < made.size(); ++k) rounds[who[k]].add(made[k].track);
      if (round == 0) first = std::move(made);
    }
    const auto row = [&](std::size_t i, const SceneModel& model, const std::string& of) {
      return row_of(model, of, first[i], rounds[i], rounds[0]);
    };
    const ModelRow disturbed = row(1, reference_model_, "disturbed");
    if (study_.rows.empty()) {  // the rounds of single rungs
      study_.reference = row(0, reference_model_, "reference");
      study_.disturbed = disturbed;
    }
    std::vector<ModelRow> rows;
    for (std::size_t i = 0; i < models.size(); ++i) {
      rows.push_back(row(i + 2, models[i], axis[i]));
      rows.back().time_noise = std::abs(disturbed.step_saved.all);
      rows.back().cheaper = rows.back().step_saved.all > rows.back().time_noise;
    }
    return rows;
  }

  const StudyPlan& plan_;
  DriftStudy runs_;
  std::map<std::string, NamedScene> scenes_;  ///< Set up once; processes get them by forking.
  SceneModel reference_model_;
  Study study_;
};

}  // namespace

double over_tolerance(const Drift& error, const Criteria& criteria) {
  double most = 0;
  for (const ErrorKind& kind : error_kinds)
    most = std::max(most, error.*kind.error / criteria.*kind.tolerance);
  return most;
}

std::vector<std::string> exceeded(const Drift& error, const Criteria& criteria) {
  std::vector<std::string> names;
  for (const ErrorKind& kind : error_kinds)
    if (!(error.*kind.error <= criteria.*kind.tolerance)) names.emplace_back(kind.name);
  return names;
}

Study study(const StudyPlan& plan, const std::function<void(const Progress&)>& progress,
            const std::atomic<bool>& interrupted) {
  for (const auto& [what, value] : {std::pair("duration", plan.duration),
                                    {"disturbance", plan.disturbance},
                                    {"floor share", plan.floor_share},
                                    {"patience", plan.patience},
                                    {"window", plan.criteria.window},
                                    {"rounds", static_cast<double>(plan.rounds)}})
    if (!(value > 0) || !std::isfinite(value))
      throw std::invalid_argument(
          fmt::format("sufficient: {} is {:g}, expected more than 0", what, value));
  return Studied(plan, progress, interrupted).run();
}

}  // namespace lcp
