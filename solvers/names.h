#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace lcp {

/// The names of an enum's values, each value once, in the order in which they are listed. What the enum
/// is called goes into messages: "verdict". An enum gets its names by a function that is found beside
/// it:
///
///     constexpr auto names_of(Claim) {
///       using enum Claim;
///       return EnumNames{"claim", std::to_array<EnumName<Claim>>({{solved, "solved"}, ...})};
///     }
template <class Enum>
using EnumName = std::pair<Enum, const char*>;

template <class Enum, std::size_t Count>
struct EnumNames {
  const char* kind;
  std::array<EnumName<Enum>, Count> rows;
};

template <class Enum>
concept NamedEnum = requires {
  names_of(Enum{});
};

/// Throws std::invalid_argument "unknown KIND 'NAME', EXPECTED A, B, C".
[[noreturn]] void refuse_unknown(const std::string& kind, const std::string& name,
                                 const std::string& expected,
                                 const std::vector<std::string>& known);

/// All values, in the order of their table.
template <NamedEnum Enum>
std::vector<Enum> all_values() {
  std::vector<Enum> values;
  for (const auto& [value, name] : names_of(Enum{}).rows) values.push_back(value);
  return values;
}

template <NamedEnum Enum>
std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& [value, name] : names_of(Enum{}).rows) names.emplace_back(name);
  return names;
}

/// "?" for what is not one of the enum's values.
template <NamedEnum Enum>
std::string to_string(Enum wanted) {
  for (const auto& [value, name] : names_of(wanted).rows)
    if (value == wanted) return name;
  return "?";
}

/// Throws std::invalid_argument with the list of names.
template <NamedEnum Enum>
Enum from_string(const std::string& wanted) {
  for (const auto& [value, name] : names_of(Enum{}).rows)
    if (name == wanted) return value;
  refuse_unknown(names_of(Enum{}).kind, wanted, "expected one of", all_names<Enum>());
}

}  // namespace lcp
