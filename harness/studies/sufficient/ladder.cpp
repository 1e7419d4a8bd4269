#include "harness/studies/sufficient/ladder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp {

namespace {

ModelAxis axis_of_knob(const std::string& name, const std::string& knob,
                       const std::vector<std::string>& values) {
  ModelAxis axis{name, {}};
  for (const std::string& value : values)
    axis.rungs.push_back({.label = knob + "=" + value, .knobs = {{knob, value}}});
  return axis;
}

ModelAxis friction_axis() {
  ModelAxis axis = axis_of_knob("friction", "directions", {"16", "8", "4"});
  axis.rungs.push_back({.label = "frictionless", .knobs = {{"mu", "0"}}});
  return axis;
}

ModelAxis time_step_axis(double own, double reference) {
  std::vector<std::string> values = {shortest(reference)};
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (own * factor > reference) values.push_back(shortest(own * factor));
  return axis_of_knob("time step", "dt", values);
}

ModelAxis solver_axis(const std::string& reference, const std::vector<std::string>& more) {
  std::vector<std::string> texts = {reference, "best-first:epsilon=1e-3,e_max=1e-3"};
  for (const char* tolerance : {"1e-8", "1e-6", "1e-4", "1e-2"})
    texts.push_back(fmt::format("projected-gauss-seidel:tolerance={}", tolerance));
  texts.insert(texts.end(), more.begin(), more.end());
  ModelAxis axis{"solver", {}};
  for (const NamedSolver& solver : make_solvers(texts))
    axis.rungs.push_back({.label = solver.spelling, .solver = solver.spelling});
  return axis;
}

/// Whether the scene was told which rung of an axis to stand on.
bool is_given(const Spelling& scene, const ModelAxis& axis) {
  return std::any_of(scene.settings.begin(), scene.settings.end(), [&](const auto& setting) {
    const Knobs& knobs = axis.rungs.front().knobs;
    return std::any_of(knobs.begin(), knobs.end(),
                       [&](const auto& knob) { return knob.first == setting.first; });
  });
}

}  // namespace

ModelLadder make_ladder(const std::string& scene, const std::string& reference_solver,
                        const std::vector<std::string>& solvers, std::optional<double> dt) {
  const NamedScene named = make_scene(scene);
  const Spelling given = parse_spelling(scene);
  const double own = named.setup.stepping.dt;
  ModelLadder ladder{named.spelling, {}, {}};
  const ModelAxis time_step = time_step_axis(own, dt.value_or(own));
  if (dt && is_given(given, time_step))
    throw std::invalid_argument(
        fmt::format("{}: its dt is given, and the reference's too: expected one of them", scene));
  std::vector<ModelAxis> axes = {
      friction_axis(),
      axis_of_knob("contacts", "reduction", {"none", "paper", "deepest-4"}),
      axis_of_knob("inactive", "active_only", {"off", "on"}),
      axis_of_knob("matrix", "matrix", {"clean", "ada"}),
      time_step,
      solver_axis(reference_solver, solvers)};
  for (ModelAxis& axis : axes) {
    const bool frictionless = axis.name == "friction" && named.setup.system.mu == 0;
    if (frictionless || is_given(given, axis))
      ladder.kept.push_back(axis.name);
    else
      ladder.axes.push_back(std::move(axis));
  }
  return ladder;
}

SceneModel model_of(const ModelLadder& ladder, const Rungs& rungs) {
  SceneModel model;
  const Spelling scene = parse_spelling(ladder.scene);
  std::vector<std::string> settings, labels;
  std::set<std::string> varied;
  for (std::size_t k = 0; k < ladder.axes.size(); ++k) {
    const Rung& rung = ladder.axes[k].rungs.at(rungs.at(k));
    if (rung.solver) model.solver = *rung.solver;
    if (rungs[k] > 0) labels.push_back(rung.label);
    for (const auto& [knob, value] : rung.knobs) {
      settings.push_back(knob + "=" + value);
      varied.insert(knob);
    }
  }
  for (const auto& [knob, value] : scene.settings)
    if (!varied.contains(knob)) settings.push_back(knob + "=" + value);
  model.scene =
      make_scene(settings.empty() ? scene.name
                                  : fmt::format("{}:{}", scene.name, fmt::join(settings, ",")))
          .spelling;
  model.label = labels.empty() ? "reference" : fmt::format("{}", fmt::join(labels, " + "));
  return model;
}

}  // namespace lcp
