#include "harness/present/scenes/scene_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "harness/present/scenes/raster.h"
#include "harness/present/scenes/scene_bodies.h"

namespace lcp {

namespace {

// Pixels.
constexpr double kHead = 26, kLegend = 54, kGap = 12, kBelowRow = 10, kLeastWidth = 540;
constexpr double kArrowHead = 9;

constexpr double kLongestArrow = 0.45;  // over the height of what the panels show
constexpr double kNoForce = 1e-6;       // of the largest: below, a contact counts as idle

/// The largest of 1, 2, 5 times a power of ten that is at most `value`.
double round_number(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double mantissa : {5, 2})
    if (mantissa * decade <= value) return mantissa * decade;
  return decade;
}

/// Takes the world's axes to right, up and towards the viewer, who is far away in the direction
/// `azimuth` (degrees, from x towards y), `elevation` above the horizon.
Matrix3d seen_from(double azimuth, double elevation) {
  constexpr double degree = std::numbers::pi / 180;
  const double c = std::cos(elevation * degree), s = std::sin(elevation * degree);
  const Vector3d away(std::cos(azimuth * degree), std::sin(azimuth * degree), 0);
  Matrix3d view;
  view << -away.y(), away.x(), 0, -s * away.x(), -s * away.y(), c, c * away.x(), c * away.y(), s;
  return view;
}

/// What is drawn so far of a page.
struct Drawing {
  double width, height;  ///< Pixels.
  Raster raster{std::lround(width), std::lround(height)};
  std::string floors = {}, grids = {}, contacts = {}, labels = {};
};

void add_line(std::string& data, const std::vector<Vector3d>& points) {
  for (const Vector3d& p : points) data += fmt::format("{:.2f} {:.2f}\n", p.x(), p.y());
  data += '\n';
}

/// The panels of one scene.
class PanelRow {
 public:
  explicit PanelRow(const SceneMoments& shown);

  double width() const {  ///< Pixels.
    return std::max(kLeastWidth, columns() * (panel_.x() + kGap) + kGap);
  }
  double height() const {  ///< With titles and legend.
    return rows() * (kHead + panel_.y()) + (shown_.contacts ? kLegend : 0);
  }
  void draw(Drawing& to, double top) const;

 private:
  template <class Visit>
  void for_each_corner(const Visit& visit) const;
  void find_scale(const Eigen::AlignedBox3d& bodies);
  void draw_floor(Drawing& to, const Vector3d& corner) const;
  void draw_bodies(Drawing& to, const Vector3d& corner, const Snapshot& snapshot) const;
  void draw_legend(Drawing& to, double top) const;
  /// Pixels from the panel's lower left corner, and towards the viewer.
  Vector3d in_panel(const Vector3d& point) const { return scale_ * (view_ * point - origin_); }
  /// Rows are filled evenly: 6 panels of at most 5 in a row are 3 and 3.
  double rows() const { return std::ceil(count() / static_cast<double>(shown_.most_in_a_row)); }
  double columns() const { return std::ceil(count() / rows()); }
  double count() const { return static_cast<double>(shown_.snapshots.size()); }

  SceneMoments shown_;
  Matrix3d view_;
  std::vector<SceneBody> bodies_;
  bool has_floor_ = false;
  double grid_ = 0;               ///< Its spacing, m.
  Vector2d low_, high_;           ///< Corners of the floor, m.
  Vector3d origin_;               ///< Of a panel, right and up, m.
  Vector2d panel_;                ///< Its size, pixels.
  double scale_ = 0;              ///< Pixels per m.
  double largest_force_ = 0;      ///< N.
  double metres_per_newton_ = 0;  ///< 0 where no force acts.
};

PanelRow::PanelRow(const SceneMoments& shown)
    : shown_(shown),
      view_(seen_from(shown.azimuth, shown.elevation)),
      bodies_(scene_bodies(shown.scene->setup)) {
  if (shown.snapshots.empty()) throw std::invalid_argument("picture: no frame to show");
  for (Snapshot& snapshot : shown_.snapshots)
    if (!shown_.contacts) snapshot.touches.clear();
  Eigen::AlignedBox3d links, bodies;
  for_each_corner([&](const SceneBody& body, const Vector3d& corner) {
    if (body.link != Link::world) links.extend(corner);
  });
  for (SceneBody& body : bodies_) keep_near(body, links);
  for_each_corner([&](const SceneBody&, const Vector3d& corner) { bodies.extend(corner); });
  find_scale(bodies);
}

template <class Visit>
void PanelRow::for_each_corner(const Visit& visit) const {
  for (const Snapshot& snapshot : shown_.snapshots)
    for (const SceneBody& body : bodies_)
      for (const Vector3d& v : body.surface.vertices) visit(body, body.in_world(snapshot) * v);
}

/// Of the floor, the panels and the arrows.
void PanelRow::find_scale(const Eigen::AlignedBox3d& bodies) {
  const double size = bodies.sizes().maxCoeff(), lowest = bodies.min().z();
  has_floor_ = has_floor(shown_.scene->setup) && lowest > -0.05 * size && lowest < size;
  grid_ = round_number(size / 4);
  low_ = grid_ * (bodies.min().head<2>().array() / grid_ - 0.2).floor();
  high_ = grid_ * (bodies.max().head<2>().array() / grid_ + 0.2).ceil();
  Eigen::AlignedBox2d seen;
  const auto show = [&](const Vector3d& point) { seen.extend((view_ * point).head<2>()); };
  for_each_corner([&](const SceneBody&, const Vector3d& corner) { show(corner); });
  if (has_floor_)
    for (const double x : {low_.x(), high_.x()})
      for (const double y : {low_.y(), high_.y()}) show({x, y, 0});
  for (const Snapshot& snapshot : shown_.snapshots)
    for (const Snapshot::Touch& touch : snapshot.touches)
      largest_force_ = std::max(largest_force_, touch.force.norm());
  if (largest_force_ > 0) metres_per_newton_ = kLongestArrow * seen.sizes().y() / largest_force_;
  for (const Snapshot& snapshot : shown_.snapshots)
    for (const Snapshot::Touch& touch : snapshot.touches)
      show(touch.position + metres_per_newton_ * touch.force);
  const Vector2d shown = seen.sizes() + Vector2d::Constant(0.04 * seen.sizes().maxCoeff());
  scale_ = std::min(shown_.height / shown.y(), shown_.most_width / shown.x());
  panel_ = (scale_ * shown).cwiseMax(Vector2d(shown_.least_width, 1)).array().ceil();
  origin_ << seen.center() - panel_ / (2 * scale_), 0;
}

void PanelRow::draw(Drawing& to, double top) const {
  const double used = columns() * (panel_.x() + kGap) - kGap;
  for (std::size_t i = 0; i < shown_.snapshots.size(); ++i) {
    const double row = std::floor(static_cast<double>(i) / columns());
    const double column = static_cast<double>(i) - row * columns();
    const Vector3d corner(std::floor((to.width - used) / 2) + column * (panel_.x() + kGap),
                          to.height - top - (row + 1) * (kHead + panel_.y()), 0);
    to.labels +=
        fmt::format("set label '{}{}{:.3f} s' at {:.1f},{:.1f} center font ',13'\n",
                    fit_for_gnuplot(shown_.name),
                    shown_.letters ? fmt::format("({:c}) ", 'a' + static_cast<int>(i)) : "",
                    shown_.snapshots[i].time, corner.x() + panel_.x() / 2,
                    corner.y() + panel_.y() + kHead / 2 - 2);
    draw_floor(to, corner);
    draw_bodies(to, corner, shown_.snapshots[i]);
    for (const Snapshot::Touch& touch : shown_.snapshots[i].touches) {
      const double force = touch.force.norm();
      const Vector3d at = corner + in_panel(touch.position);
      const Vector3d arrow = scale_ * metres_per_newton_ * view_ * touch.force;
      to.contacts += fmt::format("{:.2f} {:.2f} {:.2f} {:.2f} {:.6g}\n", at.x(), at.y(), arrow.x(),
                                 arrow.y(), force > kNoForce * largest_force_ ? force : 0);
    }
  }
  if (shown_.contacts) draw_legend(to, to.height - top - height() + kLegend);
}

void PanelRow::draw_floor(Drawing& to, const Vector3d& corner) const {
  if (!has_floor_) return;
  const auto at = [&](double x, double y) -> Vector3d { return corner + in_panel({x, y, 0}); };
  add_line(to.floors, {at(low_.x(), low_.y()), at(high_.x(), low_.y()), at(high_.x(), high_.y()),
                       at(low_.x(), high_.y())});
  for (double x = low_.x(); x < high_.x() + grid_ / 2; x += grid_)
    add_line(to.grids, {at(x, low_.y()), at(x, high_.y())});
  for (double y = low_.y(); y < high_.y() + grid_ / 2; y += grid_)
    add_line(to.grids, {at(low_.x(), y), at(high_.x(), y)});
}

void PanelRow::draw_bodies(Drawing& to, const Vector3d& corner, const Snapshot& snapshot) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Pose pose = bodies_[i].in_world(snapshot);
    for (const auto& triangle : bodies_[i].surface.triangles) {
      Raster::Triangle facet, shadow;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3d vertex = pose * bodies_[i].surface.vertices[triangle[k]];
        facet[k] = corner + in_panel(vertex);
        shadow[k] = corner + in_panel({vertex.x(), vertex.y(), 0});
      }
      to.raster.add(facet, i, bodies_[i].colour);
      if (has_floor_) to.raster.add_shadow(shadow);
    }
  }
}

void PanelRow::draw_legend(Drawing& to, double top) const {
  double left = kGap;
  std::string note = "no contact carries a force";
  if (largest_force_ > 0) {
    const double newtons = round_number(largest_force_);
    const double length = newtons * metres_per_newton_ * scale_;
    to.labels += fmt::format(
        "set arrow from {0:.1f},{1:.1f} to {2:.1f},{1:.1f} head filled size {3},18 lw 1.8 lc rgb "
        "'#c8102e'\n"
        "set label '{4:g} N' at {5:.1f},{1:.1f} left font ',12'\n",
        left, top - 18, left + length, kArrowHead, newtons, left + length + 6);
    left += length + 70;
    note = "dots: contact points, filled where a force acts";
  }
  if (has_floor_) note += fmt::format("; grid: {:g} m", grid_);
  to.labels += fmt::format(
      "set label '{}' at {:.1f},{:.1f} left font ',11' tc rgb '#555555'\n"
      "set label '{}' at {:.1f},{:.1f} left noenhanced font ',11' tc rgb '#555555'\n",
      note, left, top - 18, fit_for_gnuplot(shown_.scene->spelling), kGap, top - 40);
}

/// gnuplot does not count what is empty.
std::string data_set(const std::string& title, const std::string& lines) {
  return "# " + title + '\n' + (lines.empty() ? "NaN NaN NaN NaN NaN\n" : lines) + "\n\n";
}

}  // namespace

GnuplotPage scene_page(const std::string& title, const std::vector<SceneMoments>& moments,
                       double below) {
  GnuplotPage page{.title = title, .height = below};
  std::vector<PanelRow> rows;
  for (const SceneMoments& each : moments) {
    rows.emplace_back(each);
    page.width = std::max(page.width, rows.back().width());
    page.height += rows.back().height() + (moments.size() > 1 ? kBelowRow : 0);
  }
  Drawing drawing{page.width, page.height};
  double top = 0;
  for (const PanelRow& row : rows) {
    row.draw(drawing, top);
    top += row.height() + kBelowRow;
  }
  page.image = drawing.raster.png();
  page.data =
      data_set("floors: x y, pixels of the page from its lower left corner", drawing.floors) +
      data_set("grids: x y", drawing.grids) +
      data_set("contacts: x y, force as arrow dx dy, force in N", drawing.contacts);
  page.commands = fmt::format(
      R"(unset border
unset tics
unset key
set xrange [0:{width}]
set yrange [0:{height}]
long(dx, dy) = dx * dx + dy * dy > {head} ** 2  # enough for an arrow's head
set style arrow 1 head filled size {head},18 lw 4 lc rgb '#ffffff'
set style arrow 2 head filled size {head},18 lw 1.8 lc rgb '#c8102e'
{margins}{labels}plot DATA index 0 using 1:2 with filledcurves closed fc rgb '#f5f5f3' fs solid 1 noborder, \
     DATA index 1 using 1:2 with lines lw 0.7 lc rgb '#c9c9c5', \
     IMAGE binary filetype=png origin=({half},{half}) dx={pixel} dy={pixel} with rgbalpha, \
     DATA index 2 using 1:2:(long($3,$4) ? $3 : NaN):4 with vectors arrowstyle 1, \
     DATA index 2 using 1:2:(long($3,$4) ? $3 : NaN):4 with vectors arrowstyle 2, \
     DATA index 2 using 1:2:(long($3,$4) ? NaN : $3):4 with vectors nohead lw 1.8 lc rgb '#c8102e', \
     DATA index 2 using 1:2 with points pt 7 ps 0.5 lc rgb '#ffffff', \
     DATA index 2 using 1:2:($5 > 0 ? 7 : 6) with points pt variable ps 0.45 lw 0.8 lc rgb '#c8102e'
unset label
unset arrow
)",
      fmt::arg("width", page.width), fmt::arg("height", page.height), fmt::arg("head", kArrowHead),
      fmt::arg("margins",
               gnuplot_margins({0, page.width, 0, page.height}, page.width, page.height)),
      fmt::arg("labels", drawing.labels), fmt::arg("pixel", 1.0 / Raster::sharpness),
      fmt::arg("half", 0.5 / Raster::sharpness));
  return page;
}

void draw_picture(const NamedScene& scene, const std::vector<Snapshot>& snapshots,
                  const std::filesystem::path& svg) {
  draw_with_gnuplot(svg, scene_page("A simulated scene, drawn by lcpbench simulate --picture.",
                                    {{&scene, snapshots}}));
}

}  // namespace lcp
