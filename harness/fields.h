#pragma once

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace lcp {

/// Structs written and read as JSON objects by a table that names each field once:
///
///     constexpr auto fields = [](auto& plan, const auto& field) {
///       field("dt", plan.dt);
///       field("seconds", plan.seconds);
///     };
///
/// What follows a field's value in the table is for other readers of it. An empty std::optional is null.

template <class Value>
inline constexpr bool is_optional = false;
template <class Value>
inline constexpr bool is_optional<std::optional<Value>> = true;

template <class Struct, class Fields>
nlohmann::json fields_to_json(const Struct& all, const Fields& fields) {
  nlohmann::json object = nlohmann::json::object();
  fields(all, [&]<class Value>(const char* name, const Value& value, const auto&...) {
    if constexpr (is_optional<Value>)
      object[name] = value ? nlohmann::json(*value) : nlohmann::json();
    else
      object[name] = value;
  });
  return object;
}

/// Throws std::invalid_argument `WHAT: field 'NAME'` where one is missing or malformed. With
/// `null_is_nan` a null is read as NaN, which JSON cannot spell.
template <class Struct, class Fields>
void fields_from_json(const nlohmann::json& object, Struct& all, const Fields& fields,
                      const std::string& what, bool null_is_nan = false) {
  fields(all, [&]<class Value>(const char* name, Value& value, const auto&...) {
    try {
      const nlohmann::json& found = object.at(name);
      if constexpr (is_optional<Value>) {
        value.reset();
        if (!found.is_null()) value = found.get<typename Value::value_type>();
        return;
      } else if constexpr (std::is_same_v<Value, double>) {
        if (null_is_nan && found.is_null()) {
          value = std::numeric_limits<double>::quiet_NaN();
          return;
        }
      }
      if constexpr (!is_optional<Value>) found.get_to(value);
    } catch (const nlohmann::json::exception&) {
      throw std::invalid_argument(fmt::format("{}: field '{}'", what, name));
    }
  });
}

}  // namespace lcp
