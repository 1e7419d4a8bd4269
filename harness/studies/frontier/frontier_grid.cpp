#include "harness/studies/frontier/frontier_grid.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "problems/registry.h"

namespace lcp {

namespace {

constexpr const char* axis_form =
    "KNOB=V,V,... or KNOB=FROM..TO/N, and ,log at its end for a geometric axis";

/// One axis as it is being read; complaints name the option and what it was given.
struct AxisText {
  std::string option, text;

  [[noreturn]] void refuse(const std::string& offence) const {
    throw std::invalid_argument(
        fmt::format("{} {}: {}; expected {}", option, text, offence, axis_form));
  }

  double number(const std::string& word) const {
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
      refuse(fmt::format("'{}' is no number", word));
    return value;
  }
};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find(at, begin)) != std::string::npos; begin = end + 1)
    words.push_back(text.substr(begin, end - begin));
  words.push_back(text.substr(begin));
  return words;
}

double to_three_digits(double value) { return std::stod(fmt::format("{:.3g}", value)); }

/// The N values of FROM..TO/N.
std::vector<double> spaced(const AxisText& axis, const std::string& range, bool geometric) {
  const std::size_t dots = range.find(".."), slash = range.find('/');
  if (slash == std::string::npos || slash < dots)
    axis.refuse(fmt::format("'{}' does not say how many values", range));
  const double from = axis.number(range.substr(0, dots));
  const double to = axis.number(range.substr(dots + 2, slash - dots - 2));
  const double count = axis.number(range.substr(slash + 1));
  if (count != std::floor(count) || count < 2 || count > 1000)
    axis.refuse(fmt::format("'{}' values: an integer in [2, 1000] is allowed", count));
  if (geometric && !(from > 0 && to > 0)) axis.refuse("log takes positive values");
  std::vector<double> values;
  for (double i = 0; i < count; ++i) {
    const double part = i / (count - 1);
    values.push_back(
        to_three_digits(geometric ? from * std::pow(to / from, part) : from + (to - from) * part));
  }
  return values;
}

/// The knobs of the family of a grid; throws with the list of families.
OptionTable knobs_of(const FrontierGrid& grid) {
  const std::string name = parse_spelling(grid.family).name;
  return Catalogue<FamilyInfo, Family>::instance().find(name).make()->options();
}

}  // namespace

double KnobAxis::position(std::size_t i) const {
  return geometric ? std::log10(values[i]) : values[i];
}

double KnobAxis::value_at(double position) const {
  return geometric ? std::pow(10, position) : position;
}

KnobAxis parse_axis(const std::string& text, const std::string& option) {
  const AxisText given{option, text};
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) given.refuse("no knob with values");
  KnobAxis axis;
  axis.knob = text.substr(0, equals);
  std::vector<std::string> words = split(text.substr(equals + 1), ',');
  axis.geometric = words.back() == "log";
  if (axis.geometric) words.pop_back();
  if (words.size() == 1 && words[0].find("..") != std::string::npos) {
    axis.values = spaced(given, words[0], axis.geometric);
  } else {
    for (const std::string& word : words) axis.values.push_back(given.number(word));
  }
  if (axis.values.size() < 2) given.refuse("one value makes no axis");
  for (std::size_t i = 1; i < axis.values.size(); ++i)
    if (!(axis.values[i - 1] < axis.values[i])) given.refuse("values must ascend");
  if (axis.geometric && !(axis.values[0] > 0)) given.refuse("log takes positive values");
  return axis;
}

std::string three_digits(double value) { return shortest(to_three_digits(value)); }

std::string to_string(const KnobAxis& axis) {
  return fmt::format("{}={}{}", axis.knob, fmt::join(axis.values, ","),
                     axis.geometric ? ",log" : "");
}

std::string cell_spelling(const FrontierGrid& grid, std::size_t column, std::size_t row) {
  const bool set = !parse_spelling(grid.family).settings.empty();
  return fmt::format("{}{}{}={},{}={}", grid.family, set ? ',' : ':', grid.x.knob,
                     grid.x.values[column], grid.y.knob, grid.y.values[row]);
}

Instance draw_of_cell(const FrontierGrid& grid, std::size_t column, std::size_t row,
                      std::uint64_t seed, Index draw) {
  if (draw < 0 || draw >= most_draws)
    throw std::invalid_argument(
        fmt::format("draw {} of a cell: at most {} are possible", draw, most_draws));
  const std::uint64_t seed_of_draw =
      static_cast<std::uint64_t>(most_draws) * seed + static_cast<std::uint64_t>(draw);
  Instance instance =
      generate(cell_spelling(grid, column, row), {.count = 1, .seed = seed_of_draw}).at(0);
  instance.name = fmt::format("{}/{}", instance.provenance.at("family"), seed_of_draw);
  return instance;
}

std::optional<Index> draw_number(const std::string& instance) {
  const char* end = instance.data() + instance.size();
  std::uint64_t seed = 0;
  const auto [stop, error] = std::from_chars(instance.data() + instance.rfind('/') + 1, end, seed);
  if (error != std::errc() || stop != end) return std::nullopt;
  return static_cast<Index>(seed % static_cast<std::uint64_t>(most_draws));
}

void check_knobs(const FrontierGrid& grid) {
  const OptionTable knobs = knobs_of(grid);
  if (grid.x.knob == grid.y.knob)
    throw std::invalid_argument(
        fmt::format("--x and --y are both '{}': name two different knobs", grid.x.knob));
  const Spelling spelling = parse_spelling(grid.family);
  std::vector<std::string> names;
  for (const Option& knob : knobs) names.push_back(knob.name);
  for (const KnobAxis* axis : {&grid.x, &grid.y}) {
    if (std::find(names.begin(), names.end(), axis->knob) == names.end())
      throw std::invalid_argument(fmt::format("{} has no knob '{}', it has: {}", spelling.name,
                                              axis->knob, fmt::join(names, ", ")));
    for (const auto& [key, value] : spelling.settings)
      if (key == axis->knob)
        throw std::invalid_argument(
            fmt::format("'{}' is both an axis and set in '{}'", key, grid.family));
  }
}

std::string knob_meaning(const FrontierGrid& grid, const std::string& knob) {
  for (const Option& option : knobs_of(grid))
    if (option.name == knob) return option.doc;
  return "";
}

}  // namespace lcp
