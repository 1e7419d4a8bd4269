#include "problems/io/hdf5/fclib_local.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lcp {

namespace {

/// FCLIB's W/nz, where it does not count triplets.
enum Storage : Index { compressed_columns = -1, compressed_rows = -2 };

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

/// Reads an integer dataset that has to be in least ... most.
Index integer(const hdf5::GroupReader& group, const std::string& name, Index least, Index most) {
  const Index found = group.integer(name);
  if (found < least || found > most)
    group.fail(name, least == most ? fmt::format("is {}, expected {}", found, least)
                                   : fmt::format("is {}, expected {} ... {}", found, least, most));
  return found;
}

void require_place(const hdf5::GroupReader& group, const char* name, Index k, Index found,
                   Index rows) {
  if (found >= 0 && found < rows) return;
  group.fail(name, "entry {} is {}, expected 0 ... {}", k, found, rows - 1);
}

/// Adds to an entry; the first number keeps its sign even if it is -0.
void add(double& entry, double number) { entry = entry == 0 ? number : entry + number; }

/// `stored` triplets (i, p, x); x may be longer, as nzmax allows.
MatrixXd read_triplets(const hdf5::GroupReader& group, Index rows, Index stored, Index nzmax) {
  const std::vector<Index> row = group.integers("i", stored), column = group.integers("p", stored);
  const VectorXd value = group.vector_up_to("x", std::max(stored, nzmax));
  if (value.size() < stored) group.fail("x", "is {}, expected at least {}", value.size(), stored);
  MatrixXd matrix = MatrixXd::Zero(rows, rows);
  for (Index k = 0; k < stored; ++k) {
    require_place(group, "i", k, row[k], rows);
    require_place(group, "p", k, column[k], rows);
    add(matrix(row[k], column[k]), value(k));
  }
  return matrix;
}

/// The transpose of what is stored in compressed rows, or what is stored in compressed columns.
MatrixXd read_compressed(const hdf5::GroupReader& group, Index rows, Index nzmax) {
  const std::vector<Index> begin = group.integers("p", rows + 1);
  const std::vector<Index> inner = group.integers("i", nzmax);
  const VectorXd value = group.vector("x", nzmax);
  if (begin.front() != 0 || begin.back() > nzmax)
    group.fail("p", "goes from {} to {}, expected from 0 to at most {}", begin.front(),
               begin.back(), nzmax);
  MatrixXd matrix = MatrixXd::Zero(rows, rows);
  for (Index j = 0; j < rows; ++j) {
    if (begin[j] > begin[j + 1] || begin[j + 1] > nzmax)
      group.fail("p", "entry {} is {} behind {}, expected ascending numbers up to {}", j + 1,
                 begin[j + 1], begin[j], nzmax);
    for (Index k = begin[j]; k < begin[j + 1]; ++k) {
      require_place(group, "i", k, inner[k], rows);
      add(matrix(inner[k], j), value(k));
    }
  }
  return matrix;
}

/// Reads W (rows x rows) and says how it was stored.
MatrixXd read_matrix(const hdf5::GroupReader& group, Index rows, std::string& storage) {
  const Index most = rows * rows;
  const Index nz = integer(group, "nz", compressed_rows, most);
  integer(group, "m", rows, rows);
  integer(group, "n", rows, rows);
  const Index nzmax = integer(group, "nzmax", 0, most);
  storage = nz == compressed_rows      ? "compressed rows"
            : nz == compressed_columns ? "compressed columns"
                                       : "triplets";
  if (nz >= 0) return read_triplets(group, rows, nz, nzmax);
  MatrixXd matrix = read_compressed(group, rows, nzmax);
  if (nz == compressed_rows) matrix.transposeInPlace();
  return matrix;
}

}  // namespace

void write_fclib_local(H5::Group& parent, const FrictionBlocks& blocks) {
  H5::Group group = parent.createGroup("fclib_local");
  hdf5::write(group, "spacedim", std::vector<int>{space_dimension});
  H5::Group matrix = group.createGroup("W");
  write_compressed_rows(matrix, blocks.W);
  H5::Group vectors = group.createGroup("vectors");
  hdf5::write(vectors, "q", blocks.vbar);
  hdf5::write(vectors, "mu", blocks.mu);
}

FclibLocal read_fclib_local(const hdf5::GroupReader& parent, Index most_contacts) {
  const hdf5::GroupReader group = parent.group("fclib_local");
  FclibLocal problem;
  LocalContacts& local = problem.contacts;
  local.dimension = integer(group, "spacedim", 2, space_dimension);
  for (const char* block : {"V", "R"})
    if (group.has(block)) group.fail(block, "is an equality block, expected contacts only");
  const hdf5::GroupReader vectors = group.group("vectors");
  local.mu = vectors.vector("mu");
  const Index contacts = local.mu.size();
  if (contacts > most_contacts)
    vectors.fail("mu", "has {} contacts, expected at most {}", contacts, most_contacts);
  local.q = vectors.vector("q", local.dimension * contacts);
  local.W = read_matrix(group.group("W"), local.dimension * contacts, problem.storage);
  return problem;
}

}  // namespace lcp
