#pragma once

#include "problems/rigid/spatial.h"

namespace lcp {

/// A box that stands for a link in pictures, in the link's frame, m; or for something fixed, in the
/// world's, where `link` is Link::world.
struct LinkBox {
  Index link = 0;
  Vector3d low, high;
};

}  // namespace lcp
