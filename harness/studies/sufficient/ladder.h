#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lcp {

/// Knobs of a scene with their values, in the order in which they are spelled.
using Knobs = std::vector<std::pair<std::string, std::string>>;

/// One way to model what an axis is about.
struct Rung {
  std::string label;  ///< What the user would type: `directions=4`, or a solver's spelling.
  Knobs knobs = {};   ///< Of the scene.
  std::optional<std::string> solver = {};
};

/// One thing that a model can have more or less of: its rungs, richest first.
struct ModelAxis {
  std::string name;
  std::vector<Rung> rungs;
};

/// A rung for each axis of a ladder, by its place.
using Rungs = std::vector<std::size_t>;

/// A model of a scene: a rung of every axis.
struct SceneModel {
  std::string label;  ///< Rungs that are not the reference's, joined by " + ".
  std::string scene;  ///< Full spelling.
  std::string solver;
};

/// The ladders of models of a scene, and the scene with all that its axes do not vary.
struct ModelLadder {
  std::string scene;            ///< As asked for, full spelling.
  std::vector<ModelAxis> axes;  ///< Rung 0 of each is the reference's.
  std::vector<std::string>
      kept;  ///< Axes that are not varied, as the scene was given a knob of theirs.
};

/// The ladders of `scene`:
///
///     friction    directions=16, 8, 4, mu=0 (frictionless: n = number of contacts)
///     contacts    reduction=none, paper, deepest-4
///     inactive    active_only=off, on
///     matrix      matrix=clean, ada
///     time step   the reference's `dt` (s), then the scene's own, 2, 5 and 10 times that
///     solver      the reference's, best-first at epsilon = e_max = 1e-3, projected-gauss-seidel from
///                 tolerance 1e-8 to 1e-2, and `solvers`
///
/// An axis whose knob stands in `scene` is kept as it is there, and so is friction without any.
/// Without `dt` the reference has the scene's own. Throws std::invalid_argument on an unknown scene,
/// knob or solver, and on `dt` for a scene that was given its own.
ModelLadder make_ladder(const std::string& scene, const std::string& reference_solver,
                        const std::vector<std::string>& solvers, std::optional<double> dt = {});

/// The model with `rungs[k]` of axis k. Throws std::invalid_argument where the scene refuses it.
SceneModel model_of(const ModelLadder& ladder, const Rungs& rungs);

}  // namespace lcp
