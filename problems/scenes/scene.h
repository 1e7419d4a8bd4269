#pragma once

#include <string>
#include <vector>

#include "problems/collision/shape.h"
#include "problems/rigid/simulation.h"
#include "solvers/catalogue.h"

namespace lcp {

/// A scene ready to be simulated.
struct SceneSetup {
  System system;
  Stepping stepping;
  double length = 1;    ///< m, of what moves: the measure of distances between two motions.
  double duration = 1;  ///< s.
  std::vector<collision::Shape> shapes =
      {};  ///< For pictures: bodies, and a floor if there is one.
};

/// A scene of the catalogue with its knobs set, which sets it up. Deterministic. Throws
/// std::invalid_argument when knobs contradict one another.
struct Scene : Configured<SceneSetup()> {
  static constexpr const char* kind = "scene";
};

struct SceneInfo {
  std::string name;
  std::string summary;
  std::string source;
};

using SceneRow = CatalogueRow<SceneInfo, Scene>;
/// Registers a scene; `make(Knobs)` sets it up.
using SceneRegistration = Registered<SceneInfo, Scene>;

/// All scenes, sorted by name.
const std::vector<SceneRow>& scenes();

/// A scene in full spelling, set up.
struct NamedScene {
  std::string spelling;  ///< Name and every knob that differs from its default, in table order.
  SceneInfo info;
  SceneSetup setup;
};

/// The scene that `name:key=value,...` describes; throws std::invalid_argument with the list of what
/// is allowed.
NamedScene make_scene(const std::string& text);

/// Knobs that every scene has: how its contacts are posed and stepped.
struct SteppingKnobs {
  double mu = 0.7;
  Index directions = 8;
  FrictionModel::Axes axes = FrictionModel::Axes::slip;
  ContactModel::Start start = ContactModel::Start::two_step;
  bool active_only = false;
  ReductionOptions::Method reduction = ReductionOptions::Method::none;
  double correction = 0.005;
  Stepping::Matrix matrix = Stepping::Matrix::ada;
  Stepping::Scheme scheme = Stepping::Scheme::paper;
  double dt = 1e-3;

  Stepping stepping() const;
};

/// A scene's own knobs followed by these.
OptionTable with_stepping_knobs(OptionTable table, SteppingKnobs& knobs);

}  // namespace lcp
