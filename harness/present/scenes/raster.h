#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problems/rigid/spatial.h"

namespace lcp {

using Eigen::Vector2d;

/// Triangles in a picture, each sample of which shows the nearest of them (a z-buffer), whatever
/// stands in or behind another. Coordinates are in pixels of the page: x to the right and y up from
/// the lower left corner, z towards the viewer, who is far away. Lines are drawn where what is seen
/// ends before something farther, and where a surface bends sharply.
///
/// Source: E. Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces", PhD
/// thesis, University of Utah, 1974.
class Raster {
 public:
  using Triangle = std::array<Vector3d, 3>;

  /// Pixels of the image along one of the page.
  static constexpr Index sharpness = 2;

  /// Size of the page, pixels.
  Raster(Index width, Index height);

  /// Corners counterclockwise seen from outside; from inside nothing is seen. Where two bodies share
  /// a surface the one that was added first is seen. `colour` is 0xRRGGBB in full light.
  void add(const Triangle& corners, std::size_t body, std::uint32_t colour);

  /// Darkens what is seen through the picture, but no body.
  void add_shadow(const Triangle& corners);

  /// What is seen at a point of the page.
  std::optional<std::size_t> body_at(double x, double y) const;

  /// An image file (PNG), transparent where there is nothing.
  std::string png() const;

 private:
  struct Facet {
    Vector3d normal;  ///< Unit, towards the viewer.
    Vector2d slope;   ///< Depth gained per sample to the right and up.
    std::size_t body;
    Vector3d colour;  ///< Red, green, blue, in its light.
  };
  struct Sample {
    int facet;
    float depth;  ///< Samples.
  };

  template <class Visit>
  void for_each_sample(Triangle corners, const Visit& visit);
  bool changes(Index x, Index y, Index dx, Index dy) const;
  bool on_a_line(Index x, Index y) const;
  Eigen::Vector4d light(Index x, Index y) const;

  Index width_, height_;  ///< Samples.
  std::vector<Sample> samples_;
  std::vector<Facet> facets_;
};

}  // namespace lcp
