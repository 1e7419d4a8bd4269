#include "harness/measure/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lcp {

namespace {

/// Puts `part` into the island's rows of `whole`; a part of another size leaves them NaN.
void scatter(const VectorXd& part, const std::vector<Index>& rows, VectorXd& whole) {
  if (part.size() == static_cast<Index>(rows.size()))
    whole(rows) = part;
  else
    whole(rows).setConstant(std::numeric_limits<double>::quiet_NaN());
}

/// The starting rows that lie in this island, in its own numbering.
Start start_within(const Start& start, const std::vector<Index>& rows) {
  Start within;
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

std::vector<Result> solve_apart(const Solver& solver, const std::vector<Island>& islands, Index n,
                                const Call& call) {
  std::vector<int> basic(n);
  std::iota(basic.begin(), basic.end(), 0);
  std::vector<Result> parts;
  for (const Island& island : islands) {
    Call within;
    if (call.start) within.start = start_within(*call.start, island.rows);
    if (call.observer) within.observer = observe_within(call.observer, island.rows, n, basic);
    parts.push_back(solver.solve(island.problem, within));
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

}  // namespace

Result solve_islands(const Solver& solver, const std::vector<Island>& islands, Index n,
                     const Call& call) {
  if (islands.size() == 1) return solver.solve(islands.front().problem, call);
  const std::vector<Result> parts = solve_apart(solver, islands, n, call);

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

Result solve_instance(const Solver& solver, const Instance& instance, const Call& call) {
  return solve_islands(solver, split_islands(instance.problem), instance.problem.size(), call);
}

}  // namespace lcp
