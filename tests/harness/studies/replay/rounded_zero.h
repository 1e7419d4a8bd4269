#pragma once

#include "harness/studies/laws/law_problems.h"
#include "problems/instance.h"

namespace lcp {

/// An LCP on which Lemke's rule in doubles leaves the path of exact arithmetic, by hand.
///
/// z0 enters for w_1, then z_1. Rows 2 and 3 block at once (ratio 49/49), row 2 is the lower. Then z_2
/// enters, whose column in row 3 is -1 - (-49)(-1)/(-49) = 0 exactly, but -1 + fl(1/49) 49 = -2^-53
/// in doubles, with q'_3 = 0: the least ratio, of a row that blocks nothing. The rule takes row 1, from
/// which z0 leaves: z_1 = 48 / 48.5, z_2 = 1 - z_1 / 2. The run goes on with z_3, whose column is 0: a ray.
///
/// `m32` is M_32; 0 makes that zero, 2^-52 less makes it a true -2^-52.
inline Instance rounded_zero(double m32 = 0) {
  const MatrixXd M{{0.5, 1, 0}, {-48.5, 0, 0}, {-48.5, m32, 0}};
  return make_instance("rounded-zero", plain_problem(M, VectorXd{{-1, 48, 48}}), {});
}

}  // namespace lcp
