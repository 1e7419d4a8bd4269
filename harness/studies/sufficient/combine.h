#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "harness/studies/sufficient/ladder.h"

namespace lcp {

/// What a model is worth beside the reference.
struct Worth {
  bool passes = false;
  double saved = 0;  ///< Of the reference's time, at most 1; negative where it costs more.
};

/// A rung that was varied alone.
struct SingleRung {
  std::size_t axis = 0, rung = 0;
  Worth worth;
};

/// Looks for rungs of several axes that pass together and save more than one alone: first, of each
/// axis that saves anything, the rung that passes and saves most, all together; where that fails,
/// from the best of them alone. To what was found a rung of an axis that is left is added, those that
/// save most first, where that passes and saves more. A saving below `noise`, a share of the time of
/// what is compared, is none; a rung that alone costs no more than that may save beside others.
///
/// Greedy, hence not the best of all combinations: `simulate` is called for each that is tried, at
/// most as often as there are rungs.
void combine(std::size_t axes, std::vector<SingleRung> singles, double noise,
             const std::function<Worth(const Rungs&)>& simulate);

}  // namespace lcp
