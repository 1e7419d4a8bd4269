#include "problems/io/text/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "problems/io/errors.h"
#include "problems/io/text/read_text.h"

namespace lcp {

namespace {

/// What separates words; CSparse prints commas.
constexpr std::string_view blanks = " \t\r\n\v\f,";

/// Reads all of `word`, a leading '+' allowed.
template <class Number>
bool parse(std::string_view word, Number& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, number);
  return error == std::errc() && stopped == end;
}

}  // namespace

void Scanner::skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }

std::string_view Scanner::peek() {
  skip_blanks();
  const std::size_t end = std::min(text_.find_first_of(blanks, at_), text_.size());
  return text_.substr(at_, end - at_);
}

std::string_view Scanner::peek(int ahead) {
  const std::size_t here = at_;
  for (int i = 0; i < ahead; ++i) at_ += peek().size();
  const std::string_view found = peek();
  at_ = here;
  return found;
}

bool Scanner::number_follows() {
  double number = 0;
  return parse(peek(), number);
}

std::string_view Scanner::word(const std::string& expected) {
  const std::string_view found = peek();
  if (found.empty()) fail(expected);
  at_ += found.size();
  return found;
}

void Scanner::require(std::string_view expected) {
  if (peek() != expected) fail("'{}'", expected);
  at_ += expected.size();
}

Index Scanner::integer(const std::string& what, Index least, Index most) {
  Index number = 0;
  if (!parse(peek(), number) || number < least || number > most)
    fail("{}: a whole number in {} ... {}", what, least, most);
  at_ += peek().size();
  return number;
}

double Scanner::number(const std::string& what) {
  double number = 0;
  const std::string_view found = peek();
  if (!parse(found, number) || !std::isfinite(number)) fail("{}: a finite number", what);
  at_ += found.size();
  return number;
}

VectorXd Scanner::numbers(const std::string& what, Index size) {
  require_room_for(what, size);
  VectorXd numbers(size);
  for (Index i = 0; i < size; ++i) numbers(i) = number(what);
  return numbers;
}

void Scanner::require_room_for(const std::string& what, Index count) {
  const std::size_t left = text_.size() - at_;
  if (static_cast<std::size_t>(count) > (left + 1) / 2)
    throw UnreadableInput("{}: line {}: {} bytes left, expected {} numbers of {}", file_, line(),
                          left, count, what);
}

void Scanner::skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

Index Scanner::line() const {
  return 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
}

void Scanner::fail(const std::string& expected) {
  const std::string found(peek().substr(0, longest_shown));
  const std::string what = found.empty() ? "the end of the file" : fmt::format("'{}'", found);
  throw UnreadableInput("{}: line {}: {}, expected {}", file_, line(), what, expected);
}

}  // namespace lcp
