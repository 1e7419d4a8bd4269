#include "harness/studies/paper/plan.h"

#include <algorithm>

#include "harness/studies/paper/published.h"
#include "solvers/registry.h"

namespace lcp {

namespace {

/// The column under the name that the paper's tables and the registry give it.
PaperColumn column_named(const std::string& name, Acceptance acceptance = by_paper) {
  if (name == "lexicographic") return {name, "lexico best", "", acceptance};  // The sweep finds it.
  std::string heading = name;
  for (const char* const long_name : {"lexicographic:delta=", "lexicographic-"})
    if (name.starts_with(long_name))
      heading = (name.find('=') == std::string::npos ? "lexico-" : "lexico ") +
                name.substr(std::string(long_name).size());
  const std::string solver = name == "proposed" ? proposed_solver : name;
  return {name, heading, make_solver(solver).spelling, acceptance};
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
  return column_named("lexicographic:delta=" + delta);
}

PaperPlan paper_plan(int table, bool all_solvers, double limit) {
  const PublishedTable& printed = published().table(table);
  PaperPlan plan;
  plan.table = table;
  if (plan.by_scene()) {
    for (const std::string& name : printed.columns)
      plan.scenes.push_back({name, name == "hoist:10ms" ? "hoist:dt=0.01" : name});
    plan.solvers = {column_named("proposed")};
    plan.own_rows = {"no_solution",   "cycle", "error",           "frictionless_failures",
                     "both_failures", "nodes", "residual_median", "depth_max",
                     "energy_excess", "work",  "gap_end"};
  } else {
    const bool squat = table == 1;
    plan.scenes = {{"in the loop", squat ? "squat" : "tap-dance"}};
    plan.own_rows = {"frictionless_failures", "both_failures", "fell", "depth_max"};
    if (squat) {
      plan.scenes.push_back({"reduced", "squat:reduction=paper"});
      plan.own_rows.push_back("force_mismatch");
      plan.jobs = 2;
    } else {
      plan.deltas = {"0",    "1e-12", "1e-11", "1e-10", "1e-9", "1e-8",
                     "1e-7", "1e-6",  "1e-5",  "1e-4",  "1e-3"};
      plan.samples = 3;
    }
    plan.own_rows.push_back("residual_median");
    plan.driver = make_solver("best-first").spelling;
    for (const std::string& name : printed.columns) plan.solvers.push_back(column_named(name));
    plan.solvers.push_back(column_named("lexicographic-pivot"));
  }
  for (const PublishedTable::Row& row : printed.rows)
    if (std::count(plan.own_rows.begin(), plan.own_rows.end(), row.key) == 0 &&
        row.key != "time_ratio")  // Of two columns.
      plan.rows.push_back(row.key);
  plan.solvers.push_back(column_named("best-first", second_look));
  if (all_solvers)
    add_rest_of_registry(plan, plan.by_scene() ? std::optional(limit) : std::nullopt);
  return plan;
}

}  // namespace lcp
