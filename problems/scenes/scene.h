#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "problems/collision/shape.h"
#include "problems/rigid/simulation.h"
#include "solvers/options.h"

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

/// A scene of the catalogue with its knobs set.
class Scene {
 public:
  virtual ~Scene() = default;
  /// Deterministic. Throws std::invalid_argument when knobs contradict one another.
  virtual SceneSetup set_up() const = 0;
  /// Live access to the knobs.
  virtual OptionTable options() = 0;
};

struct SceneInfo {
  std::string name;
  std::string summary;
  std::string source;
};

struct SceneRow {
  SceneInfo info;
  std::function<std::unique_ptr<Scene>()> make;
};

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

/// Registers a scene for as long as the program runs; construct it at the foot of its file.
/// `table(Knobs&)` lists the knobs, `make(Knobs)` sets the scene up.
struct SceneRegistration {
  template <class Knobs, class Table, class Make>
  SceneRegistration(SceneInfo info, Knobs defaults, Table table, Make make) {
    class Registered final : public Scene {
     public:
      Registered(Knobs knobs, Table list, Make make_setup)
          : knobs_(std::move(knobs)), list_(list), make_(make_setup) {}
      SceneSetup set_up() const override { return make_(knobs_); }
      OptionTable options() override { return list_(knobs_); }

     private:
      Knobs knobs_;
      Table list_;
      Make make_;
    };
    add({std::move(info), [=] { return std::make_unique<Registered>(defaults, table, make); }});
  }

 private:
  static void add(SceneRow row);
};

}  // namespace lcp
