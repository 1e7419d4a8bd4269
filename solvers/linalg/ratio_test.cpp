#include "solvers/linalg/ratio_test.h"

namespace lcp {

Blocking first_index_ratio_test(const VectorXd& q, const VectorXd& m, double pivot_tolerance) {
  Blocking least;
  for (Index i = 0; i < q.size(); ++i) {
    if (!(m(i) < -pivot_tolerance)) continue;
    const double ratio = -q(i) / m(i);
    if (least.row < 0 || ratio < least.ratio) {
      least = {i, ratio, 1};
    } else if (ratio == least.ratio) {
      ++least.tied;
    }
  }
  return least;
}

}  // namespace lcp
