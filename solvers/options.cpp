#include "solvers/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "solvers/errors.h"

namespace lcp {

std::string shortest(double value) { return fmt::format("{}", value); }

Option Option::accuracy(std::vector<std::string> ladder) && {
  accuracy_ladder = std::move(ladder);
  return std::move(*this);
}

namespace {

template <class Number>
std::optional<Number> read_number(const std::string& word) {
  Number value{};
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const std::string& name, const std::string& word,
                         const std::string& accepts) {
  throw InvalidArgument("{}={}: expected {}", name, word, accepts);
}

template <class Number>
Option number(std::string name, Number& field, Number min, Number max, std::string doc,
              std::string accepts) {
  return {name,
          std::move(doc),
          accepts,
          [&field] { return fmt::format("{}", field); },
          [&field, name, min, max, accepts](const std::string& word) {
            const std::optional<Number> value = read_number<Number>(word);
            if (!value || !(*value >= min && *value <= max)) refuse(name, word, accepts);
            field = *value;
          },
          {}};
}

/// Lets `option` also take `word`, which is stored as `stored`.
template <class Number>
Option or_word(Option option, Number& field, Number stored, std::string word) {
  option.accepts = fmt::format("'{}' or {}", word, option.accepts);
  const auto stands_for_word = [&field, stored] {
    return stored == stored ? field == stored : field != field;
  };
  option.get = [get = option.get, stands_for_word, word] {
    return stands_for_word() ? word : get();
  };
  option.set = [set = option.set, &field, stored, word](const std::string& text) {
    if (text == word) {
      field = stored;
    } else {
      set(text);
    }
  };
  return option;
}

}  // namespace

Option real(std::string name, double& field, double min, double max, std::string doc) {
  return number<double>(std::move(name), field, min, max, std::move(doc),
                        fmt::format("a real in [{}, {}]", min, max));
}

Option count(std::string name, Index& field, Index min, Index max, std::string doc) {
  return number<Index>(std::move(name), field, min, max, std::move(doc),
                       fmt::format("an integer in [{}, {}]", min, max));
}

Option flag(std::string name, bool& field, std::string doc) {
  return choice(
      std::move(name), {"off", "on"}, [&field] { return field ? 1 : 0; },
      [&field](int index) { field = index == 1; }, std::move(doc));
}

Option real_or(std::string name, double& field, double min, double max, std::string word,
               std::string doc) {
  return or_word(real(std::move(name), field, min, max, std::move(doc)), field,
                 std::numeric_limits<double>::quiet_NaN(), std::move(word));
}

Option count_or(std::string name, Index& field, Index min, Index max, std::string word,
                std::string doc) {
  return or_word(count(std::move(name), field, min, max, std::move(doc)), field, Index{0},
                 std::move(word));
}

Option text(std::string name, std::string& field, std::string doc) {
  return {std::move(name),
          std::move(doc),
          "text without commas",
          [&field] { return field; },
          [&field](const std::string& word) { field = word; },
          {}};
}

Option choice(std::string name, const std::vector<std::string>& values,
              std::function<int()> get_index, std::function<void(int)> set_index, std::string doc) {
  std::string accepts = fmt::format("one of {}", fmt::join(values, ", "));
  return {name,
          std::move(doc),
          accepts,
          [values, get_index] { return values.at(get_index()); },
          [name, values, set_index, accepts](const std::string& word) {
            for (std::size_t i = 0; i < values.size(); ++i)
              if (values[i] == word) return set_index(static_cast<int>(i));
            refuse(name, word, accepts);
          },
          {}};
}

Spelling parse_spelling(const std::string& text) {
  const std::size_t colon = text.find(':');
  Spelling spelling{text.substr(0, colon), {}};
  if (spelling.name.empty())
    throw InvalidArgument("'{}': expected name or name:key=value,key=value", text);
  if (colon == std::string::npos) return spelling;
  std::size_t begin = colon + 1;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string setting = text.substr(begin, end - begin);
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size())
      throw InvalidArgument("'{}' in '{}': expected key=value", setting, text);
    const std::string key = setting.substr(0, equals);
    for (const auto& [known, value] : spelling.settings)
      if (known == key) throw InvalidArgument("'{}' is set twice in '{}'", key, text);
    spelling.settings.emplace_back(key, setting.substr(equals + 1));
    begin = end + 1;
  }
  return spelling;
}

void apply(const OptionTable& table, const Spelling& spelling, const std::string& owner) {
  for (const auto& [key, value] : spelling.settings) {
    const Option* found = nullptr;
    std::vector<std::string> names;
    for (const Option& option : table) {
      names.push_back(option.name);
      if (option.name == key) found = &option;
    }
    if (!found)
      throw InvalidArgument("{} has no option '{}', it has: {}", owner, key,
                            fmt::join(names, ", "));
    try {
      found->set(value);
    } catch (const std::invalid_argument& error) {
      throw InvalidArgument("{}: {}", owner, error.what());
    }
  }
}

std::string full_spelling(const std::string& name, const OptionTable& now,
                          const OptionTable& defaults) {
  std::string spelling = name;
  char separator = ':';
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i].get() == defaults[i].get()) continue;
    spelling += fmt::format("{}{}={}", separator, now[i].name, now[i].get());
    separator = ',';
  }
  return spelling;
}

}  // namespace lcp
