// Solves LCP(M, q), w = M z + q, with the solver whose spelling is the argument.

#include <iostream>

#include "solvers/registry.h"

int main(int, char** arguments) {
  lcp::Problem problem;
  problem.M = lcp::MatrixXd{{2, 1}, {1, 2}};
  problem.q = lcp::VectorXd{{-5, -6}};
  lcp::set_plain_scales(problem);
  const lcp::Result result = lcp::make_solver(arguments[1]).solver->solve(problem);
  const lcp::VectorXd w = problem.M * result.z + problem.q;
  std::cout << lcp::to_string(result.claim) << ", z = " << result.z.transpose() << '\n';
  const bool good = result.claim == lcp::Claim::solved && result.z.minCoeff() >= 0 &&
                    w.minCoeff() >= -1e-12 && std::abs(result.z.dot(w)) <= 1e-12;
  return good ? 0 : 1;
}
