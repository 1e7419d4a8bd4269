#include "harness/studies/replay/replay.h"

#include <algorithm>
#include <limits>

#include "harness/studies/replay/search_check.h"
#include "problems/contact/friction_lcp.h"
#include "problems/contact/islands.h"
#include "problems/contact/two_step.h"

namespace lcp {

namespace {

/// One island, and how it is solved.
struct IslandTask {
  const Solver& solver;
  const Problem& problem;
  StartKind start;
  std::optional<Start> previous;
};

/// One island solved, with the basis its first dictionary stood at.
struct IslandRun {
  std::vector<Trace::Step> steps;
  Result result;
  std::vector<Index> alpha;
};

IslandRun run_island(const IslandTask& task, const Trace::Options& conditions) {
  Trace trace(task.problem, conditions);
  IslandRun run;
  const auto solve = [&](const Problem& each, const Call& call) {
    run.alpha = call.start ? call.start->alpha : std::vector<Index>();
    return task.solver.solve(each, call);
  };
  Call call;
  call.observer = trace.observer();
  if (task.start == StartKind::two_step && has_friction(task.problem)) {
    run.result = solve_two_step(solve, task.problem, call.observer).frictional;
  } else {
    if (task.start == StartKind::previous) call.start = task.previous;
    run.result = solve(task.problem, call);
  }
  std::sort(run.alpha.begin(), run.alpha.end());
  run.steps = trace.steps();
  // A start that was not usable and replaced by a cold one (restart=cold).
  if (!run.steps.empty() && run.result.work.start_pivots == 0) run.alpha.clear();
  return run;
}

/// The part of a start that lies in this island, in its own numbering.
std::optional<Start> start_in(const std::optional<Start>& start, const std::vector<Index>& rows) {
  if (!start) return std::nullopt;
  Start within;
  for (const Index row : start->alpha) {
    const auto place = std::lower_bound(rows.begin(), rows.end(), row);
    if (place != rows.end() && *place == row) within.alpha.push_back(place - rows.begin());
  }
  if (start->z.size() > 0) within.z = start->z(rows);
  return within;
}

/// What 113 bits say of the row that the run took instead of the rule's.
void examine(const Problem& problem, const PathRule& rule, const std::vector<Index>& alpha,
             const Labels& labels, const PivotEvent& taken, bool rule_ended, double zero,
             Departure& departure) {
  using Why = Departure::Why;
  const HighProblem high(problem, rule.scale, alpha);
  const HighDictionary dictionary(high, labels, zero);
  const Estimates m = dictionary.column(taken.entering);
  departure.row = taken.row;
  if (const auto fault = fault_of_pivot(dictionary, m, taken, rule.pivot, zero, departure)) {
    departure.why = *fault;
  } else if (rule_ended) {
    departure.why = Why::went_on;
  } else {
    const bool step0 = taken.entering == labels.z0();
    Estimate threshold = departure.rule.ratio;
    threshold.value += step0 ? -rule.delta : rule.delta;
    const bool later = step0 ? surely_less(departure.ratio, threshold, zero)
                             : surely_less(threshold, departure.ratio, zero);
    departure.why = later ? Why::larger_ratio : Why::lost_tie;
  }
}

std::optional<Departure> first_departure(const Problem& problem, const PathRule& rule,
                                         const IslandRun& run, const HighPath& path, double zero) {
  const std::size_t both = std::min(run.steps.size(), path.pivots.size());
  Labels labels(problem.size(), run.alpha);
  std::size_t k = 0;
  for (; k < both && run.steps[k].event.row == path.pivots[k].choice.row; ++k)
    labels.exchange({run.steps[k].event.row, run.steps[k].event.entering});
  const bool run_ended = k == run.steps.size(), rule_ended = k == path.pivots.size();
  if (rule_ended && (run_ended || path.cut_short)) return std::nullopt;
  Departure departure{.pivot = static_cast<Index>(k) + 1};
  departure.entering = run_ended ? path.pivots[k].entering : run.steps[k].event.entering;
  if (!rule_ended) {
    departure.rule = path.pivots[k].choice;
    departure.rule_leaves = path.pivots[k].leaving;
  }
  if (!run_ended)
    examine(problem, rule, run.alpha, labels, run.steps[k].event, rule_ended, zero, departure);
  return departure;
}

/// Before the departure every pivot is the rule's, and so one; that q' stays feasible is not asked.
std::optional<Departure> first_none(const Problem& problem, const PathRule& rule,
                                    const IslandRun& run, const HighLimits& limits) {
  const SearchRule any_feasibility{
      .epsilon = std::numeric_limits<double>::infinity(), .pivot = rule.pivot, .scale = rule.scale};
  std::size_t checked = 0;
  return check_search(problem, any_feasibility, run.alpha, run.steps, limits, checked);
}

void compare(const NamedSolver& solver, const Problem& problem, const IslandRun& run,
             const ReplayOptions& options, Replay& replay) {
  if (const std::optional<PathRule> rule = path_rule(solver)) {
    replay.comparison = Beside::path;
    replay.path = follow_high_path(problem, *rule, run.alpha, options.high);
    replay.departure = first_departure(problem, *rule, run, replay.path, options.high.zero);
    if (replay.departure) replay.first_none = first_none(problem, *rule, run, options.high);
    Result answer;
    answer.z = replay.path.z;
    replay.path_residual = measure(problem, answer).residual;
    replay.path_verdict = from_string<Verdict>(to_string(replay.path.claim));
    if (replay.path.claim == Claim::solved && !(replay.path_residual <= options.tolerance))
      replay.path_verdict = Verdict::wrong;
  } else if (const std::optional<SearchRule> search = search_rule(solver)) {
    replay.comparison = Beside::search;
    replay.departure =
        check_search(problem, *search, run.alpha, run.steps, options.high, replay.checked);
  }
}

/// The window around the departure, without one the last pivots.
void set_window(const ReplayOptions& options, Replay& replay) {
  const std::size_t count = replay.steps.size();
  const std::size_t at =
      replay.departure ? static_cast<std::size_t>(replay.departure->pivot) - 1 : count;
  const std::size_t before = static_cast<std::size_t>(options.before),
                    after = static_cast<std::size_t>(options.after) + 1;
  replay.begin = at > before ? at - before : 0;
  replay.end = at + std::min(count - at, after);
}

bool more_telling(const Replay& a, const Replay& b) {
  if (a.departure.has_value() != b.departure.has_value()) return a.departure.has_value();
  return !a.departure && a.island_claim != Claim::solved && b.island_claim == Claim::solved;
}

}  // namespace

Replay replay(const NamedSolver& solver, const Instance& instance, StartKind start,
              const ReplayOptions& options) {
  const std::vector<Island> islands = split_islands(instance.problem);
  std::optional<Replay> shown;
  for (std::size_t k = 0; k < islands.size(); ++k) {
    const IslandTask task{*solver.solver, islands[k].problem, start,
                          start_in(instance.previous, islands[k].rows)};
    const IslandRun run = run_island(task, {.largest_condition = 0});
    Replay each;
    each.island = static_cast<Index>(k);
    each.islands = static_cast<Index>(islands.size());
    each.rows = islands[k].rows;
    each.steps = run.steps;
    each.island_claim = run.result.claim;
    compare(solver, task.problem, run, options, each);
    set_window(options, each);
    if (each.end > each.begin && task.problem.size() <= options.largest_condition)
      each.steps = run_island(task, {options.largest_condition, each.begin, each.end}).steps;
    if (!shown || more_telling(each, *shown)) shown = std::move(each);
  }
  const Result result = solve_instance(*solver.solver, instance, {}, start);
  shown->claim = result.claim;
  shown->message = result.message;
  shown->judgement = judge(instance, result, options.tolerance);
  if (result.basis)
    shown->basis_residual = basis_residual(instance.problem, *result.basis, options.high.zero);
  return *shown;
}

}  // namespace lcp
