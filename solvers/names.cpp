#include "solvers/names.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "solvers/errors.h"

namespace lcp {

std::string enum_names::spelled(std::string_view constant) {
  std::string name(constant);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::string enum_names::words(std::string_view type) {
  std::string text;
  for (const char letter : type) {
    const bool capital = letter >= 'A' && letter <= 'Z';
    if (capital && !text.empty()) text += ' ';
    text += capital ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return text;
}

void refuse_unknown(const std::string& kind, const std::string& name, const std::string& expected,
                    const std::vector<std::string>& known) {
  throw InvalidArgument("unknown {} '{}', {} {}", kind, name, expected, fmt::join(known, ", "));
}

}  // namespace lcp
