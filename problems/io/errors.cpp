#include "problems/io/errors.h"

#include <algorithm>

namespace lcp {

std::string one_line(std::string text) {
  constexpr unsigned char first_printable = 0x20, del = 0x7F;
  const auto is_control = [](unsigned char byte) { return byte < first_printable || byte == del; };
  std::replace_if(text.begin(), text.end(), is_control, '?');
  return text;
}

}  // namespace lcp
