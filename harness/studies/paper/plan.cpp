#include "harness/studies/paper/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "solvers/registry.h"

namespace lcp {

namespace {

constexpr Acceptance by_residual{Acceptance::Criterion::residual, 1e-6};

/// The paper's constants (V), spelled out for our solver.
constexpr const char* proposed = "best-first:epsilon=1e-3,e_max=1e-3,polish=off,scale=off";

PaperColumn column(std::string name, std::string heading, const std::string& solver,
                   Acceptance acceptance = by_paper) {
  return {std::move(name), std::move(heading), make_solver(solver).spelling, acceptance};
}

PaperColumn lexicographic(const std::string& delta) {
  const std::string solver = "lexicographic:delta=" + delta;
  return column(solver, "lexico " + delta, solver);
}

/// Ours, in both tables.
void add_own_columns(PaperPlan& plan) {
  plan.columns.push_back(column("lexicographic-pivot", "lexico-pivot", "lexicographic-pivot"));
  plan.columns.push_back(own_column());
}

bool works_in_paper_units(const NamedSolver& solver) {
  for (const Option& option : solver.solver->options())
    if (option.name == "scale") return option.get() == "off";
  return false;
}

PaperPlan table_1() {
  PaperPlan plan;
  plan.table = 1;
  plan.scene = "squat";
  plan.beside = "squat:reduction=paper";
  plan.beside_label = "reduced";
  plan.columns = {proposed_column(), column("lemke", "lemke", "lemke")};
  for (const char* delta : {"0", "1e-8", "1e-6", "1e-4", "1e-3"})
    plan.columns.push_back(lexicographic(delta));
  plan.rows = {"contacts", "active",      "total_frames", "success",
               "failure",  "no_solution", "cycle",        "error"};
  plan.own_rows = {"frictionless_failures", "both_failures",  "fell", "depth_max",
                   "force_mismatch",        "residual_median"};
  plan.samples = 1;
  plan.jobs = 2;
  return plan;
}

PaperPlan table_2() {
  PaperPlan plan;
  plan.table = 2;
  plan.scene = "tap-dance";
  plan.columns = {{"lexicographic", "lexico best", "", by_paper}, proposed_column()};
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
  plan.jobs = 1;  // its times are part of the table
  return plan;
}

}  // namespace

PaperPlan paper_plan(int table, bool all_solvers) {
  if (table != 1 && table != 2)
    throw std::invalid_argument(fmt::format("no plan for table {}, known are: 1, 2", table));
  PaperPlan plan = table == 1 ? table_1() : table_2();
  plan.driver = make_solver("best-first").spelling;
  plan.second_look = by_residual;
  add_own_columns(plan);
  if (all_solvers)
    for (PaperColumn& each : rest_of_registry(plan.columns))
      plan.columns.push_back(std::move(each));
  return plan;
}

PaperColumn proposed_column() { return column("proposed", "proposed", proposed); }

PaperColumn own_column() { return column("best-first", "best-first", "best-first", by_residual); }

std::vector<PaperColumn> rest_of_registry(const std::vector<PaperColumn>& there) {
  std::vector<PaperColumn> rest;
  for (const NamedSolver& solver : make_solvers({"own"})) {
    const bool known = std::any_of(there.begin(), there.end(), [&](const PaperColumn& each) {
      return each.solver == solver.spelling;
    });
    if (known) continue;
    rest.push_back({solver.spelling, solver.spelling, solver.spelling,
                    works_in_paper_units(solver) ? by_paper : by_residual});
  }
  return rest;
}

PaperColumn column_of_delta(const std::string& delta) { return lexicographic(delta); }

}  // namespace lcp
