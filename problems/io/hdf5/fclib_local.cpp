#include "problems/io/hdf5/fclib_local.h"

#include <fmt/format.h>

#include <cmath>

namespace lcp {

namespace {

constexpr int compressed_rows = -2;  ///< FCLIB's W/nz.
constexpr int space_dimension = 3;

void write_compressed_rows(H5::Group& group, const MatrixXd& matrix) {
  std::vector<int> begin_of_row{0}, column;
  std::vector<double> value;
  for (Index i = 0; i < matrix.rows(); ++i) {
    for (Index j = 0; j < matrix.cols(); ++j) {
      const double x = matrix(i, j);
      if (x == 0 && !std::signbit(x)) continue;
      column.push_back(static_cast<int>(j));
      value.push_back(x);
    }
    begin_of_row.push_back(static_cast<int>(column.size()));
  }
  const auto scalar = [](Index number) { return std::vector<int>{static_cast<int>(number)}; };
  hdf5::write(group, "m", scalar(matrix.rows()));
  hdf5::write(group, "n", scalar(matrix.cols()));
  hdf5::write(group, "nz", scalar(compressed_rows));
  hdf5::write(group, "nzmax", scalar(static_cast<Index>(value.size())));
  hdf5::write(group, "p", begin_of_row);
  hdf5::write(group, "i", column);
  hdf5::write(group, "x",
              VectorXd(Eigen::Map<VectorXd>(value.data(), static_cast<Index>(value.size()))));
}

/// Reads an integer dataset that can have only one value.
void require_integer(const hdf5::GroupReader& group, const std::string& name, Index expected) {
  const Index found = group.integer(name);
  if (found != expected) group.fail(name, fmt::format("is {}, expected {}", found, expected));
}

MatrixXd read_compressed_rows(const hdf5::GroupReader& group, Index rows) {
  require_integer(group, "nz", compressed_rows);
  require_integer(group, "m", rows);
  require_integer(group, "n", rows);
  const Index stored = group.integer("nzmax");
  if (stored < 0 || stored > rows * rows)
    group.fail("nzmax", fmt::format("is {}, expected 0 ... {}", stored, rows * rows));
  const std::vector<Index> begin_of_row = group.integers("p", rows + 1);
  const std::vector<Index> column = group.integers("i", stored);
  const VectorXd value = group.vector("x", stored);
  if (begin_of_row.front() != 0 || begin_of_row.back() != stored)
    group.fail("p", fmt::format("goes from {} to {}, expected from 0 to {}", begin_of_row.front(),
                                begin_of_row.back(), stored));
  MatrixXd matrix = MatrixXd::Zero(rows, rows);
  for (Index i = 0; i < rows; ++i) {
    const Index begin = begin_of_row[i], end = begin_of_row[i + 1];
    if (begin > end || end > stored)
      group.fail("p", fmt::format("row {} goes from {} to {}, expected ascending numbers up to {}",
                                  i, begin, end, stored));
    for (Index k = begin; k < end; ++k) {
      if (column[k] < 0 || column[k] >= rows)
        group.fail("i",
                   fmt::format("column {} of row {}, expected 0 ... {}", column[k], i, rows - 1));
      matrix(i, column[k]) = value(k);
    }
  }
  return matrix;
}

}  // namespace

void write_fclib_local(H5::Group& parent, const FclibLocal& problem) {
  H5::Group group = parent.createGroup("fclib_local");
  hdf5::write(group, "spacedim", std::vector<int>{space_dimension});
  H5::Group matrix = group.createGroup("W");
  write_compressed_rows(matrix, problem.W);
  H5::Group vectors = group.createGroup("vectors");
  hdf5::write(vectors, "q", problem.q);
  hdf5::write(vectors, "mu", problem.mu);
}

FclibLocal read_fclib_local(const hdf5::GroupReader& parent, Index most_contacts) {
  const hdf5::GroupReader group = parent.group("fclib_local");
  require_integer(group, "spacedim", space_dimension);
  for (const char* block : {"V", "R"})
    if (group.has(block)) group.fail(block, "is an equality block, expected contacts only");
  const hdf5::GroupReader vectors = group.group("vectors");
  FclibLocal problem;
  problem.mu = vectors.vector("mu");
  const Index contacts = problem.mu.size();
  if (contacts > most_contacts)
    vectors.fail("mu",
                 fmt::format("has {} contacts, expected at most {}", contacts, most_contacts));
  problem.q = vectors.vector("q", space_dimension * contacts);
  problem.W = read_compressed_rows(group.group("W"), space_dimension * contacts);
  return problem;
}

}  // namespace lcp
