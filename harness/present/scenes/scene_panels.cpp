#include "harness/present/scenes/scene_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "harness/present/gnuplot_page.h"
#include "harness/present/scenes/hidden_facets.h"
#include "harness/present/scenes/painting.h"
#include "harness/present/scenes/polygons.h"

namespace lcp {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kShade = 0.66, kLight = 0.4;  // of a face turned away from the light; what it adds
constexpr unsigned kFloor = 0xf5f5f3, kShadow = 0xdededb, kEdge = 0x4a5058;

// Pixels.
constexpr double kHead = 26, kLegend = 54, kGap = 12, kLeastWidth = 540;
constexpr double kEdgeWidth = 0.9, kSeam = 0.4, kArrowHead = 9;
constexpr double kThin = 0.2;  // of a body's thickness: its edges at most

constexpr double kLongestArrow = 0.45;  // over the height of what the panels show
constexpr double kNoForce = 1e-6;       // of the largest: below, a contact counts as idle

/// The largest of 1, 2, 5 times a power of ten that is at most `value`.
double round_number(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double mantissa : {5, 2})
    if (mantissa * decade <= value) return mantissa * decade;
  return decade;
}

unsigned shaded(unsigned colour, double brightness) {
  unsigned result = 0;
  for (const int shift : {16, 8, 0}) {
    const double channel = brightness * ((colour >> shift) & 0xff);
    result |= static_cast<unsigned>(std::clamp(channel, 0.0, 255.0)) << shift;
  }
  return result;
}

/// A polygon of a data set: x, y (m), colour and number of the body.
void add_polygon(std::string& data, const Polygon& polygon, unsigned colour, std::size_t body) {
  for (const Vector2d& p : polygon)
    data += fmt::format("{:.5f} {:.5f} {} {}\n", p.x(), p.y(), colour, body);
  data += '\n';
}

}  // namespace

ScenePanels::ScenePanels(const NamedScene& scene, std::vector<Snapshot> snapshots,
                         const Layout& layout)
    : title_(scene.spelling),
      bodies_(scene_bodies(scene.setup)),
      snapshots_(std::move(snapshots)),
      layout_(layout),
      camera_(Camera::from(kDegree * layout.azimuth, layout.elevation * kDegree)) {
  if (snapshots_.empty()) throw std::invalid_argument("picture: no frame to show");
  find_surfaces();
  find_floor(has_floor(scene.setup));
  find_scales();
}

void ScenePanels::find_surfaces() {
  Eigen::AlignedBox3d links;
  for (const SceneBody& body : bodies_) surfaces_.push_back(pieces_of(body.shape.geometry));
  for (const Snapshot& snapshot : snapshots_)
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (bodies_[i].shape.link != Link::world)
        for (const Vector3d& corner : corners(i, snapshot)) links.extend(corner);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].shape = near_part(bodies_[i].shape, links);
    surfaces_[i] = pieces_of(bodies_[i].shape.geometry);
  }
}

std::vector<Vector3d> ScenePanels::corners(std::size_t body, const Snapshot& snapshot) const {
  const Pose pose = bodies_[body].in_world(snapshot);
  std::vector<Vector3d> all;
  for (const Piece& piece : surfaces_[body])
    for (const Facet& facet : piece)
      for (const Vector3d& corner : facet.corners) all.push_back(pose * corner);
  return all;
}

void ScenePanels::find_floor(bool in_the_scene) {
  Eigen::AlignedBox3d bodies;
  for (const Snapshot& snapshot : snapshots_)
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      for (const Vector3d& corner : corners(i, snapshot)) bodies.extend(corner);
  const double size = bodies.sizes().maxCoeff(), lowest = bodies.min().z();
  has_floor_ = in_the_scene && lowest > -0.05 * size && lowest < size;
  grid_ = round_number(size / 4);
  const auto on_the_grid = [&](int axis) {
    return Range{grid_ * std::floor(bodies.min()(axis) / grid_ - 0.2),
                 grid_ * std::ceil(bodies.max()(axis) / grid_ + 0.2)};
  };
  floor_x_ = on_the_grid(0);
  floor_y_ = on_the_grid(1);
}

void ScenePanels::find_scales() {
  Eigen::AlignedBox2d seen;
  for (const Snapshot& snapshot : snapshots_) {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      for (const Vector3d& corner : corners(i, snapshot)) seen.extend(camera_.flat(corner));
    if (!layout_.contacts) continue;
    for (const Snapshot::Touch& touch : snapshot.touches)
      largest_force_ = std::max(largest_force_, touch.force.norm());
  }
  if (has_floor_)
    for (const double x : {floor_x_.low, floor_x_.high})
      for (const double y : {floor_y_.low, floor_y_.high}) seen.extend(camera_.flat({x, y, 0}));
  if (largest_force_ > 0) metres_per_newton_ = kLongestArrow * seen.sizes().y() / largest_force_;
  for (const Snapshot& snapshot : snapshots_)
    for (const Snapshot::Touch& touch : snapshot.touches)
      if (layout_.contacts)
        seen.extend(camera_.flat(touch.position + metres_per_newton_ * touch.force));
  const Vector2d margin = Vector2d::Constant(0.02 * seen.sizes().maxCoeff());
  x_ = {seen.min().x() - margin.x(), seen.max().x() + margin.x()};
  y_ = {seen.min().y() - margin.y(), seen.max().y() + margin.y()};
  pixels_per_metre_ = std::min(layout_.height / y_.length(), layout_.most_width / x_.length());
  const double beside = (layout_.least_width / pixels_per_metre_ - x_.length()) / 2;
  if (beside > 0) x_ = {x_.low - beside, x_.high + beside};
}

std::size_t ScenePanels::rows() const {
  return (snapshots_.size() + layout_.most_in_a_row - 1) / layout_.most_in_a_row;
}

/// Rows are filled evenly: 6 panels of at most 5 in a row are 3 and 3.
std::size_t ScenePanels::columns() const { return (snapshots_.size() + rows() - 1) / rows(); }

double ScenePanels::width() const {
  return std::max(kLeastWidth, static_cast<double>(columns()) * (panel_width() + kGap) + kGap);
}

double ScenePanels::height() const {
  return static_cast<double>(rows()) * (kHead + panel_height()) + (layout_.contacts ? kLegend : 0);
}

std::string ScenePanels::floor(const Snapshot& snapshot) const {
  std::string data;
  if (!has_floor_) return data;
  const auto at = [&](double x, double y) { return camera_.flat({x, y, 0}); };
  add_polygon(data,
              {at(floor_x_.low, floor_y_.low), at(floor_x_.high, floor_y_.low),
               at(floor_x_.high, floor_y_.high), at(floor_x_.low, floor_y_.high)},
              kFloor, 0);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    for (const Piece& piece :
         seen_from(Vector3d::UnitZ(), surfaces_[i], bodies_[i].in_world(snapshot), i)) {
      Polygon round;
      for (const Facet& facet : piece) {
        Polygon shadow;
        for (const Vector3d& corner : facet.corners) shadow.push_back(at(corner.x(), corner.y()));
        if (facet.smooth)
          round.insert(round.end(), shadow.begin(), shadow.end());
        else
          add_polygon(data, shadow, kShadow, i);
      }
      if (!round.empty()) add_polygon(data, convex_hull(std::move(round)), kShadow, i);
    }
  return data;
}

std::string ScenePanels::grid() const {
  std::string data;
  if (!has_floor_) return data;
  const auto line = [&](double x0, double y0, double x1, double y1) {
    for (const Vector2d& p : {camera_.flat({x0, y0, 0}), camera_.flat({x1, y1, 0})})
      data += fmt::format("{:.5f} {:.5f}\n", p.x(), p.y());
    data += '\n';
  };
  for (Index i = 0; i <= std::lround(floor_x_.length() / grid_); ++i) {
    const double x = floor_x_.low + grid_ * static_cast<double>(i);
    line(x, floor_y_.low, x, floor_y_.high);
  }
  for (Index i = 0; i <= std::lround(floor_y_.length() / grid_); ++i) {
    const double y = floor_y_.low + grid_ * static_cast<double>(i);
    line(floor_x_.low, y, floor_x_.high, y);
  }
  return data;
}

unsigned ScenePanels::colour(const Facet& facet) const {
  const Vector3d light =
      (0.5 * camera_.towards_viewer + 0.8 * Vector3d::UnitZ() + 0.7 * camera_.right).normalized();
  const double brightness = kShade + kLight * std::max(0.0, facet.normal.dot(light));
  return shaded(bodies_[facet.body].colour, brightness);
}

/// Facets first: of one piece none hides the edges of another.
void ScenePanels::paint_whole(std::string& data, const Piece& piece) const {
  std::vector<Line> edges;
  Polygon all;
  for (const Facet& facet : piece) {
    const Polygon polygon = flat(facet);
    all.insert(all.end(), polygon.begin(), polygon.end());
    paint(data, facet, polygon);
    for (std::size_t k = 0; k < polygon.size(); ++k)
      if (facet.edge[k]) edges.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
  }
  // Thin bodies have thin edges, or nothing else would be seen of them.
  const double width = std::min(kEdgeWidth / pixels_per_metre_, kThin * thickness(all));
  for (const Polygon& line : strokes(std::move(edges), width))
    add_polygon(data, line, kEdge, piece.front().body);
}

/// Facets with their edges: the next facet may hide them. Cuts are stroked in the face's own
/// colour, or they would shine through as hairlines; a little short of their ends, where they would
/// break the outline.
void ScenePanels::paint_cut(std::string& data, const Piece& facets) const {
  const double line = kEdgeWidth / pixels_per_metre_;
  for (const Facet& facet : facets) {
    const Polygon corners = flat(facet);
    paint(data, facet, corners);
    for (const bool edges : {false, true})
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vector2d &a = corners[k], &b = corners[(k + 1) % corners.size()];
        if (facet.edge[k] != edges || (b - a).norm() < (edges ? 0.02 : 2) * line) continue;
        if (edges)
          add_polygon(data, stroke(a, b, line, line / 2), kEdge, facet.body);
        else if (!facet.smooth)
          add_polygon(data, stroke(a, b, 0.4 * line, -line), colour(facet), facet.body);
      }
  }
}

Polygon ScenePanels::flat(const Facet& facet) const {
  Polygon polygon;
  for (const Vector3d& corner : facet.corners) polygon.push_back(camera_.flat(corner));
  return polygon;
}

/// Round surfaces have no lines between facets, which must therefore overlap a little.
void ScenePanels::paint(std::string& data, const Facet& facet, const Polygon& polygon) const {
  add_polygon(data, facet.smooth ? widened(polygon, kSeam / pixels_per_metre_) : polygon,
              colour(facet), facet.body);
}

std::string ScenePanels::surfaces(const Snapshot& snapshot) const {
  std::vector<Piece> seen;
  std::vector<PlacedGeometry> placed;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    placed.push_back({&bodies_[i].shape.geometry, bodies_[i].in_world(snapshot)});
    for (Piece& piece : seen_from(camera_.towards_viewer, surfaces_[i], placed.back().pose, i))
      seen.push_back(std::move(piece));
  }
  drop_hidden(seen, placed);
  std::string data;
  for (const Coat& coat : painting_order(std::move(seen), camera_))
    coat.whole ? paint_whole(data, coat.facets) : paint_cut(data, coat.facets);
  return data;
}

/// Point and arrow in the picture plane (m), size of the force (N); 0 for an idle contact.
std::string ScenePanels::contacts(const Snapshot& snapshot) const {
  std::string data;
  if (!layout_.contacts) return data;
  for (const Snapshot::Touch& touch : snapshot.touches) {
    const bool acts = touch.force.norm() > kNoForce * largest_force_;
    const Vector2d at = camera_.flat(touch.position);
    const Vector2d arrow = metres_per_newton_ * camera_.flat(touch.force);
    data += fmt::format("{:.5f} {:.5f} {:.5f} {:.5f} {:.6g}\n", at.x(), at.y(), arrow.x(),
                        arrow.y(), acts ? touch.force.norm() : 0);
  }
  return data;
}

std::string ScenePanels::data() const {
  std::string all = fmt::format(
      "# {}. Picture plane in m. Of every panel: floor and shadows (x y colour body), its "
      "grid (x y), surfaces from back to front (x y colour body), contacts (x y, force as "
      "arrow dx dy, force in N)\n",
      fit_for_gnuplot(title_));
  for (const Snapshot& snapshot : snapshots_) {
    all += fmt::format("# {:.6g} s\n", snapshot.time);
    for (const std::string& set :
         {floor(snapshot), grid(), surfaces(snapshot), contacts(snapshot)}) {
      all += set.empty() ? "NaN NaN NaN NaN NaN\n" : set;  // gnuplot does not count what is empty
      all += set.ends_with("\n\n") ? "\n" : "\n\n";
    }
  }
  return all;
}

std::string ScenePanels::script(double page_width, double page_height, const Place& place) const {
  std::string out = fmt::format(R"(
unset border
unset tics
unset key
long(dx, dy) = dx * dx + dy * dy > {head:.5f} ** 2  # enough for an arrow's head
set style arrow 1 head filled size {head:.5f},18 lw 4 lc rgb '#ffffff'
set style arrow 2 head filled size {head:.5f},18 lw 1.8 lc rgb '#c8102e'
set xrange [{:.5f}:{:.5f}]
set yrange [{:.5f}:{:.5f}]
)",
                                x_.low, x_.high, y_.low, y_.high,
                                fmt::arg("head", kArrowHead / pixels_per_metre_));
  const double used = static_cast<double>(columns()) * (panel_width() + kGap) - kGap;
  for (std::size_t i = 0; i < snapshots_.size(); ++i) {
    const double left =
        (page_width - used) / 2 + static_cast<double>(i % columns()) * (panel_width() + kGap);
    const double top =
        place.top + kHead + static_cast<double>(i / columns()) * (kHead + panel_height());
    out += gnuplot_margins({left, panel_width(), top, panel_height()}, page_width, page_height);
    out += fmt::format(
        R"(set title '{name}{letter}{time:.3f} s' offset 0,-0.6 font ',13'
plot DATA index {set} using 1:2:3 with filledcurves closed fc rgb variable fs solid 1 noborder, \
     DATA index {set}+1 using 1:2 with lines lw 0.7 lc rgb '#c9c9c5', \
     DATA index {set}+2 using 1:2:3 with filledcurves closed fc rgb variable fs solid 1 noborder, \
     DATA index {set}+3 using 1:2:(long($3,$4) ? $3 : NaN):4 with vectors arrowstyle 1, \
     DATA index {set}+3 using 1:2:(long($3,$4) ? $3 : NaN):4 with vectors arrowstyle 2, \
     DATA index {set}+3 using 1:2:(long($3,$4) ? NaN : $3):4 with vectors nohead lw 1.8 lc rgb '#c8102e', \
     DATA index {set}+3 using 1:2 with points pt 7 ps 0.5 lc rgb '#ffffff', \
     DATA index {set}+3 using 1:2:($5 > 0 ? 7 : 6) with points pt variable ps 0.45 lw 0.8 lc rgb '#c8102e'
)",
        fmt::arg("name", fit_for_gnuplot(layout_.name)),
        fmt::arg("letter",
                 layout_.letters ? fmt::format("({:c}) ", 'a' + static_cast<int>(i)) : ""),
        fmt::arg("time", snapshots_[i].time),
        fmt::arg("set", place.first_set + sets_per_panel * i));
  }
  return layout_.contacts ? out + legend(page_width, page_height, place.top) : out;
}

std::string ScenePanels::legend(double page_width, double page_height, double top) const {
  std::string out =
      "unset title\n" +
      gnuplot_margins({0, page_width, top + height() - kLegend, kLegend}, page_width, page_height);
  out += fmt::format("set xrange [0:{:.0f}]\nset yrange [{:.0f}:0]\n", page_width, kLegend);
  double left = kGap;
  std::string note = "no contact carries a force";
  if (largest_force_ > 0) {
    const double newtons = round_number(largest_force_);
    const double length = newtons * metres_per_newton_ * pixels_per_metre_;
    out += fmt::format(
        "set arrow 1 from {0:.1f},18 to {1:.1f},18 head filled size {2},18 lw 1.8 lc rgb "
        "'#c8102e'\n"
        "set label 1 '{3:g} N' at {4:.1f},18 left font ',12'\n",
        left, left + length, kArrowHead, newtons, left + length + 6);
    left += length + 70;
    note = "dots: contact points, filled where a force acts";
  }
  if (has_floor_) note += fmt::format("; grid: {:g} m", grid_);
  out += fmt::format(
      "set label 2 '{}' at {:.1f},18 left font ',11' tc rgb '#555555'\n"
      "set label 3 '{}' at {:.1f},40 left noenhanced font ',11' tc rgb '#555555'\n"
      "plot NaN\nunset arrow\nunset label\n",
      note, left, fit_for_gnuplot(title_), kGap);
  return out;
}

}  // namespace lcp
