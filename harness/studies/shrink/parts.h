#pragma once

#include "solvers/problem.h"

namespace lcp {

/// The friction LCP of these contacts alone (ascending), with the scales that friction_lcp gives it.
Problem keep_contacts(const Problem& problem, const std::vector<Index>& contacts);

/// Whether the contacts have friction directions of which every second one can be left out: a multiple
/// of 4 of them, since directions come in opposite pairs.
bool can_halve_directions(const Problem& problem);

/// The friction LCP with every second direction of each contact.
Problem halve_directions(const Problem& problem);

/// M and q rounded to so many significant decimal digits (17 leave a double as it is), each number by
/// itself, so that what is symmetric stays so; without friction blocks where a number changes.
Problem round_numbers(const Problem& problem, int digits);

/// The least number of significant decimal digits that every number of M and q can be written with.
int digits_of(const Problem& problem);

}  // namespace lcp
