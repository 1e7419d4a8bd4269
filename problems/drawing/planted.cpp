#include "problems/drawing/planted.h"

#include <fmt/format.h>

#include "solvers/errors.h"

namespace lcp {

PlantedPairs planted_pairs(Index n, Index active, Index degenerate,
                           const std::function<double()>& positive, Random& random,
                           const std::string& where) {
  if (active + degenerate > n)
    throw InvalidArgument(
        "{}: active={} and degenerate={}: expected at most "
        "n={} together",
        where, active, degenerate, n);
  PlantedPairs pairs{VectorXd::Zero(n), VectorXd::Zero(n)};
  const std::vector<Index> places = random.permutation(n);
  for (Index k = 0; k < active; ++k) pairs.z(places[k]) = positive();
  for (Index k = active + degenerate; k < n; ++k) pairs.w(places[k]) = positive();
  return pairs;
}

Instance drawn_instance(const Draw& draw, Index index, Problem problem, VectorXd solution,
                        const std::string& source) {
  Instance instance = make_instance(fmt::format("{}/{:04}", draw.corpus, index), std::move(problem),
                                    {{"source", source}});
  instance.known_solution = std::move(solution);
  return instance;
}

Instance drawn_instance(const Draw& draw, Index index, const MatrixXd& M, const PlantedPairs& pairs,
                        const std::string& source) {
  Problem problem;
  problem.M = M;
  problem.q = pairs.w - M * pairs.z;
  return drawn_instance(draw, index, std::move(problem), pairs.z, source);
}

}  // namespace lcp
