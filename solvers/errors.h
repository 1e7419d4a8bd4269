#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace lcp {

/// An exception whose message is formatted where it is thrown.
template <class Base>
struct Formatted : Base {
  explicit Formatted(const std::string& message) : Base(message) {}
  template <class... Arguments>
  explicit Formatted(fmt::format_string<Arguments...> text, Arguments&&... arguments)
      : Base(fmt::format(text, std::forward<Arguments>(arguments)...)) {}
};

/// A caller's mistake: the offending value and what was expected.
using InvalidArgument = Formatted<std::invalid_argument>;

}  // namespace lcp
