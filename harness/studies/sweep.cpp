#include "harness/studies/sweep.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "solvers/registry.h"

namespace lcp {

namespace {

OptionTable ladders(OptionTable table) {
  std::erase_if(table, [](const Option& option) { return option.accuracy_ladder.empty(); });
  return table;
}

bool sets(const Spelling& spelling, const std::string& option) {
  return std::any_of(spelling.settings.begin(), spelling.settings.end(),
                     [&](const auto& setting) { return setting.first == option; });
}

}  // namespace

std::vector<std::string> sweep_settings(const std::string& solver,
                                        const std::vector<std::string>& options) {
  const Spelling spelling = parse_spelling(solver);
  const NamedSolver made = make_solver(solver);  // refuses a misspelt one
  const OptionTable table = ladders(made.solver->options());
  std::vector<std::string> names;
  for (const Option& option : table) names.push_back(option.name);
  if (names.empty())
    throw std::invalid_argument(
        fmt::format("{} has no option that trades speed for accuracy", spelling.name));
  for (const std::string& option : options) {
    if (std::find(names.begin(), names.end(), option) == names.end())
      throw std::invalid_argument(fmt::format("{} cannot sweep '{}', it can: {}", spelling.name,
                                              option, fmt::join(names, ", ")));
    if (sets(spelling, option))
      throw std::invalid_argument(
          fmt::format("'{}' is both swept and set in '{}'", option, solver));
  }

  std::vector<std::string> settings;
  for (const Option& option : table) {
    const bool wanted =
        options.empty() ? !sets(spelling, option.name)
                        : std::find(options.begin(), options.end(), option.name) != options.end();
    if (!wanted) continue;
    for (const std::string& value : option.accuracy_ladder)
      settings.push_back(fmt::format("{}{}{}={}", solver, spelling.settings.empty() ? ':' : ',',
                                     option.name, value));
  }
  return settings;
}

namespace {

/// Those of `options` along which `solver` can be swept; all of its own where none are named.
std::vector<std::string> options_to_climb(const NamedSolver& solver,
                                          const std::vector<std::string>& options) {
  const Spelling spelling = parse_spelling(solver.spelling);
  std::vector<std::string> found;
  for (const Option& option : ladders(solver.solver->options())) {
    const bool wanted =
        options.empty() || std::find(options.begin(), options.end(), option.name) != options.end();
    if (wanted && !sets(spelling, option.name)) found.push_back(option.name);
  }
  return found;
}

}  // namespace

SweepPlan plan_sweep(const std::vector<std::string>& solvers,
                     const std::vector<std::string>& options) {
  SweepPlan plan;
  bool any = false;
  const auto climb = [&](const std::string& solver, const std::vector<std::string>& along) {
    any = true;
    for (std::string& setting : sweep_settings(solver, along))
      plan.settings.push_back(std::move(setting));
  };
  for (const std::string& text : solvers) {
    if (!names_several(text)) {
      climb(text, options);
      continue;
    }
    for (const NamedSolver& solver : make_solvers({text})) {
      const std::vector<std::string> along = options_to_climb(solver, options);
      if (!along.empty()) {
        climb(solver.spelling, along);
      } else {
        plan.settings.push_back(solver.spelling);
        plan.without_ladder.push_back(solver.spelling);
      }
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
