#include "problems/scenes/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace lcp {

namespace {

std::vector<SceneRow>& rows() {
  static std::vector<SceneRow> all;
  return all;
}

}  // namespace

void SceneRegistration::add(SceneRow row) {
  const auto place = std::lower_bound(
      rows().begin(), rows().end(), row,
      [](const SceneRow& a, const SceneRow& b) { return a.info.name < b.info.name; });
  rows().insert(place, std::move(row));
}

const std::vector<SceneRow>& scenes() { return rows(); }

NamedScene make_scene(const std::string& text) {
  const Spelling spelling = parse_spelling(text);
  std::vector<std::string> names;
  for (const SceneRow& row : scenes()) {
    names.push_back(row.info.name);
    if (row.info.name != spelling.name) continue;
    const std::unique_ptr<Scene> scene = row.make();
    apply(scene->options(), spelling, row.info.name);
    return {full_spelling(row.info.name, scene->options(), row.make()->options()), row.info,
            scene->set_up()};
  }
  throw std::invalid_argument(
      fmt::format("unknown scene '{}', known are: {}", spelling.name, fmt::join(names, ", ")));
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
  table.push_back(choice("axes", knobs.axes, {"fixed", "slip"},
                         "the first direction is the world's x, or along the slip velocity of a "
                         "sliding contact"));
  table.push_back(
      choice("start", knobs.start, {"cold", "two-step", "all-active", "previous"},
             "the frictional LCP starts from the empty basis, from the independent ones "
             "of the normals that are active without friction, from all of them, or from "
             "the solution of the frame before"));
  table.push_back(flag("active_only", knobs.active_only,
                       "contacts inactive without friction are left out of the frictional LCP"));
  table.push_back(choice("reduction", knobs.reduction, {"none", "paper", "deepest-4"},
                         "which contact points are dropped as superfluous"));
  table.push_back(
      real("correction", knobs.correction, 0, 1, "share of an overlap that one step takes back"));
  table.push_back(
      choice("matrix", knobs.matrix, {"ada", "clean"},
             "contact matrices by assembly and disassembly, or as a product without its "
             "noise: from the composite body, or the joint space where joints move"));
  table.push_back(choice("scheme", knobs.scheme, {"paper", "semi-implicit"},
                         "RK4 with the contact forces of its first stage, or Euler in velocities"));
  table.push_back(real("dt", knobs.dt, 1e-6, 1, "time step, s"));
  return table;
}

}  // namespace lcp
