#include "problems/io/load.h"

int main() {
  std::vector<lcp::Instance> corpus;
  for (int k = 1; k <= 10; ++k) {
    lcp::Problem problem{.M = lcp::MatrixXd::Identity(k, k), .q = lcp::VectorXd::Constant(k, -1)};
    lcp::set_plain_scales(problem);
    corpus.push_back(lcp::make_instance("mine/" + std::to_string(k), problem, {}));
  }
  lcp::save_instances("mine.hdf5", corpus);
}
