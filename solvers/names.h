#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace lcp {

/// Enums are spelled as in the code, with '-' for '_': the name of Verdict::not_run is "not-run". The
/// names of an enum whose constants count from 0 are written down nowhere else; where files or the
/// command line know them, renaming a constant changes what they hold.
namespace enum_names {

/// What the compiler calls a constant, or a type; empty for a number that is no constant of its enum.
template <auto Value>
constexpr std::string_view constant() {
  std::string_view text = __PRETTY_FUNCTION__;  // ... [with auto Value = lcp::Verdict::not_run; ...
  text = text.substr(text.find("Value = ") + std::string_view("Value = ").size());
  text = text.substr(0, text.find_first_of(";]"));
  return text.front() == '(' ? std::string_view() : text.substr(text.rfind(':') + 1);
}

template <class Enum>
constexpr std::string_view type() {
  std::string_view text = __PRETTY_FUNCTION__;
  text = text.substr(text.find("Enum = ") + std::string_view("Enum = ").size());
  text = text.substr(0, text.find_first_of(";]"));
  return text.substr(text.rfind(':') + 1);
}

template <class Enum, int Count = 0>
constexpr int count() {
  if constexpr (constant<static_cast<Enum>(Count)>().empty())
    return Count;
  else
    return count<Enum, Count + 1>();
}

/// With '-' for '_'.
std::string spelled(std::string_view constant);
/// "start kind" of StartKind.
std::string words(std::string_view type);

}  // namespace enum_names

template <class Enum>
concept Enumeration = std::is_enum_v<Enum>;

/// In the order of the constants.
template <Enumeration Enum>
const std::vector<std::string>& all_names() {
  static const auto names = []<int... I>(std::integer_sequence<int, I...>) {
    return std::vector<std::string>{
        enum_names::spelled(enum_names::constant<static_cast<Enum>(I)>())...};
  }
  (std::make_integer_sequence<int, enum_names::count<Enum>()>());
  return names;
}

template <Enumeration Enum>
std::vector<Enum> all_values() {
  std::vector<Enum> values;
  for (int i = 0; i < enum_names::count<Enum>(); ++i) values.push_back(static_cast<Enum>(i));
  return values;
}

template <Enumeration Enum>
std::string to_string(Enum value) {
  return all_names<Enum>().at(static_cast<std::size_t>(value));
}

/// Throws std::invalid_argument "unknown KIND 'NAME', EXPECTED A, B, C".
[[noreturn]] void refuse_unknown(const std::string& kind, const std::string& name,
                                 const std::string& expected,
                                 const std::vector<std::string>& known);

/// The value called `name`; throws std::invalid_argument with the type (StartKind as "start kind") and
/// the list of names.
template <Enumeration Enum>
Enum from_string(const std::string& name) {
  for (const Enum value : all_values<Enum>())
    if (to_string(value) == name) return value;
  refuse_unknown(enum_names::words(enum_names::type<Enum>()), name, "expected one of",
                 all_names<Enum>());
}

}  // namespace lcp
