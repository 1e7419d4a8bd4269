#pragma once

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "harness/studies/sufficient/study.h"

namespace lcp {

/// The ladder of a scene with one axis, or none, of which only the rungs named stand below the
/// reference's.
inline StudyPlan plan_of(const std::string& scene, double duration, const std::string& axis = "",
                         const std::vector<std::string>& rungs = {},
                         const std::string& reference = "best-first",
                         const std::vector<std::string>& solvers = {}) {
  StudyPlan plan;
  plan.ladder = make_ladder(scene, reference, solvers);
  for (ModelAxis& each : plan.ladder.axes) {
    std::vector<Rung> kept = {each.rungs.front()};
    for (const Rung& rung : each.rungs)
      if (each.name == axis && std::find(rungs.begin(), rungs.end(), rung.label) != rungs.end())
        kept.push_back(rung);
    each.rungs = std::move(kept);
  }
  plan.duration = duration;
  plan.rounds = 1;
  plan.patience = 100;  // nothing here depends on seconds
  return plan;
}

inline Study made(const StudyPlan& plan) {
  const std::atomic<bool> never = false;
  return study(
      plan, [](const Progress&) {}, never);
}

}  // namespace lcp
