#pragma once

#include "solvers/problem.h"

namespace lcp {

/// The equilibria of a bimatrix game as an LCP in (x, y, s+, s-, t+, t-):
///
///     w_x = A y + 1 1's+ - 1 1's-,    w_s+ = 1 - 1'x,    w_s- = 1'x - 1,
///
/// and the same with B'x, t+, t- for y. Strategy x of the row player has `row_copies` rows of each of
/// the two inequalities that stand for 1'x = 1, y has `column_copies`; one of each is enough, more
/// make the problem more degenerate. A and B (rows x columns, not negative) are the costs of the row
/// and the column player. n = rows + columns + 2 (row_copies + column_copies). Scales are not set.
///
/// M is copositive: z'Mz = x'(A + B)y. If v >= 0 and Mv >= 0 then its x and y are 0 (w_s+ and w_s-
/// bound them), so that Mv >= 0 leaves 1's+ >= 1's-, 1't+ >= 1't-, hence q'v >= 0; for such q a
/// secondary ray cannot exist (R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity
/// Problem, 3.8.6 and 4.4), and Lemke with a sound rule for ties solves the problem.
Problem game_lcp(const MatrixXd& A, const MatrixXd& B, Index row_copies, Index column_copies);

/// The equilibria as M = [0 A; B' 0], q = -1 in (x, y), each strategy over the cost of the other
/// player; A and B are costs, positive. Lemke from any positive covering vector stops on a ray after
/// Step 0: the diagonal is 0 and no entry is negative, so that nothing blocks the first variable.
Problem lemke_howson_lcp(const MatrixXd& A, const MatrixXd& B);

}  // namespace lcp
