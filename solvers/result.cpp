#include "solvers/result.h"

#include <algorithm>

namespace lcp {

Work& Work::operator+=(const Work& other) {
  pivots += other.pivots;
  path += other.path;
  nodes += other.nodes;
  generated += other.generated;
  largest_queue = std::max(largest_queue, other.largest_queue);
  replayed += other.replayed;
  factorisations += other.factorisations;
  sweeps += other.sweeps;
  start_pivots += other.start_pivots;
  restarts += other.restarts;
  frictionless_pivots += other.frictionless_pivots;
  return *this;
}

}  // namespace lcp
