#pragma once

#include <filesystem>
#include <string>

#include "harness/present/figure.h"

namespace lcp {

/// A page that gnuplot draws on white.
struct GnuplotPage {
  std::string title = {};        ///< First line of the script: what it draws. One line.
  double width = 0, height = 0;  ///< Pixels.
  std::string commands =
      {};  ///< Between `set multiplot` and `unset multiplot`; DATA is the data's file.
  std::string data = {};
  std::string image = {};  ///< A file that the commands call IMAGE (PNG); empty: none.
};

/// Writes `svg`, and beside it the script, the data and the image it is made from (.gp, .dat, .png),
/// so that it can be restyled: `gnuplot F.gp > F.svg`. Throws UnwritableOutput where they cannot be
/// written or gnuplot is missing or fails; `svg` is then left as it was.
void draw_with_gnuplot(const std::filesystem::path& svg, const GnuplotPage& page);

/// Commands that put the next plot's axes exactly there.
std::string gnuplot_margins(const PageArea& area, double page_width, double page_height);

/// A name from elsewhere, made fit for a quoted string: gnuplot runs what stands between backquotes.
std::string fit_for_gnuplot(std::string name);

}  // namespace lcp
