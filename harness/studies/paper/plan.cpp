#include "harness/studies/paper/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "solvers/registry.h"

namespace lcp {

namespace {

PaperColumn column(std::string name, std::string heading, const std::string& solver,
                   Acceptance acceptance = by_paper) {
  return {std::move(name), std::move(heading), make_solver(solver).spelling, acceptance};
}

bool works_in_paper_units(const NamedSolver& solver) {
  for (const Option& option : solver.solver->options())
    if (option.name == "scale") return option.get() == "off";
  return false;
}

/// A column for every row of the registry that has none: rows that work in the paper's units
/// (scale = off) judged by its criterion, others by the residual.
void add_rest_of_registry(PaperPlan& plan, const std::optional<double>& limit) {
  for (const NamedSolver& solver : make_solvers({"own"}))
    if (std::none_of(plan.solvers.begin(), plan.solvers.end(),
                     [&](const PaperColumn& each) { return each.solver == solver.spelling; }))
      plan.solvers.push_back({solver.spelling, solver.spelling, solver.spelling,
                              works_in_paper_units(solver) ? by_paper : second_look, limit});
}

}  // namespace

// Section V, spelled out for our solver.
const char* const proposed_solver = "best-first:epsilon=1e-3,e_max=1e-3,polish=off,scale=off";

PaperColumn column_of_delta(const std::string& delta) {
  const std::string solver = "lexicographic:delta=" + delta;
  return column(solver, "lexico " + delta, solver);
}

PaperPlan paper_plan(int table, bool all_solvers, double limit) {
  const PaperColumn proposed = column("proposed", "proposed", proposed_solver);
  PaperPlan plan;
  plan.table = table;
  switch (table) {
    case 1:
      plan.scenes = {{"in the loop", "squat"}, {"reduced", "squat:reduction=paper"}};
      plan.solvers = {proposed, column("lemke", "lemke", "lemke")};
      for (const char* delta : {"0", "1e-8", "1e-6", "1e-4", "1e-3"})
        plan.solvers.push_back(column_of_delta(delta));
      plan.rows = {"contacts", "active",      "total_frames", "success",
                   "failure",  "no_solution", "cycle",        "error"};
      plan.own_rows = {"frictionless_failures", "both_failures",  "fell", "depth_max",
                       "force_mismatch",        "residual_median"};
      plan.jobs = 2;
      break;
    case 2:
      plan.scenes = {{"in the loop", "tap-dance"}};
      plan.solvers = {{"lexicographic", "lexico best", ""}, proposed};
      plan.deltas = {"0",    "1e-12", "1e-11", "1e-10", "1e-9", "1e-8",
                     "1e-7", "1e-6",  "1e-5",  "1e-4",  "1e-3"};
      plan.rows = {"delta",
                   "contacts",
                   "active",
                   "total_frames",
                   "success",
                   "failure",
                   "no_solution",
                   "cycle",
                   "error",
                   "lcp_time_ms",
                   "simulation_time_ms",
                   "total_pivots"};
      plan.own_rows = {"frictionless_failures", "both_failures", "fell", "depth_max",
                       "residual_median"};
      plan.samples = 3;
      break;
    case 3:
      plan.scenes = {
          {"hoist", "hoist"}, {"hoist:10ms", "hoist:dt=0.01"}, {"ring", "ring"}, {"net", "net"}};
      plan.solvers = {proposed};
      plan.rows = {"duration",    "contacts",          "active", "total_frames", "failure",
                   "lcp_time_ms", "simulation_time_ms"};
      plan.own_rows = {"no_solution",   "cycle", "error",           "frictionless_failures",
                       "both_failures", "nodes", "residual_median", "depth_max",
                       "energy_excess", "work",  "gap_end"};
      break;
    default:
      throw std::invalid_argument(fmt::format("no plan for table {}, known are: 1, 2, 3", table));
  }
  if (!plan.by_scene()) {
    plan.driver = make_solver("best-first").spelling;
    plan.solvers.push_back(column("lexicographic-pivot", "lexico-pivot", "lexicographic-pivot"));
  }
  plan.solvers.push_back(column("best-first", "best-first", "best-first", second_look));
  if (all_solvers)
    add_rest_of_registry(plan, plan.by_scene() ? std::optional(limit) : std::nullopt);
  return plan;
}

}  // namespace lcp
