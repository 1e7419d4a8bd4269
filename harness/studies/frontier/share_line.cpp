#include "harness/studies/frontier/share_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcp {

namespace {

constexpr double half = 0.5;
constexpr double infinity = std::numeric_limits<double>::infinity();

double share_of(const SharePoint& point) {
  return static_cast<double>(point.solved) / static_cast<double>(point.counted);
}

std::vector<SharePoint> counted_points(std::vector<SharePoint> points) {
  std::erase_if(points, [](const SharePoint& point) { return point.counted == 0; });
  return points;
}

/// The same column seen from its other end: falling becomes rising.
std::vector<SharePoint> mirrored(std::vector<SharePoint> points) {
  std::reverse(points.begin(), points.end());
  for (SharePoint& point : points) point.u = -point.u;
  return points;
}

/// Where the straight line from (u0, v0) to (u1, v1) is 1/2; v0 and v1 lie on different sides of
/// it.
double at_half(double u0, double v0, double u1, double v1) {
  return u0 + (u1 - u0) * (v0 - half) / (v0 - v1);
}

/// Cells that are decided, by number, in order.
std::vector<std::size_t> decided_cells(const std::vector<SharePoint>& points) {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (side_of(points[i]) != ShareSide::open) cells.push_back(i);
  return cells;
}

/// First crossing of the interpolated shares between cells `from` and `to`, which lie on different
/// sides.
double first_crossing(const std::vector<SharePoint>& points, std::size_t from, std::size_t to) {
  const bool above = share_of(points[from]) > half;
  std::size_t next = from + 1;
  while (next < to && (share_of(points[next]) > half) == above) ++next;
  return at_half(points[next - 1].u, share_of(points[next - 1]), points[next].u,
                 share_of(points[next]));
}

double squares(const std::vector<SharePoint>& points, const std::vector<double>& fit) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += static_cast<double>(points[i].counted) * std::pow(share_of(points[i]) - fit[i], 2);
  return sum;
}

/// Where a falling curve, interpolated, comes down to 1/2; minus infinity if it is never above.
double leaves_above(const std::vector<SharePoint>& points, const std::vector<double>& falling) {
  for (std::size_t i = falling.size(); i-- > 0;)
    if (falling[i] > half)
      return i + 1 == falling.size()
                 ? points[i].u
                 : at_half(points[i].u, falling[i], points[i + 1].u, falling[i + 1]);
  return -infinity;
}

/// Where it goes on down from 1/2; infinity if it is never below.
double enters_below(const std::vector<SharePoint>& points, const std::vector<double>& falling) {
  for (std::size_t i = 0; i < falling.size(); ++i)
    if (falling[i] < half)
      return i == 0 ? points[i].u
                    : at_half(points[i - 1].u, falling[i - 1], points[i].u, falling[i]);
  return infinity;
}

/// The band of a falling share.
Interval falling_band(const std::vector<SharePoint>& points) {
  std::vector<double> lower, upper;
  for (const SharePoint& point : points) {
    const Interval interval = wilson_interval(point.solved, point.counted);
    lower.push_back(interval.low);
    upper.push_back(interval.high);
  }
  for (std::size_t i = points.size() - 1; i-- > 0;) lower[i] = std::max(lower[i], lower[i + 1]);
  for (std::size_t i = 1; i < points.size(); ++i) upper[i] = std::min(upper[i], upper[i - 1]);
  const double a = leaves_above(points, lower), b = enters_below(points, upper);
  return {std::min(a, b), std::max(a, b)};  // contradicting cells, both open: the other way round
}

/// Length of the step of the grid that holds u.
double step_at(const std::vector<SharePoint>& points, double u) {
  for (std::size_t i = 1; i < points.size(); ++i)
    if (u <= points[i].u) return points[i].u - points[i - 1].u;
  return 0;
}

/// Of a falling share: the cells whose side no decided one implies, between the two that do.
std::vector<SharePoint> cells_in_question(const std::vector<SharePoint>& points) {
  std::size_t begin = 0, last = points.size() - 1;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (side_of(points[i]) == ShareSide::above) begin = i;
  for (std::size_t i = points.size(); i-- > 0;)
    if (side_of(points[i]) == ShareSide::below) last = i;
  return {points.begin() + static_cast<std::ptrdiff_t>(begin),
          points.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

/// The line of a share that falls.
ShareLine falling_line(const std::vector<SharePoint>& points) {
  ShareLine line;
  const std::vector<SharePoint> open = cells_in_question(points);
  const std::vector<double> fit = monotone_fit(open, false);
  const Interval band = falling_band(points);
  if (fit.front() > half && fit.back() < half) {
    line.kind = ShareLine::Kind::crossing;
    line.u = (leaves_above(open, fit) + enters_below(open, fit)) / 2;
    line.step = step_at(points, line.u);
  } else {
    line.kind = fit.back() < half ? ShareLine::Kind::below : ShareLine::Kind::above;
    line.u = line.kind == ShareLine::Kind::above ? infinity : -infinity;
  }
  line.low = std::min(band.low, line.u);
  line.high = std::max(band.high, line.u);
  return line;
}

ShareLine mirrored_back(ShareLine line) {
  line.rising = true;
  line.u = -line.u;
  line.low = -line.low;
  line.high = -line.high;
  std::swap(line.low, line.high);
  return line;
}

bool open_cell(const SharePoint& point) {
  return point.counted > 0 && side_of(point) == ShareSide::open;
}

/// Decided, but not at 99.9 %.
bool unconfirmed(const SharePoint& point) {
  return side_of(point) != ShareSide::open &&
         side_of(point, confirming_quantile) == ShareSide::open;
}

/// Whether more draws of a cell could tell more of the line.
bool in_question(const SharePoint& point, const ShareLine& line) {
  return line.kind == ShareLine::Kind::several ? unconfirmed(point) : open_cell(point);
}

/// Whether a cell outside the band of a crossing lies on the other side of 1/2 than the fit.
bool contradicts(const SharePoint& point, const ShareLine& line) {
  const bool fit_above = line.rising ? point.u > line.u : point.u < line.u;
  const bool outside = point.u < line.low || point.u > line.high;
  return outside && (share_of(point) > half) != fit_above;
}

bool overlap(const ShareLine& a, const ShareLine& b) { return a.low <= b.high && b.low <= a.high; }

}  // namespace

ShareSide side_of(const SharePoint& point, double quantile) {
  const Interval interval = wilson_interval(point.solved, point.counted, quantile);
  return interval.low > half    ? ShareSide::above
         : interval.high < half ? ShareSide::below
                                : ShareSide::open;
}

std::vector<double> monotone_fit(const std::vector<SharePoint>& points, bool rising) {
  struct Block {
    Index solved, counted;
    std::size_t cells;
    double share() const { return static_cast<double>(solved) / static_cast<double>(counted); }
  };
  std::vector<Block> blocks;
  for (const SharePoint& point : points) {
    blocks.push_back({point.solved, point.counted, 1});
    while (blocks.size() > 1) {
      const Block last = blocks.back();
      Block& before = blocks[blocks.size() - 2];
      if (rising ? before.share() <= last.share() : before.share() >= last.share()) break;
      before = {before.solved + last.solved, before.counted + last.counted,
                before.cells + last.cells};
      blocks.pop_back();
    }
  }
  std::vector<double> fit;
  for (const Block& block : blocks) fit.insert(fit.end(), block.cells, block.share());
  return fit;
}

ShareLine find_line(const std::vector<SharePoint>& all) {
  const std::vector<SharePoint> points = counted_points(all);
  if (points.empty()) return {};

  const std::vector<std::size_t> decided = decided_cells(points);
  ShareLine line;
  for (std::size_t i = 1; i < decided.size(); ++i)
    if (side_of(points[decided[i - 1]]) != side_of(points[decided[i]]))
      line.crossings.push_back(first_crossing(points, decided[i - 1], decided[i]));
  if (line.crossings.size() > 1) {
    line.kind = ShareLine::Kind::several;
    return line;
  }

  const bool rising = line.crossings.empty() ? squares(points, monotone_fit(points, true)) <
                                                   squares(points, monotone_fit(points, false))
                                             : side_of(points[decided.front()]) == ShareSide::below;
  return rising ? mirrored_back(falling_line(mirrored(points))) : falling_line(points);
}

bool settled(const ShareLine& line, const std::vector<SharePoint>& points, double width) {
  if (line.kind == ShareLine::Kind::crossing)
    return line.high - line.low <= std::max(width, line.step);
  return std::none_of(points.begin(), points.end(),
                      [&](const SharePoint& point) { return in_question(point, line); });
}

std::vector<bool> more_wanted(const ShareLine& line, const std::vector<SharePoint>& points,
                              double width) {
  const bool known = line.kind == ShareLine::Kind::crossing && settled(line, points, width);
  std::vector<bool> wanted;
  for (const SharePoint& point : points)
    wanted.push_back(in_question(point, line) && (!known || contradicts(point, line)));
  return wanted;
}

bool agree(const ShareLine& a, const std::vector<SharePoint>& points_of_a, const ShareLine& b,
           const std::vector<SharePoint>& points_of_b) {
  if (a.kind == b.kind) {
    if (a.kind == ShareLine::Kind::crossing) return a.rising == b.rising && overlap(a, b);
    return a.crossings.size() == b.crossings.size();
  }
  for (std::size_t i = 0; i < points_of_a.size(); ++i) {
    const ShareSide one = side_of(points_of_a[i]), other = side_of(points_of_b[i]);
    if (one != other && one != ShareSide::open && other != ShareSide::open) return false;
  }
  return true;
}

}  // namespace lcp
