#include "harness/cli/quantity.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <utility>
#include <vector>

namespace lcp::cli {

namespace {

using Units = std::vector<std::pair<std::string, double>>;

/// The number before one of `units`, times what the unit stands for; at least 1, below 2^62.
std::int64_t parse(const std::string& text, const Units& units, const std::string& option) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const std::string unit(stop, end);
  std::string known;
  for (const auto& [name, factor] : units) {
    known += (known.empty() ? "" : ", ") + name;
    const double value = number * factor;
    if (error == std::errc() && unit == name && value >= 1 && value < 0x1p62)
      return static_cast<std::int64_t>(value);
  }
  throw std::invalid_argument(fmt::format(
      "{} {}: expected a positive number with one of the units {}", option, text, known));
}

}  // namespace

std::chrono::nanoseconds parse_duration(const std::string& text, const std::string& option) {
  return std::chrono::nanoseconds(parse(text, {{"ms", 1e6}, {"s", 1e9}, {"min", 60e9}}, option));
}

std::int64_t parse_bytes(const std::string& text, const std::string& option) {
  return parse(text, {{"KiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30}}, option);
}

std::string printed_duration(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace lcp::cli
