#include "problems/io/text/matrix_market.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "problems/io/errors.h"
#include "problems/io/limits.h"
#include "problems/io/replace_file.h"
#include "problems/io/text/read_text.h"

namespace lcp {

namespace {

std::string file_of_q(const std::string& path_of_M) {
  const std::string_view ending = matrix_market_ending;
  return path_of_M.substr(0, path_of_M.size() - ending.size()) + ".q.mtx";
}

// --- reading ---

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
bool counts_up_to(Index last, double number) {
  return number >= 1 && number <= static_cast<double>(last) && number == std::floor(number);
}

/// A file that is not trusted, line by line, and the matrix that it holds.
class MatrixFile {
 public:
  explicit MatrixFile(const std::string& path)
      : path_(path), text_(read_text(path, "a Matrix Market file", longest_file)), lines_(text_) {}

  /// Reads a matrix of any storage, in full.
  MatrixXd read() {
    read_header();
    const double declared = read_sizes();
    MatrixXd matrix = MatrixXd::Zero(rows_, columns_);
    Index found = 0, i = mirrored_ < 0 ? 1 : 0, j = 0;  // the place of an entry that says none
    for (; next_line(); ++found) {
      const std::vector<double> numbers = numbers_of(line_);
      if (sparse_ && (numbers.size() != 3 || !counts_up_to(rows_, numbers[0]) ||
                      !counts_up_to(columns_, numbers[1])))
        refuse("row 1 ... {}, column 1 ... {} and value", rows_, columns_);
      if (!sparse_ && numbers.size() != 1) refuse("one value");
      if (static_cast<double>(found) >= declared) continue;
      if (sparse_) {
        i = static_cast<Index>(numbers[0]) - 1;
        j = static_cast<Index>(numbers[1]) - 1;
      }
      add(matrix, i, j, numbers.back());
      if (!sparse_ && ++i == rows_) {
        ++j;
        i = mirrored_ == 0 ? 0 : mirrored_ > 0 ? j : j + 1;
      }
    }
    if (static_cast<double>(found) != declared)
      throw UnreadableInput("{}: holds {} entries, expected {}", path_, found, declared);
    return matrix;
  }

 private:
  template <class... Arguments>
  [[noreturn]] void refuse(fmt::format_string<Arguments...> expected,
                           Arguments&&... arguments) const {
    throw UnreadableInput("{}: line '{}', expected {}", path_, line_.substr(0, longest_shown),
                          fmt::format(expected, std::forward<Arguments>(arguments)...));
  }

  /// The next line that is neither blank nor a comment; false, and an empty line, at the end.
  bool next_line() {
    while (std::getline(lines_, line_))
      if (!line_.starts_with('%') && line_.find_first_not_of(" \t\r") != std::string::npos)
        return true;
    line_.clear();
    return false;
  }

  void read_header() {
    std::getline(lines_, line_);
    std::istringstream words(line_);
    std::string banner, object, format, field, symmetry;
    words >> banner >> object >> format >> field >> symmetry;
    // Some programs call a matrix of zeros a pattern without entries.
    const bool known =
        banner == "%%MatrixMarket" && object == "matrix" &&
        (format == "coordinate" || format == "array") &&
        (field == "real" || field == "integer" || field == "pattern") &&
        (symmetry == "general" || symmetry == "symmetric" || symmetry == "skew-symmetric");
    if (!known)
      refuse(
          "'%%MatrixMarket matrix coordinate|array real|integer "
          "general|symmetric|skew-symmetric'");
    sparse_ = format == "coordinate";
    mirrored_ = symmetry == "general" ? 0 : symmetry == "symmetric" ? 1 : -1;
  }

  /// Returns the number of entries, after a comparison with the limit and the length of the file.
  double read_sizes() {
    next_line();
    const std::vector<double> sizes = numbers_of(line_);
    if (sizes.size() != (sparse_ ? 3 : 2) || !counts_up_to(largest_rows, sizes[0]) ||
        !counts_up_to(largest_rows, sizes[1]))
      refuse("1 ... {} rows and columns{}", largest_rows, sparse_ ? " and entries" : "");
    rows_ = static_cast<Index>(sizes[0]);
    columns_ = static_cast<Index>(sizes[1]);
    if (mirrored_ != 0 && rows_ != columns_)
      refuse("as many rows as columns where it is symmetric");
    const double n = sizes[0];
    const double declared = sparse_          ? sizes[2]
                            : mirrored_ == 0 ? n * sizes[1]
                            : mirrored_ > 0  ? n * (n + 1) / 2
                                             : n * (n - 1) / 2;
    if (!(declared >= 0 && declared <= static_cast<double>(text_.size())))
      throw UnreadableInput("{}: declares {} entries in a file of {} bytes", path_, declared,
                            text_.size());
    return declared;
  }

  /// Adds to an entry and to the one that is not stored; the first number keeps its sign even if it is
  /// -0.
  void add(MatrixXd& matrix, Index i, Index j, double value) const {
    const auto add_to = [](double& entry, double number) {
      entry = entry == 0 ? number : entry + number;
    };
    if (mirrored_ < 0 && i == j) refuse("nothing on the diagonal of a skew-symmetric matrix");
    add_to(matrix(i, j), value);
    if (mirrored_ != 0 && i != j) add_to(matrix(j, i), mirrored_ * value);
  }

  std::string path_;
  std::string text_;
  std::istringstream lines_;
  std::string line_;
  bool sparse_ = false;  ///< Coordinate format, not array.
  int mirrored_ = 0;     ///< What entry (j, i) is of a stored (i, j): 1 the same, -1 its negative.
  Index rows_ = 0, columns_ = 0;
};

// --- writing ---

/// Why a pair of matrices cannot hold the problem; empty when it can.
std::string reason_to_refuse(const Problem& problem) {
  if (problem.size() == 0) return "the instance is empty (n = 0)";
  if (problem.friction) return "the instance has friction blocks";
  if (problem.c.size() > 0) return "the instance has a covering vector of its own";
  if (problem.pivot_limit != 0) return "the instance has a pivot limit of its own";
  Problem plain = problem;
  set_plain_scales(plain);
  if (plain.s_z != problem.s_z || plain.s_w != problem.s_w)
    return "the instance has scales of its own";
  return "";
}

}  // namespace

Instance read_matrix_market(const std::string& path, const std::string& name) {
  const std::string path_of_q = file_of_q(path);
  Problem problem;
  problem.M = MatrixFile(path).read();
  const Index n = problem.M.rows();
  if (problem.M.cols() != n)
    throw UnreadableInput("{}: M is {} x {}, expected a square matrix", path, n, problem.M.cols());
  const MatrixXd q = MatrixFile(path_of_q).read();
  if (q.rows() != n || q.cols() != 1)
    throw UnreadableInput("{}: q is {} x {}, expected {} x 1", path_of_q, q.rows(), q.cols(), n);
  problem.q = q.col(0);
  try {
    return make_instance(name, std::move(problem), {{"file", path}});
  } catch (const std::invalid_argument& error) {
    throw UnreadableInput("{}: {}", path, error.what());
  }
}

void write_matrix_market(const std::string& path, const Instance& instance) {
  const MatrixXd& M = instance.problem.M;
  const std::string reason = reason_to_refuse(instance.problem);
  if (!reason.empty())
    throw UnwritableOutput("{}: Matrix Market cannot hold '{}': {}; write .hdf5", path,
                           instance.name, reason);
  const Index n = M.rows();
  fmt::memory_buffer entries, q;
  Index count = 0;
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      if (M(i, j) == 0 && !std::signbit(M(i, j))) continue;
      fmt::format_to(std::back_inserter(entries), "{} {} {}\n", i + 1, j + 1, M(i, j));
      ++count;
    }
  }
  for (const double number : instance.problem.q)
    fmt::format_to(std::back_inserter(q), "{}\n", number);
  const std::string banner = "%%MatrixMarket matrix ";
  replace_file(file_of_q(path),
               banner + fmt::format("array real general\n{} 1\n", n) + to_string(q));
  replace_file(path, banner + fmt::format("coordinate real general\n{} {} {}\n", n, n, count) +
                         to_string(entries));
}

}  // namespace lcp
