#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "solvers/problem.h"

namespace lcp {

/// The minimising delta debugging algorithm: of `items`, for which `keeps` holds, the ones that are left
/// when taking away any part that it can do without, halves first, then quarters, down to single items.
/// Unless `keeps` changes its mind, `keeps` holds for what is returned, and does not once any single
/// item more is taken away (1-minimal). The empty list is never asked about; order is kept.
///
/// Asks at most about |items|^2 + 3 |items| times, often |items| log |items|. Source: A. Zeller, R.
/// Hildebrandt, "Simplifying and Isolating Failure-Inducing Input", IEEE TSE 28(2), 2002, fig. 5.
inline std::vector<Index> ddmin(std::vector<Index> items,
                                const std::function<bool(const std::vector<Index>&)>& keeps) {
  std::size_t parts = 2;
  while (items.size() >= 2) {
    const auto bound = [&](std::size_t part) {
      return items.begin() + static_cast<std::ptrdiff_t>(items.size() * part / parts);
    };
    std::vector<Index> smaller;
    bool is_part = false;
    for (std::size_t part = 0; part < parts && smaller.empty(); ++part) {
      const std::vector<Index> alone(bound(part), bound(part + 1));
      is_part = keeps(alone);
      if (is_part) smaller = alone;
    }
    for (std::size_t part = 0; part < parts && parts > 2 && smaller.empty(); ++part) {
      std::vector<Index> rest(items.begin(), bound(part));
      rest.insert(rest.end(), bound(part + 1), items.end());
      if (keeps(rest)) smaller = rest;
    }
    if (!smaller.empty()) {
      items = smaller;
      parts = is_part ? 2 : std::max<std::size_t>(parts - 1, 2);
    } else if (parts == items.size()) {
      break;
    } else {
      parts = std::min(items.size(), 2 * parts);
    }
  }
  return items;
}

}  // namespace lcp
