#pragma once

#include "solvers/problem.h"

namespace lcp {

/// What a file leaves open.
struct ReadOptions {
  /// Friction directions m of contacts that come without them: even, >= 2. Contacts in the plane
  /// have 2 whatever it says.
  Index directions = 8;
};

}  // namespace lcp
