#include "problems/scenes/scene.h"

namespace lcp {

namespace {

using Scenes = Catalogue<SceneInfo, Scene>;

}  // namespace

const std::vector<SceneRow>& scenes() { return Scenes::instance().rows(); }

NamedScene make_scene(const std::string& text) {
  SceneRow::Made scene = Scenes::instance().make(text);
  return {std::move(scene.spelling), std::move(scene.info), scene.thing->run()};
}

Stepping SteppingKnobs::stepping() const {
  Stepping stepping;
  stepping.scheme = scheme;
  stepping.dt = dt;
  stepping.contact = {.friction = {.directions = directions, .axes = axes},
                      .start = start,
                      .active_only = active_only};
  stepping.reduction.method = reduction;
  stepping.correction.gain = correction;
  stepping.matrix = matrix;
  return stepping;
}

OptionTable with_stepping_knobs(OptionTable table, SteppingKnobs& knobs) {
  table.push_back(real("mu", knobs.mu, 0, 10, "friction coefficient of every contact"));
  table.push_back(
      count("directions", knobs.directions, 2, 64, "friction directions per contact, even"));
  table.push_back(choice("axes", knobs.axes,
                         "the first direction is the world's x, or along the slip velocity of a "
                         "sliding contact"));
  table.push_back(
      choice("start", knobs.start,
             "the frictional LCP starts from the empty basis, from the independent ones "
             "of the normals that are active without friction, from all of them, or from "
             "the solution of the frame before"));
  table.push_back(flag("active_only", knobs.active_only,
                       "contacts inactive without friction are left out of the frictional LCP"));
  table.push_back(
      choice("reduction", knobs.reduction, "which contact points are dropped as superfluous"));
  table.push_back(
      real("correction", knobs.correction, 0, 1, "share of an overlap that one step takes back"));
  table.push_back(
      choice("matrix", knobs.matrix,
             "contact matrices by assembly and disassembly, or as a product without its "
             "noise: from the composite body, or the joint space where joints move"));
  table.push_back(choice("scheme", knobs.scheme,
                         "RK4 with the contact forces of its first stage, or Euler in velocities"));
  table.push_back(real("dt", knobs.dt, 1e-6, 1, "time step, s"));
  return table;
}

}  // namespace lcp
