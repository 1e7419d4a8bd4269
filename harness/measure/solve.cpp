#include "harness/measure/solve.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "problems/contact/friction_lcp.h"
#include "problems/contact/two_step.h"

namespace lcp {

namespace {

/// How one island is solved.
using SolveIsland = std::function<Result(const Problem&, const Call&)>;

/// Puts `part` into the island's rows of `whole`; a part of another size leaves them NaN.
void scatter(const VectorXd& part, const std::vector<Index>& rows, VectorXd& whole) {
  if (part.size() == static_cast<Index>(rows.size()))
    whole(rows) = part;
  else
    whole(rows).setConstant(std::numeric_limits<double>::quiet_NaN());
}

/// The part of a start that lies in this island, in its own numbering.
Start start_within(const Start& start, const std::vector<Index>& rows) {
  Start within;
  if (start.z.size() > 0) within.z = start.z(rows);
  for (const Index row : start.alpha) {
    const auto place = std::lower_bound(rows.begin(), rows.end(), row);
    if (place != rows.end() && *place == row) within.alpha.push_back(place - rows.begin());
  }
  return within;
}

/// Number in a problem of size n of an island's variable (w_k = k, z_k = size + k, z0 = 2 size).
int whole_variable(int variable, const std::vector<Index>& rows, Index n) {
  const Index size = static_cast<Index>(rows.size());
  if (variable == 2 * size) return static_cast<int>(2 * n);
  return static_cast<int>(variable < size ? rows[variable] : n + rows[variable - size]);
}

/// Tells `observer` of an island's pivots in the numbering of the whole; `basic` holds the basic
/// variables of all rows and is kept up to date.
Observer observe_within(const Observer& observer, const std::vector<Index>& rows, Index n,
                        std::vector<int>& basic) {
  return [&observer, &rows, n, &basic](const PivotEvent& event) {
    PivotEvent translated = event;
    translated.row = rows[event.row];
    translated.entering = whole_variable(event.entering, rows, n);
    translated.leaving = whole_variable(event.leaving, rows, n);
    if (event.basic) {
      for (std::size_t k = 0; k < rows.size(); ++k)
        basic[rows[k]] = whole_variable((*event.basic)[k], rows, n);
      translated.basic = &basic;
    }
    observer(translated);
  };
}

void require_no_start(const Call& call, StartKind start) {
  if (call.start)
    throw std::invalid_argument(
        fmt::format("{}: a starting basis was given, expected none", to_string(start)));
}

std::vector<Result> solve_apart(const SolveIsland& solve, const std::vector<Island>& islands,
                                Index n, const Call& call) {
  std::vector<int> basic(n);
  std::iota(basic.begin(), basic.end(), 0);
  std::vector<Result> parts;
  for (const Island& island : islands) {
    Call within;
    if (call.start) within.start = start_within(*call.start, island.rows);
    if (call.observer) within.observer = observe_within(call.observer, island.rows, n, basic);
    parts.push_back(solve(island.problem, within));
  }
  return parts;
}

/// z0 of the whole, and its covering vector: z0 c is then each island's own z0 c.
void join_artificial(const std::vector<Result>& parts, const std::vector<Island>& islands,
                     Result& whole) {
  const auto largest = std::max_element(
      parts.begin(), parts.end(),
      [](const Result& a, const Result& b) { return std::abs(a.z0) < std::abs(b.z0); });
  whole.z0 = largest->z0;
  if (whole.z0 == 0) return;
  whole.covering = VectorXd::Zero(whole.z.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (parts[k].covering.size() > 0)
      scatter(parts[k].covering * (parts[k].z0 / whole.z0), islands[k].rows, whole.covering);
}

void join_basis(const std::vector<Result>& parts, const std::vector<Island>& islands,
                Result& whole) {
  const bool all_have_one =
      std::all_of(parts.begin(), parts.end(), [](const Result& part) { return part.basis; });
  if (!all_have_one) return;
  whole.basis.emplace();
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (const Index row : *parts[k].basis) whole.basis->push_back(islands[k].rows.at(row));
  std::sort(whole.basis->begin(), whole.basis->end());
}

/// Solves the islands by `solve` and joins their results.
Result solve_and_join(const SolveIsland& solve, const std::vector<Island>& islands, Index n,
                      const Call& call) {
  if (islands.size() == 1) return solve(islands.front().problem, call);
  const std::vector<Result> parts = solve_apart(solve, islands, n, call);

  Result whole;
  whole.claim = Claim::solved;
  whole.z = VectorXd::Zero(n);
  const bool any_w =
      std::any_of(parts.begin(), parts.end(), [](const Result& part) { return part.w.size() > 0; });
  if (any_w) whole.w = VectorXd::Zero(n);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Result& part = parts[k];
    const std::vector<Index>& rows = islands[k].rows;
    whole.work += part.work;
    scatter(part.z, rows, whole.z);
    if (any_w) scatter(part.w, rows, whole.w);
    if (!part.message.empty())
      whole.message +=
          fmt::format("{}island {}: {}", whole.message.empty() ? "" : "; ", k, part.message);
    if (whole.claim == Claim::solved && part.claim != Claim::solved) {
      whole.claim = part.claim;
      if (part.claim == Claim::infeasible) {
        whole.certificate = VectorXd::Zero(n);
        scatter(part.certificate, rows, whole.certificate);
      }
    }
  }
  join_artificial(parts, islands, whole);
  join_basis(parts, islands, whole);
  return whole;
}

Result solve_from_previous(const SolveIsland& solve, const std::vector<Island>& islands, Index n,
                           const Call& call, const std::optional<Start>& previous) {
  Call from{.start = previous, .observer = call.observer};
  // The empty basis, not no start at all: a method that takes none is to say so here as well.
  if (!previous) from.start = Start{.alpha = {}, .z = VectorXd::Zero(n)};
  Result result = solve_and_join(solve, islands, n, from);
  if (!previous && result.claim != Claim::unsupported) {
    ++result.work.restarts;
    result.message = "no previous solution; started cold" +
                     (result.message.empty() ? "" : "; " + result.message);
  }
  return result;
}

}  // namespace

Result solve_islands(const Solver& solver, const std::vector<Island>& islands, Index n,
                     const Call& call, StartKind start, const std::optional<Start>& previous) {
  const SolveIsland solve_from = [&solver](const Problem& problem, const Call& within) {
    return solver.solve(problem, within);
  };
  if (start == StartKind::cold) return solve_and_join(solve_from, islands, n, call);

  require_no_start(call, start);
  if (start == StartKind::previous)
    return solve_from_previous(solve_from, islands, n, call, previous);

  const bool any_friction = std::any_of(islands.begin(), islands.end(), [](const Island& island) {
    return has_friction(island.problem);
  });
  if (!any_friction) {  // said once, not of each island
    Result refusal = solve_two_step(solve_from, islands.front().problem).frictional;
    refusal.z = VectorXd::Zero(n);
    return refusal;
  }
  const SolveIsland in_two_steps = [&](const Problem& problem, const Call& within) {
    if (!has_friction(problem)) return solve_from(problem, within);
    return solve_two_step(solve_from, problem, within.observer).frictional;
  };
  return solve_and_join(in_two_steps, islands, n, call);
}

Result solve_instance(const Solver& solver, const Instance& instance, const Call& call,
                      StartKind start) {
  return solve_islands(solver, split_islands(instance.problem), instance.problem.size(), call,
                       start, instance.previous);
}

}  // namespace lcp
