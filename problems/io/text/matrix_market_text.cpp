#include "problems/io/text/matrix_market_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "problems/io/errors.h"
#include "problems/io/limits.h"
#include "problems/io/text/read_text.h"

namespace lcp {

namespace {

/// CHOLMOD takes what exceeds 1030 bytes of a line, even of a comment, for another line.
constexpr std::size_t longest_line = 1000;

/// The next line that is neither blank nor a comment; false at the end.
bool next_line(std::istream& lines, std::string& line) {
  while (std::getline(lines, line))
    if (!line.starts_with('%') && line.find_first_not_of(" \t\r") != std::string::npos) return true;
  return false;
}

/// The numbers of a line; empty unless it holds nothing else.
std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  const char* at = line.c_str();
  for (char* end = nullptr;; at = end) {
    const double number = std::strtod(at, &end);
    if (end == at) break;
    numbers.push_back(number);
  }
  return line.find_first_not_of(" \t\r", static_cast<std::size_t>(at - line.c_str())) ==
                 std::string::npos
             ? numbers
             : std::vector<double>{};
}

/// Whether `number` is a whole number in 1 ... last.
bool counts_up_to(double last, double number) {
  return number >= 1 && number <= last && number == std::floor(number);
}

[[noreturn]] void refuse(const std::string& path, const std::string& line,
                         const std::string& expected) {
  throw UnreadableInput(
      fmt::format("{}: line '{}', expected {}", path, line.substr(0, longest_shown), expected));
}

void check_line_lengths(const std::string& path, const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.size() > longest_line)
      refuse(path, line, fmt::format("at most {} bytes in a line", longest_line));
}

/// First line of a Matrix Market file.
struct Header {
  bool sparse;           ///< Coordinate format, not array.
  std::string symmetry;  ///< general, symmetric or skew-symmetric: what is not stored.
};

Header read_header(const std::string& path, const std::string& line) {
  std::istringstream words(line);
  std::string banner, object, format, field, symmetry;
  words >> banner >> object >> format >> field >> symmetry;
  // CHOLMOD calls a matrix of zeros a pattern without entries.
  const bool known =
      banner == "%%MatrixMarket" && object == "matrix" &&
      (format == "coordinate" || format == "array") &&
      (field == "real" || field == "integer" || field == "pattern") &&
      (symmetry == "general" || symmetry == "symmetric" || symmetry == "skew-symmetric");
  if (!known)
    refuse(path, line,
           "'%%MatrixMarket matrix coordinate|array real|integer "
           "general|symmetric|skew-symmetric'");
  return {format == "coordinate", symmetry};
}

struct DeclaredSize {
  double rows, columns, entries;  ///< Whole numbers, once checked.
};

/// Reads the size line and compares it with the limit and the length of the file, since CHOLMOD
/// allocates what it says.
DeclaredSize read_size_line(const std::string& path, const std::string& line, const Header& header,
                            std::size_t bytes) {
  const std::vector<double> sizes = numbers_of(line);
  const double largest = static_cast<double>(largest_rows);
  if (sizes.size() != (header.sparse ? 3 : 2) || !counts_up_to(largest, sizes[0]) ||
      !counts_up_to(largest, sizes[1]))
    refuse(path, line,
           fmt::format("1 ... {} rows and columns{}", largest_rows,
                       header.sparse ? " and entries" : ""));
  DeclaredSize size{sizes[0], sizes[1], sizes[0] * sizes[1]};
  if (header.symmetry == "symmetric") size.entries = size.rows * (size.rows + 1) / 2;
  if (header.symmetry == "skew-symmetric") size.entries = size.rows * (size.rows - 1) / 2;
  if (header.sparse) size.entries = sizes[2];
  if (!(size.entries >= 0 && size.entries <= static_cast<double>(bytes)))
    throw UnreadableInput(
        fmt::format("{}: declares {} entries in a file of {} bytes", path, size.entries, bytes));
  return size;
}

}  // namespace

void check_matrix_market_text(const std::string& path, const std::string& text) {
  check_line_lengths(path, text);
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const Header header = read_header(path, line);
  line.clear();
  next_line(lines, line);
  const DeclaredSize size = read_size_line(path, line, header, text.size());
  double entries = 0;
  for (; next_line(lines, line); ++entries) {
    const std::vector<double> numbers = numbers_of(line);
    if (header.sparse && (numbers.size() != 3 || !counts_up_to(size.rows, numbers[0]) ||
                          !counts_up_to(size.columns, numbers[1])))
      refuse(path, line,
             fmt::format("row 1 ... {}, column 1 ... {} and value", size.rows, size.columns));
    if (!header.sparse && numbers.size() != 1) refuse(path, line, "one value");
  }
  if (entries != size.entries)
    throw UnreadableInput(
        fmt::format("{}: holds {} entries, expected {}", path, entries, size.entries));
}

}  // namespace lcp
