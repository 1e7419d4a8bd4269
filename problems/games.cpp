#include "problems/games.h"

namespace lcp {

Problem game_lcp(const MatrixXd& A, const MatrixXd& B, Index row_copies, Index column_copies) {
  const Index m = A.rows(), k = A.cols();
  const Index y = m, s_plus = m + k, s_minus = s_plus + row_copies, t_plus = s_minus + row_copies,
              t_minus = t_plus + column_copies, n = t_minus + column_copies;
  Problem lcp;
  lcp.M = MatrixXd::Zero(n, n);
  lcp.M.block(0, y, m, k) = A;
  lcp.M.block(y, 0, k, m) = B.transpose();
  lcp.q = VectorXd::Zero(n);
  const auto require_sum_one = [&](Index strategy, Index size, Index plus, Index minus,
                                   Index copies) {
    lcp.M.block(strategy, plus, size, copies).setOnes();
    lcp.M.block(strategy, minus, size, copies).setConstant(-1);
    lcp.M.block(plus, strategy, copies, size).setConstant(-1);
    lcp.M.block(minus, strategy, copies, size).setOnes();
    lcp.q.segment(plus, copies).setOnes();
    lcp.q.segment(minus, copies).setConstant(-1);
  };
  require_sum_one(0, m, s_plus, s_minus, row_copies);
  require_sum_one(y, k, t_plus, t_minus, column_copies);
  return lcp;
}

Problem lemke_howson_lcp(const MatrixXd& A, const MatrixXd& B) {
  const Index m = A.rows(), k = A.cols();
  Problem lcp;
  lcp.M = MatrixXd::Zero(m + k, m + k);
  lcp.M.topRightCorner(m, k) = A;
  lcp.M.bottomLeftCorner(k, m) = B.transpose();
  lcp.q = VectorXd::Constant(m + k, -1);
  return lcp;
}

}  // namespace lcp
