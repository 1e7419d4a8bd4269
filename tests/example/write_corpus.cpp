#include "problems/io/load.h"

int main() {
  std::vector<lcp::Instance> corpus;
  for (int k = 1; k <= 10; ++k) {
    lcp::Problem problem;
    problem.M = lcp::MatrixXd::Identity(k, k);
    problem.q = lcp::VectorXd::Constant(k, -1);
    corpus.push_back(make_instance("mine/" + std::to_string(k), problem, {}));
  }
  save_instances("mine.hdf5", corpus);
}
