#include "problems/io/text/siconos_matrix.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace lcp {

namespace {

enum Storage : Index { dense, blocks, compressed };
enum Kind : Index { triplets = 1, columns, rows };

MatrixXd read_dense(Scanner& file, Index size) {
  file.integer("rows again", size, size);
  file.integer("columns again", size, size);
  file.require_room_for("M", size * size);
  MatrixXd matrix(size, size);
  for (Index j = 0; j < size; ++j)
    for (Index i = 0; i < size; ++i) matrix(i, j) = file.number("M");
  return matrix;
}

/// Ends of the block rows or columns, which partition 0 ... size; the result begins with 0.
std::vector<Index> read_partition(Scanner& file, const char* what, Index parts, Index size) {
  std::vector<Index> ends{0};
  for (Index i = 0; i < parts; ++i) {
    const bool last = i + 1 == parts;
    ends.push_back(file.integer(what, last ? size : ends.back() + 1, size));
  }
  return ends;
}

MatrixXd read_blocks(Scanner& file, Index size) {
  const Index count = file.integer("number of blocks", 0, size * size);
  if (count == 0) return MatrixXd::Zero(size, size);
  const Index block_rows = file.integer("block rows", 1, size);
  const Index block_columns = file.integer("block columns", 1, size);
  const std::vector<Index> row = read_partition(file, "end of a block row", block_rows, size);
  const std::vector<Index> column =
      read_partition(file, "end of a block column", block_columns, size);
  // The last block rows may be missing from the list when they are empty.
  const Index listed = file.integer("size of the first index list", 1, block_rows + 1);
  file.integer("size of the second index list", count, count);
  file.require_room_for("the index lists", listed + count);
  std::vector<Index> first, column_of;
  for (Index i = 0; i < listed; ++i) {
    const Index least = i == 0 ? 0 : i + 1 == listed ? count : first.back();
    first.push_back(file.integer("first block of a block row", least, i == 0 ? 0 : count));
  }
  for (Index k = 0; k < count; ++k)
    column_of.push_back(file.integer("block column of a block", 0, block_columns - 1));
  MatrixXd matrix = MatrixXd::Zero(size, size);
  for (Index r = 0; r + 1 < listed; ++r) {
    for (Index k = first[r]; k < first[r + 1]; ++k) {
      file.integer("number of a block", k, k);
      const Index c = column_of[k];
      for (Index j = column[c]; j < column[c + 1]; ++j)
        for (Index i = row[r]; i < row[r + 1]; ++i) matrix(i, j) += file.number("a block");
    }
  }
  return matrix;
}

/// "1334-by-1334, nzmax: 3822 nnz: 3822", after "triplet: " for triplets; returns nnz.
Index read_sizes(Scanner& file, Index size, bool of_triplets) {
  if (of_triplets) file.require("triplet:");
  file.require(fmt::format("{}-by-{}", size, size));
  file.require("nzmax:");
  file.integer("nzmax", 0, std::numeric_limits<Index>::max());
  file.require("nnz:");
  const Index stored = file.integer("nnz", 0, size * size);
  file.skip_line();
  file.require_room_for("M", stored);
  return stored;
}

MatrixXd read_triplets(Scanner& file, Index size) {
  const Index stored = read_sizes(file, size, true);
  MatrixXd matrix = MatrixXd::Zero(size, size);
  for (Index k = 0; k < stored; ++k) {
    const Index i = file.integer("row", 0, size - 1), j = file.integer("column", 0, size - 1);
    file.require(":");
    matrix(i, j) += file.number("M");
  }
  return matrix;
}

MatrixXd read_columns(Scanner& file, Index size) {
  const Index stored = read_sizes(file, size, false);
  MatrixXd matrix = MatrixXd::Zero(size, size);
  Index read = 0;
  for (Index j = 0; j < size; ++j) {
    file.require("col");
    file.integer("column", j, j);
    for (const char* word : {":", "locations"}) file.require(word);
    file.integer("first location", read, read);
    file.require("to");
    const Index end = file.integer("last location", read - 1, stored - 1) + 1;
    for (; read < end; ++read) {
      const Index i = file.integer("row", 0, size - 1);
      file.require(":");
      matrix(i, j) += file.number("M");
    }
  }
  if (read != stored) file.fail("{} entries of M instead of {}", stored, read);
  return matrix;
}

MatrixXd read_compressed(Scanner& file, Index size) {
  const Index kind = file.integer("kind of compressed storage", triplets, rows);
  file.require("CSparse");
  file.skip_line();
  if (kind == triplets) return read_triplets(file, size);
  MatrixXd matrix = read_columns(file, size);
  if (kind == rows) matrix.transposeInPlace();
  return matrix;
}

}  // namespace

const char* siconos_storage_name(Index storage) {
  constexpr std::array names{"dense, column by column", "sparse blocks", "compressed sparse"};
  return names.at(static_cast<std::size_t>(storage));
}

SiconosMatrix read_siconos_matrix(Scanner& file, Index size) {
  SiconosMatrix matrix;
  matrix.storage = file.integer("storage of the matrix", dense, compressed);
  file.integer("rows", size, size);
  file.integer("columns", size, size);
  matrix.numbers = matrix.storage == dense    ? read_dense(file, size)
                   : matrix.storage == blocks ? read_blocks(file, size)
                                              : read_compressed(file, size);
  return matrix;
}

}  // namespace lcp
