#pragma once

#include <functional>

#include "problems/drawing/random.h"
#include "problems/registry.h"

namespace lcp {

/// z and w >= 0 with z'w = 0: what a problem q = w - M z has as a solution.
struct PlantedPairs {
  VectorXd z;
  VectorXd w;
};

/// `active` pairs with z_i = positive(), w_i = 0, `degenerate` with z_i = w_i = 0, the others with
/// w_i = positive(), in random places. Throws std::invalid_argument, with `where` in front, when
/// active + degenerate > n.
PlantedPairs planted_pairs(Index n, Index active, Index degenerate,
                           const std::function<double()>& positive, Random& random,
                           const std::string& where);

/// Instance `index` of a draw of LCPs without contacts: named after it, with plain scales, `source`
/// as provenance and its known solution.
Instance drawn_instance(const Draw& draw, Index index, Problem problem, VectorXd solution,
                        const std::string& source);

/// M with planted pairs: q = w - M z, rounded unless all of it is integer.
Instance drawn_instance(const Draw& draw, Index index, const MatrixXd& M, const PlantedPairs& pairs,
                        const std::string& source);

}  // namespace lcp
