#pragma once

#include <filesystem>

#include "harness/present/gnuplot_page.h"
#include "harness/studies/frontier/frontier.h"

namespace lcp {

/// A panel per solver: the share solved in every cell as colour and number, the 50 % line with its
/// band, and in words how many columns have none.
GnuplotPage frontier_page(const Frontier& frontier);

/// Draws it: `svg`, and .gp and .dat beside it. Throws as draw_with_gnuplot does.
void draw_frontier(const Frontier& frontier, const std::filesystem::path& svg);

}  // namespace lcp
