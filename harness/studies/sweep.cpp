#include "harness/studies/sweep.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "solvers/registry.h"

namespace lcp {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool sets(const Spelling& spelling, const std::string& option) {
  return std::any_of(spelling.settings.begin(), spelling.settings.end(),
                     [&](const auto& setting) { return setting.first == option; });
}

OptionTable with_ladders(const NamedSolver& solver) {
  OptionTable table = solver.solver->options();
  std::erase_if(table, [](const Option& option) { return option.accuracy_ladder.empty(); });
  return table;
}

/// `solver` along each of `options` (all, where none are named) that has a ladder and that it leaves
/// open.
std::vector<std::string> climbed(const std::string& solver, const OptionTable& ladders,
                                 const std::vector<std::string>& options) {
  const Spelling spelling = parse_spelling(solver);
  std::vector<std::string> settings;
  for (const Option& option : ladders)
    if ((options.empty() || contains(options, option.name)) && !sets(spelling, option.name))
      for (const std::string& value : option.accuracy_ladder)
        settings.push_back(fmt::format("{}{}{}={}", solver, spelling.settings.empty() ? ':' : ',',
                                       option.name, value));
  return settings;
}

}  // namespace

std::vector<std::string> sweep_settings(const std::string& solver,
                                        const std::vector<std::string>& options) {
  const Spelling spelling = parse_spelling(solver);
  const OptionTable ladders = with_ladders(make_solver(solver));  // refuses a misspelt one
  std::vector<std::string> names;
  for (const Option& option : ladders) names.push_back(option.name);
  if (names.empty())
    throw std::invalid_argument(
        fmt::format("{} has no option that trades speed for accuracy", spelling.name));
  for (const std::string& option : options) {
    if (!contains(names, option))
      throw std::invalid_argument(fmt::format("{} cannot sweep '{}', it can: {}", spelling.name,
                                              option, fmt::join(names, ", ")));
    if (sets(spelling, option))
      throw std::invalid_argument(
          fmt::format("'{}' is both swept and set in '{}'", option, solver));
  }
  return climbed(solver, ladders, options);
}

SweepPlan plan_sweep(const std::vector<std::string>& solvers,
                     const std::vector<std::string>& options) {
  SweepPlan plan;
  bool any = false;
  const auto add = [&](const std::vector<std::string>& settings) {
    any = true;
    plan.settings.insert(plan.settings.end(), settings.begin(), settings.end());
  };
  for (const std::string& text : solvers) {
    if (!names_several(text)) {
      add(sweep_settings(text, options));
      continue;
    }
    for (const NamedSolver& solver : make_solvers({text})) {
      const auto settings = climbed(solver.spelling, with_ladders(solver), options);
      if (!settings.empty()) {
        add(settings);
        continue;
      }
      plan.settings.push_back(solver.spelling);
      plan.without_ladder.push_back(solver.spelling);
    }
  }
  if (!any)
    throw std::invalid_argument(
        fmt::format("no solver of {} has {}: see lcpbench list solvers", fmt::join(solvers, ", "),
                    options.empty() ? "an option that trades speed for accuracy"
                                    : fmt::format("a ladder for {}", fmt::join(options, ", "))));
  return plan;
}

}  // namespace lcp
