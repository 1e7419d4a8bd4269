#pragma once

#include "problems/io/text/scanner.h"

namespace lcp {

/// A square matrix of a Siconos file, and how it was stored there.
struct SiconosMatrix {
  MatrixXd numbers;
  Index storage = 0;
};

/// Name of a storage: what the header's 0, 1 and 2 mean.
const char* siconos_storage_name(Index storage);

/// Reads storage, rows and columns (`rows` both), and the numbers as that storage has them:
///
///     0  rows and columns again, then all numbers, COLUMN by column
///     1  blocks, block rows, block columns; where each block row ends, where each block column
///        ends; size of the two index lists; first block of each block row; block column of each
///        block; then every block's number and its numbers, column by column
///     2  kind (1 triplets, 2 columns, 3 rows), then what CSparse's cs_print prints: a title, a line of
///        sizes, and the entries, for columns under "col j : locations first to last"
///
/// Entries stored twice are added. Throws UnreadableInput.
/// Source: Siconos, numerics, NM_write_in_file, SBM_write_in_file, CSparseMatrix_print_in_file.
SiconosMatrix read_siconos_matrix(Scanner& file, Index rows);

}  // namespace lcp
