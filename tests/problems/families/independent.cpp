#include "tests/problems/families/independent.h"

#include "problems/decompositions.h"

namespace lcp::independent {

VectorXd eigenvalues(const MatrixXd& symmetric) { return symmetric_eigen(symmetric).values; }

VectorXd singular_values(const MatrixXd& M) { return small_singular_values(M); }

}  // namespace lcp::independent
