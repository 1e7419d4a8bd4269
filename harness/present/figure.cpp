#include "harness/present/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "harness/present/columns.h"
#include "solvers/registry.h"

namespace lcp {

namespace {

/// Okabe and Ito's, told apart by colour-blind readers too.
constexpr std::array<Colour, 7> palette_colours = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7,
                                                   0xe69f00, 0x56b4e9, 0x000000};
constexpr int markers = 6, dashes = 5;

}  // namespace

Look look_at(std::size_t k) {
  const int place = static_cast<int>(k);
  return {palette_colours[k % palette_colours.size()], place % markers, place % dashes};
}

Look look_of_solver(const std::string& row) {
  std::vector<std::string> names[2];  // own rows, peers with those that are not built in
  for (const Row& known : registry()) names[known.info.peer()].push_back(known.info.name);
  for (const AbsentPeer& absent : absent_peers()) names[1].push_back(absent.name);
  std::size_t place = 0;
  for (std::vector<std::string>& part : names) {
    std::sort(part.begin(), part.end());
    const auto found = std::find(part.begin(), part.end(), row);
    place += static_cast<std::size_t>(found - part.begin());
    if (found != part.end()) break;
  }
  return look_at(place);
}

std::vector<Look> looks_of_settings(const std::vector<std::string>& rows) {
  std::set<std::pair<Colour, int>> taken;
  std::vector<Look> looks;
  for (const std::string& row : rows) {
    Look look = look_of_solver(row);
    for (int i = 0; i < dashes && !taken.insert({look.colour, look.dash}).second; ++i)
      look.dash = (look.dash + 1) % dashes;
    looks.push_back(look);
  }
  return looks;
}

PageArea PanelGrid::area(std::size_t place) const {
  const double column = static_cast<double>(place % abreast);
  const double line = static_cast<double>(place / abreast);
  return {left_of + column * (left_of + width), width,
          top + above + line * (above + height + below), height};
}

double PanelGrid::page_width(std::size_t count) const {
  return static_cast<double>(std::min(count, abreast)) * (left_of + width) + 30;
}

double PanelGrid::page_height(std::size_t count) const {
  return top + static_cast<double>((count + abreast - 1) / abreast) * (above + height + below);
}

std::vector<Tick> round_ticks(double low, double high, std::size_t most, Axis::Scale scale) {
  std::vector<Tick> ticks;
  const auto add = [&](double at) {
    if (at >= low && at <= high) ticks.push_back({at, fmt::format("{:g}", at)});
  };
  if (scale == Axis::Scale::log) {
    const auto decades = static_cast<int>(std::ceil(std::log10(high / low))) + 1;
    std::vector<int> mantissas = {1, 2, 5};
    if (3 * decades > static_cast<int>(most) + 2) mantissas = {1};
    const double step = std::ceil(decades / std::max(1.0, static_cast<double>(most)));
    for (double decade = std::floor(std::log10(low)); decade <= std::log10(high);
         decade += mantissas.size() > 1 ? 1 : step)
      for (const int mantissa : mantissas) add(mantissa * std::pow(10, decade));
    return ticks;
  }
  const double power =
      std::pow(10, std::floor(std::log10((high - low) / static_cast<double>(most))));
  double step = 10 * power;
  for (const double try_step : {5 * power, 2 * power, power})
    if (try_step * static_cast<double>(most) >= high - low) step = try_step;
  for (double k = std::ceil(low / step); k * step <= high; ++k) add(k * step);
  return ticks;
}

nlohmann::ordered_json to_json(const Look& look) {
  return {{"colour", fmt::format("#{:06x}", look.colour)},
          {"marker", look.marker},
          {"dash", look.dash}};
}

nlohmann::ordered_json to_json(const Figure& figure) {
  using Json = nlohmann::ordered_json;
  constexpr const char* kinds[] = {"line", "points", "boxes", "area", "text"};
  constexpr const char* aligns[] = {"left", "centre", "right"};
  const auto area_json = [](const PageArea& a) { return Json{a.left, a.width, a.top, a.height}; };
  const auto axis_json = [](const Axis& axis) {
    Json ticks = Json::array();
    for (const Tick& tick : axis.ticks) ticks.push_back({tick.at, tick.label});
    return Json{{"label", axis.label}, {"low", axis.low},
                {"high", axis.high},   {"log", axis.scale == Axis::Scale::log},
                {"ticks", ticks},      {"grid", axis.grid}};
  };
  Json panels = Json::array(), legend = Json::array();
  for (const Panel& panel : figure.panels) {
    Json all = Json::array();
    for (const Series& series : panel.series) {
      Json marks = Json::array();
      for (const Mark& m : series.marks) {
        Json mark = {{"look", to_json(m.look)}, {"filled", m.filled}};
        const std::pair<const char*, double> numbers[] = {{"x", m.x},         {"y", m.y},
                                                          {"x_low", m.x_low}, {"x_high", m.x_high},
                                                          {"y_low", m.y_low}, {"y_high", m.y_high}};
        for (const auto& [name, number] : numbers)
          if (!std::isnan(number)) mark[name] = number;
        if (!m.text.empty()) mark["text"] = m.text;
        marks.push_back(std::move(mark));
      }
      all.push_back({{"kind", kinds[static_cast<int>(series.kind)]},
                     {"size", series.size},
                     {"opacity", series.opacity},
                     {"align", aligns[static_cast<int>(series.align)]},
                     {"marks", std::move(marks)}});
    }
    panels.push_back({{"area", area_json(panel.area)},
                      {"title", panel.title},
                      {"axes", panel.axes},
                      {"x", axis_json(panel.x)},
                      {"y", axis_json(panel.y)},
                      {"series", std::move(all)}});
  }
  for (const LegendEntry& entry : figure.legend)
    legend.push_back({{"name", entry.name},
                      {"look", to_json(entry.look)},
                      {"line", entry.line},
                      {"point", entry.point},
                      {"filled", entry.filled}});
  return {{"title", figure.title},
          {"caption", figure.caption},
          {"width", figure.width},
          {"height", figure.height},
          {"panels", panels},
          {"legend", legend},
          {"legend_area", area_json(figure.legend_area)}};
}

}  // namespace lcp
