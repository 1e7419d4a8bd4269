#include "harness/studies/shrink/parts.h"

#include <fmt/format.h>

#include <cstdlib>

#include "problems/contact/friction_lcp.h"
#include "problems/contact/islands.h"

namespace lcp {

namespace {

constexpr int most_digits = 17;  // That any double needs.

double rounded_to(double x, int digits) {
  return std::strtod(fmt::format("{:.{}e}", x, digits - 1).c_str(), nullptr);
}

}  // namespace

Problem keep_contacts(const Problem& problem, const std::vector<Index>& contacts) {
  Problem part = part_of_contacts(problem, contacts).problem;
  if (part.size() < problem.size()) set_contact_scales(part);
  return part;
}

bool can_halve_directions(const Problem& problem) {
  return has_friction(problem) && problem.friction->directions_per_contact % 4 == 0;
}

Problem halve_directions(const Problem& problem) {
  FrictionBlocks blocks = *problem.friction;
  const Index m = blocks.directions_per_contact;
  std::vector<bool> kept(problem.size(), true);
  std::vector<Index> directions;
  for (Index i = 0; i < blocks.contacts(); ++i)
    for (Index k = 0; k < m; ++k) {
      if (k % 2 == 0)
        directions.push_back(i * m + k);
      else if (blocks.friction_row[i] >= 0)
        kept[blocks.friction_row[i] + k] = false;
    }
  std::vector<Index> rows, place(problem.size(), -1);
  for (Index row = 0; row < problem.size(); ++row) {
    place[row] = static_cast<Index>(rows.size());
    if (kept[row]) rows.push_back(row);
  }
  Problem part = restricted(problem, rows);
  blocks.directions = blocks.directions(Eigen::all, directions).eval();
  blocks.directions_per_contact = m / 2;
  for (std::vector<Index>* list : {&blocks.normal_row, &blocks.friction_row, &blocks.cone_row})
    for (Index& row : *list)
      if (row >= 0) row = place[row];
  part.friction = std::move(blocks);
  return part;
}

Problem round_numbers(const Problem& problem, int digits) {
  Problem round = problem;
  for (double& x : round.M.reshaped()) x = rounded_to(x, digits);
  for (double& x : round.q) x = rounded_to(x, digits);
  if (round.M != problem.M || round.q != problem.q) round.friction.reset();
  return round;
}

int digits_of(const Problem& problem) {
  int digits = 1;
  const auto raise = [&digits](double x) {
    while (digits < most_digits && rounded_to(x, digits) != x) ++digits;
  };
  for (const double x : problem.M.reshaped()) raise(x);
  for (const double x : problem.q) raise(x);
  return digits;
}

}  // namespace lcp
