#include "harness/present/scenes/raster.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lcp {

namespace {

constexpr Index kPerPixel = 2;                          // samples along a pixel of the image
constexpr Index kFine = Raster::sharpness * kPerPixel;  // and along one of the page
constexpr double kShared = 1;  // samples: depths that differ by less are of one surface
constexpr double kJump = 3;    // samples: a greater difference in depth is an outline
constexpr double kCrease = std::numbers::pi / 180 * 40;  // between facets: an edge
constexpr Index kLine = 2, kThin = 10;                   // samples: of an outline, and of a body
// Brightness of a line, of a face turned away from the light, and what the light adds.
constexpr double kLineShade = 0.4, kShade = 0.66, kLight = 0.4;
constexpr int kNothing = -2, kShadow = -1;  // in place of a facet
constexpr double kShadowAlpha = 24;         // of 255

std::string big_endian(std::size_t value) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

const Bytef* bytes_of(const std::string& text) {
  return reinterpret_cast<const Bytef*>(text.data());
}

std::string png_chunk(const std::string& name, const std::string& data) {
  const std::string checked = name + data;
  return big_endian(data.size()) + checked +
         big_endian(crc32_z(0, bytes_of(checked), checked.size()));
}

}  // namespace

Raster::Raster(Index width, Index height)
    : width_(kFine * width),
      height_(kFine * height),
      samples_(width_ * height_, {kNothing, -std::numeric_limits<float>::infinity()}) {}

/// Visits the samples whose centres lie in a triangle, row by row; one on a side more rather than
/// less, so that neighbours leave no gap. Corners are in pixels of the page, what is visited in
/// samples.
template <class Visit>
void Raster::for_each_sample(Triangle corners, const Visit& visit) {
  constexpr double on_side = 1e-6;
  for (Vector3d& corner : corners) corner = kFine * corner - Vector3d(0.5, 0.5, 0);
  const auto& [a, b, c] = corners;
  const auto [lowest, highest] = std::minmax({a.y(), b.y(), c.y()});
  const auto inside = [&](double at, Index end) {
    return static_cast<Index>(std::clamp<double>(std::ceil(at), 0, static_cast<double>(end)));
  };
  for (Index y = inside(lowest, height_); y < inside(highest + on_side, height_); ++y) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d &from = corners[k], &to = corners[(k + 1) % 3];
      const double share = (static_cast<double>(y) - from.y()) / (to.y() - from.y());
      if (!(share >= 0 && share <= 1)) continue;
      left = std::min(left, from.x() + share * (to.x() - from.x()));
      right = std::max(right, from.x() + share * (to.x() - from.x()));
    }
    for (Index x = inside(left - on_side, width_); x < inside(right + on_side, width_); ++x)
      visit(samples_[y * width_ + x], Vector2d(x, y) - a.head<2>());
  }
}

void Raster::add(const Triangle& corners, std::size_t body, std::uint32_t colour) {
  const auto& [a, b, c] = corners;
  const Vector3d normal = (b - a).cross(c - a).normalized();
  if (!(normal.z() > 1e-6)) return;
  const Vector2d slope = -normal.head<2>() / normal.z();
  const Vector3d source = Vector3d(0.7, 0.78, 0.69).normalized();  // of the light
  const double brightness = kShade + kLight * std::max(0.0, normal.dot(source));
  const Vector3d full(colour >> 16, colour >> 8 & 0xff, colour & 0xff);
  const int facet = static_cast<int>(facets_.size());
  facets_.push_back({normal, slope, body, (brightness * full).cwiseMin(255)});
  for_each_sample(corners, [&](Sample& sample, const Vector2d& from_a) {
    const double depth = kFine * a.z() + slope.dot(from_a);
    const bool other = sample.facet >= 0 && facets_[sample.facet].body != body;
    if (depth > sample.depth + (other ? kShared : 0)) sample = {facet, static_cast<float>(depth)};
  });
}

void Raster::add_shadow(const Triangle& corners) {
  for_each_sample(corners, [](Sample& sample, const Vector2d&) {
    if (sample.facet == kNothing) sample.facet = kShadow;
  });
}

std::optional<std::size_t> Raster::body_at(double x, double y) const {
  const Index column = static_cast<Index>(kFine * x), row = static_cast<Index>(kFine * y);
  const int facet = samples_[row * width_ + column].facet;
  return facet < 0 ? std::nullopt : std::optional(facets_[facet].body);
}

/// Whether the surface that a sample shows ends or bends before the sample at (dx, dy) from it. Of
/// two surfaces, what continues either of them in its plane is no jump.
bool Raster::changes(Index x, Index y, Index dx, Index dy) const {
  if (x + dx < 0 || x + dx >= width_ || y + dy < 0 || y + dy >= height_) return false;
  const Sample &here = samples_[y * width_ + x], &there = samples_[(y + dy) * width_ + x + dx];
  if (there.facet == here.facet) return false;
  if (there.facet < 0) return true;
  const Facet &facet = facets_[here.facet], &other = facets_[there.facet];
  const Vector2d step(dx, dy);
  const double ahead = here.depth - there.depth;
  const double one = ahead + facet.slope.dot(step), two = ahead + other.slope.dot(step);
  const double jump = std::abs(one) < std::abs(two) ? one : two;
  return jump > kJump || (jump > -kJump && facet.normal.dot(other.normal) < std::cos(kCrease));
}

/// What is thin has lines before other bodies only, or nothing else would be seen of it.
bool Raster::on_a_line(Index x, Index y) const {
  const std::size_t body = facets_[samples_[y * width_ + x].facet].body;
  const auto first_change = [&](Index samples, Index dx, Index dy) -> const Sample* {
    for (Index away = 1; away <= samples; ++away)
      if (changes(x, y, away * dx, away * dy))
        return &samples_[(y + away * dy) * width_ + x + away * dx];
    return nullptr;
  };
  for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
    const Sample* beyond = first_change(kLine, dx, dy);
    if (!beyond) continue;
    const bool before_another = beyond->facet >= 0 && facets_[beyond->facet].body != body;
    if (before_another || !first_change(kThin, -dx, -dy)) return true;
  }
  return false;
}

/// Red, green, blue, weighted by alpha, and alpha, 0 to 255.
Eigen::Vector4d Raster::light(Index x, Index y) const {
  const int facet = samples_[y * width_ + x].facet;
  if (facet < 0) return {0, 0, 0, facet == kShadow ? kShadowAlpha : 0};
  Eigen::Vector4d light;
  light << (on_a_line(x, y) ? kLineShade : 1) * facets_[facet].colour, 255;
  return light;
}

std::string Raster::png() const {
  std::string rows;
  for (Index y = height_ - kPerPixel; y >= 0; y -= kPerPixel) {
    rows += '\0';  // the row as it is, without a filter
    for (Index x = 0; x < width_; x += kPerPixel) {
      Eigen::Vector4d pixel = Eigen::Vector4d::Zero();
      for (Index i = 0; i < kPerPixel * kPerPixel; ++i)
        pixel += light(x + i % kPerPixel, y + i / kPerPixel);
      pixel.head<3>() *= 255 / std::max(1.0, pixel(3));
      pixel(3) /= kPerPixel * kPerPixel;
      for (const double channel : pixel)
        rows += static_cast<char>(static_cast<unsigned char>(channel));
    }
  }
  uLongf length = compressBound(rows.size());
  std::string packed(length, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &length, bytes_of(rows), rows.size());
  packed.resize(length);
  const std::string size = big_endian(width_ / kPerPixel) + big_endian(height_ / kPerPixel);
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", size + std::string("\x08\x06\0\0\0", 5)) +
         png_chunk("IDAT", packed) + png_chunk("IEND", "");
}

}  // namespace lcp
