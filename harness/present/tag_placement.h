#pragma once

#include <vector>

namespace lcp {

/// A position or an extent on the page, in pixels.
struct Pixels {
  double x = 0;
  double y = 0;
};

struct TagBox {
  Pixels centre;
  Pixels size;
};

/// Finds a place for a small tag beside each marker so that tags hide neither markers, nor
/// `obstacles`, nor one another: each in turn takes the nearest free place around its marker, on
/// growing circles, inside [0, area.x] x [0, area.y]. Where none is free, the tag stands on the
/// innermost circle.
///
/// Returns the centres of the tags, each `tag` wide and high, in the order of `markers`.
std::vector<Pixels> place_tags(const std::vector<Pixels>& markers,
                               const std::vector<TagBox>& obstacles, Pixels area, Pixels tag);

/// Distance from a marker within which a tag needs no line that leads to it.
double nearest_tag_distance();

}  // namespace lcp
