#pragma once

#include <functional>

#include "problems/classic_lcps.h"
#include "problems/registry.h"

namespace lcp {

/// Knobs of families that have one problem for every n. Instance k of a draw has n + k rows, so that
/// --count K shows how a method grows.
struct GrowingKnobs {
  Index n = 1;           ///< Of the first instance.
  bool permute = false;  ///< Relabel the variables at random; all that a seed changes.
};

/// n in [smallest, largest], and permute.
OptionTable growing_options(GrowingKnobs& knobs, Index smallest, Index largest);

/// of_size(n), of_size(n + 1), ...: `draw.count` of them. With permute, variable i is the one that was
/// p_i: M(p_i, p_j), q(p_i), z(p_i), each instance with a permutation p of its own. Throws
/// std::invalid_argument when the last n is above `largest`.
std::vector<Instance> growing_series(const GrowingKnobs& knobs, Index largest, const Draw& draw,
                                     const std::function<ClassicLcp(Index)>& of_size);

}  // namespace lcp
