#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "solvers/problem.h"

namespace lcp {

/// Words and numbers of a text whose line breaks and commas mean nothing. Complaints are UnreadableInput
/// `file: line 7: 'word', expected ...`.
class Scanner {
 public:
  /// `text` must outlive the scanner.
  Scanner(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

  /// The next word without taking it; empty at the end.
  std::string_view peek();
  /// The word behind `ahead` others; empty at the end.
  std::string_view peek(int ahead);
  /// Whether there is a next word that is a number.
  bool number_follows();

  std::string_view word(const std::string& expected);
  void require(std::string_view expected);
  /// Whole number in least ... most.
  Index integer(const std::string& what, Index least, Index most);
  double number(const std::string& what);
  /// `size` numbers, after a look whether the text is long enough to hold them.
  VectorXd numbers(const std::string& what, Index size);
  /// Throws unless the rest of the text can hold so many numbers: at least one byte each and one
  /// between.
  void require_room_for(const std::string& what, Index count);
  void skip_line();

  /// Throws about the next word.
  [[noreturn]] void fail(const std::string& expected);
  template <class... Arguments>
  [[noreturn]] void fail(fmt::format_string<Arguments...> expected, Arguments&&... arguments) {
    fail(fmt::format(expected, std::forward<Arguments>(arguments)...));
  }

 private:
  void skip_blanks();
  Index line() const;

  std::string file_;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace lcp
