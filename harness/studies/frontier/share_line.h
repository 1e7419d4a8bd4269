#pragma once

#include <optional>
#include <vector>

#include "harness/studies/wilson.h"
#include "solvers/names.h"
#include "solvers/problem.h"

namespace lcp {

/// The statistics of a frontier: where along a knob the share of instances that a solver solves
/// crosses 1/2.
///
/// A column is a row of cells at ascending positions u: the knob's value, or log10 of it on a
/// geometric axis. In cell i, k_i of n_i counted draws were solved. Between cells a share is
/// interpolated linearly in u. Nothing is drawn there, so that a line is a statement about this
/// interpolant: what the share does inside a step of the grid is not seen.
///
///   Interval   Wilson's, at 95 %, of k_i / n_i. A cell whose interval lies above or below 1/2 is
///              decided, else open. Where draws are added until a cell is decided, 95 % is nominal.
///   Several    When the decided cells, in order, change sides more than once, no monotone share
///              explains them: the share crosses several times, once between each two neighbours
///              among the decided cells that lie on different sides. Of many cells at 1/2 one in
///              twenty is decided wrongly, which is enough to invent a crossing: more draws are
///              wanted until all are decided at 99.9 %.
///   Direction  Falling or rising, as the one change of sides says; without one, as the monotone
///              fit with the smaller weighted sum of squares does, falling if they tie.
///   Fit        The monotone shares p_i in that direction with least sum n_i (k_i / n_i - p_i)^2
///              (isotonic regression, pool adjacent violators), so that a dip that noise explains
///              is no crossing. It runs over the cells whose side is not implied: of a falling
///              share from the last decided above to the first decided below, or to the end of the
///              grid.
///   Line       The u at which the fit, interpolated, is 1/2; the middle, where that is a stretch.
///              None where the fit stays on one side (1/2 itself included): above or below.
///   Band       If the share is monotone (falling, say), cell i's is at least every lower bound at
///              or after i, and at most every upper bound at or before it. The band reaches from
///              where the first of these tightened curves, interpolated, crosses 1/2 to where the
///              second does; infinite where one does not cross within the grid, and widened to hold
///              the line.
///
/// R. Barlow, D. Bartholomew, J. Bremner, H. Brunk (1972), Statistical Inference under Order
/// Restrictions. E. B. Wilson (1927), J. Amer. Statist. Assoc. 22, 209-212; R. G. Newcombe (1998),
/// Statistics in Medicine 17, 857-872 (method 3).

/// One cell of a column.
struct SharePoint {
  double u;       ///< Position; ascending.
  Index solved;   ///< k
  Index counted;  ///< n
};

enum class ShareSide { below, open, above };

/// Where a cell's interval lies from 1/2.
ShareSide side_of(const SharePoint& point, double quantile = normal_quantile);

/// The weighted least-squares fit of the shares that never falls (`rising`) or never rises. Points
/// with nothing counted are not allowed.
std::vector<double> monotone_fit(const std::vector<SharePoint>& points, bool rising);

struct ShareLine {
  enum class Kind {
    crossing,  ///< Once: at `u`.
    above,     ///< The fit is at least 1/2 in every cell.
    below,     ///< The fit is at most 1/2 in every cell.
    several,   ///< Decided cells change sides more than once: at each of `crossings`.
    nothing,   ///< No cell has a counted draw.
  };

  Kind kind = Kind::nothing;
  bool rising = false;  ///< The share as u grows; of crossing, above and below.
  double u = 0;         ///< Of the line.
  /// Band of a crossing. Of `above` and `below` it is where a line beyond the grid could still be:
  /// its finite end is inside the grid if cells at that edge are open.
  double low = 0, high = 0;
  double step = 0;  ///< Of the grid, where the line is.
  std::vector<double> crossings;
};

/// Cells without counted draws are left out.
ShareLine find_line(const std::vector<SharePoint>& points);

/// Whether a line is known as well as asked: its band no wider than `width` or than the step it
/// lies in; without a line, no cell open; of several, every decided cell decided at 99.9 % too.
bool settled(const ShareLine& line, const std::vector<SharePoint>& points, double width);

/// Per cell, whether more draws would help: the open ones while the line is not settled; once it
/// is, those outside its band whose share contradicts the fit.
std::vector<bool> more_wanted(const ShareLine& line, const std::vector<SharePoint>& points,
                              double width);

/// Whether two samples of one column agree: two lines in the same direction whose bands overlap,
/// which is to say that either lies in the other's band widened by its own; as many crossings; or,
/// of different kinds, no cell that one decides to be above and the other below.
bool agree(const ShareLine& a, const std::vector<SharePoint>& points_of_a, const ShareLine& b,
           const std::vector<SharePoint>& points_of_b);

}  // namespace lcp
