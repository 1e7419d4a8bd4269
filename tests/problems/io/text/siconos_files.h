#pragma once

/// Small files of Siconos, one for each kind and storage.
namespace lcp::siconos {

/// M = ((1, 3), (2, 4)).
inline constexpr const char* dense_lcp =
    "2\n0\n2\n2\n2\t2\n  1.000000e+00   2.000000e+00 \n  3 4 \n -5.0e+00  1e-300 \n\nRemark 1\n";

/// M = ((1, 3, 5), (2, 4, 6), (0, 0, 7)) in blocks of 2 + 1 rows and columns.
inline constexpr const char* block_lcp =
    "3\n1\n3\n3\n3\n2\n2\n2\t3\t\n2\t3\t\n3\n3\n0\t2\t3\t\n0\t1\t1\t\n"
    "0\n 1.0e+00\n 2\n 3\n 4\n1\n 5\n 6\n2\n 7\n -1 -1 -1\n";

/// One contact, W = ((15, -1, -2), (-1, 14, 1), (-2, 1, 16)).
inline constexpr const char* dense_contact =
    "3\n1\n\n0\n3\n3\n\n3\n3\n\n15\n-1\n-2\n\n-1\n14\n1\n\n-2\n1\n16\n\n-1\n2\n3\n\n0.1\n";
inline constexpr const char* block_contact =
    "3\n1\n1\n3\n3\n1\n1\n1\n3\t\n3\t\n2\n1\n0\t1\t\n0\t\n0\n"
    " 15\n -1\n -2\n -1\n 14\n 1\n -2\n 1\n 16\n -1.0 2.0 3.0\n 1.0e-01\n0\n";
inline constexpr const char* compressed_contact =
    "3\n1\n2\n3\n3\n2\n"
    "CSparse Version 3.1.9, May 4, 2016.  Copyright (c) Timothy A. Davis, 2006-2016\n"
    "3-by-3, nzmax: 9 nnz: 9, 1-norm: 19\n"
    "    col 0 : locations 0 to 2\n      0 : 15\n      1 : -1\n      2 : -2\n"
    "    col 1 : locations 3 to 5\n      0 : -1\n      1 : 14\n      2 : 1\n"
    "    col 2 : locations 6 to 8\n      0 : -2\n      1 : 1\n      2 : 16\n"
    " -1.0 2.0 3.0\n 1.0e-01\n1\n";

}  // namespace lcp::siconos
