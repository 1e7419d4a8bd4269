#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solvers/names.h"
#include "solvers/problem.h"

namespace lcp {

/// One option of a method: its name, what it means, what it accepts, and access to the field of the
/// method's options struct that holds it. A method lists each option once, in its option table; the
/// command line, `list solvers` and the records are derived from that table.
struct Option {
  std::string name;
  std::string doc;      ///< One line, with unit or scale.
  std::string accepts;  ///< Range or list of values, as printed in errors.
  std::function<std::string()> get;
  std::function<void(const std::string&)> set;  ///< Throws std::invalid_argument with the offence.
  /// Values, fast and rough to slow and exact, along which the option trades speed for accuracy;
  /// empty for options that do not.
  std::vector<std::string> accuracy_ladder;

  /// Marks this option as an accuracy option with its ladder of values.
  Option accuracy(std::vector<std::string> ladder) &&;
};

using OptionTable = std::vector<Option>;

/// A real in [min, max].
Option real(std::string name, double& field, double min, double max, std::string doc);
/// An integer in [min, max].
Option count(std::string name, Index& field, Index min, Index max, std::string doc);
/// on or off.
Option flag(std::string name, bool& field, std::string doc);
/// A real in [min, max], or `word`, which is stored as NaN.
Option real_or(std::string name, double& field, double min, double max, std::string word,
               std::string doc);
/// An integer in [min, max], or `word`, which is stored as 0.
Option count_or(std::string name, Index& field, Index min, Index max, std::string word,
                std::string doc);
/// Free text without commas.
Option text(std::string name, std::string& field, std::string doc);
/// One of `values`; `get_index` and `set_index` give access by position.
Option choice(std::string name, const std::vector<std::string>& values,
              std::function<int()> get_index, std::function<void(int)> set_index, std::string doc);
/// One of the constants of an enum, by its name.
template <Enumeration Enum>
Option choice(std::string name, Enum& field, std::string doc) {
  return choice(
      std::move(name), all_names<Enum>(), [&field] { return static_cast<int>(field); },
      [&field](int index) { field = static_cast<Enum>(index); }, std::move(doc));
}

/// `name:key=value,key=value` taken apart.
struct Spelling {
  std::string name;
  std::vector<std::pair<std::string, std::string>> settings;
};

/// Throws std::invalid_argument, saying what was expected, on a malformed or repeated setting.
Spelling parse_spelling(const std::string& text);

/// Sets every option named in `settings`; throws std::invalid_argument with the list of what is
/// allowed on an unknown key or a refused value. `owner` is named in the message.
void apply(const OptionTable& table, const Spelling& spelling, const std::string& owner);

/// `name` with the settings in which `now` differs from `defaults`, the same table with other values.
std::string full_spelling(const std::string& name, const OptionTable& now,
                          const OptionTable& defaults);

/// Shortest decimal that reads back as `value`: 1e-08, 0.5, 0.
std::string shortest(double value);

}  // namespace lcp
