#include "problems/families/growing_series.h"

#include "problems/drawing/planted.h"
#include "solvers/errors.h"

namespace lcp {

OptionTable growing_options(GrowingKnobs& knobs, Index smallest, Index largest) {
  return {count("n", knobs.n, smallest, largest,
                "rows of the first instance; each one more than the one before"),
          flag("permute", knobs.permute, "relabel the variables at random, by seed")};
}

std::vector<Instance> growing_series(const GrowingKnobs& knobs, Index largest, const Draw& draw,
                                     const std::function<ClassicLcp(Index)>& of_size) {
  if (draw.count > largest - knobs.n + 1)
    throw InvalidArgument(
        "{}: {} instances from n={} on end at n={}: expected at most {}, so fewer or "
        "a smaller n",
        draw.corpus, draw.count, knobs.n, knobs.n + draw.count - 1, largest);
  Random random(draw.seed);
  std::vector<Instance> instances;
  for (Index k = 0; k < draw.count; ++k) {
    const ClassicLcp classic = of_size(knobs.n + k);
    Problem problem;
    problem.M = classic.M;
    problem.q = classic.q;
    problem.pivot_limit = classic.pivot_limit;
    VectorXd solution = classic.solution;
    if (knobs.permute) {
      const std::vector<Index> p = random.permutation(knobs.n + k);
      problem.M = classic.M(p, p);
      problem.q = classic.q(p);
      solution = classic.solution(p);
    }
    instances.push_back(
        drawn_instance(draw, k, std::move(problem), std::move(solution), classic.source));
  }
  return instances;
}

}  // namespace lcp
