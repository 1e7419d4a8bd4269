#include "harness/present/scenes/raster.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "harness/present/scenes/scene_bodies.h"

namespace lcp {
namespace {

using namespace collision;

struct Body {
  Geometry geometry;
  Pose pose;
};

Pose turned(double angle, const Vector3d& axis, const Vector3d& at) {
  return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), at};
}

constexpr Index kSize = 200;  // pixels of a page, 100 to a metre, the origin in its middle

/// Seen from obliquely above.
Vector3d on_page(const Vector3d& point) {
  const Matrix3d view =
      (Eigen::AngleAxisd(-1.2, Vector3d::UnitX()) * Eigen::AngleAxisd(0.5, Vector3d::UnitZ()))
          .toRotationMatrix();
  return 100 * (view * point) + Vector3d(kSize / 2, kSize / 2, 0);
}

/// Of each body.
std::vector<std::vector<Raster::Triangle>> triangles_of(const std::vector<Body>& bodies) {
  std::vector<std::vector<Raster::Triangle>> all;
  for (const Body& body : bodies) {
    const Mesh mesh = surface_of(body.geometry);
    all.emplace_back();
    for (const auto& [a, b, c] : mesh.triangles) {
      Raster::Triangle& corners = all.back().emplace_back();
      for (int k = 0; const int vertex : {a, b, c})
        corners[k++] = on_page(body.pose * mesh.vertices[vertex]);
    }
  }
  return all;
}

Raster drawn(const std::vector<std::vector<Raster::Triangle>>& bodies) {
  Raster raster(kSize, kSize);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (const Raster::Triangle& triangle : bodies[i]) raster.add(triangle, i, 0x80a0ff);
  return raster;
}

/// How near to the viewer the triangle is at a point of the page.
std::optional<double> nearness(const Raster::Triangle& triangle, const Vector2d& at) {
  Matrix3d corners;
  for (int k = 0; k < 3; ++k) corners.col(k) << triangle[k].head<2>(), 1;
  if (std::abs(corners.determinant()) < 1e-9) return std::nullopt;
  const Vector3d weight = corners.inverse() * Vector3d(at.x(), at.y(), 1);
  if (weight.minCoeff() < 0) return std::nullopt;
  return weight.x() * triangle[0].z() + weight.y() * triangle[1].z() + weight.z() * triangle[2].z();
}

/// Looks every `step` pixels, where two bodies are not as near as one another: the nearest must be
/// seen. Returns how often each was.
std::vector<int> expect_nearest_seen(const std::vector<Body>& bodies, Index step) {
  const auto triangles = triangles_of(bodies);
  const Raster raster = drawn(triangles);
  std::vector<int> seen(bodies.size(), 0);
  for (Index i = 0; i < kSize; i += step)
    for (Index j = 0; j < kSize; j += step) {
      const Vector2d at(static_cast<double>(i) + 0.125, static_cast<double>(j) + 0.375);
      std::optional<std::size_t> nearest;
      double height = -1e9, lead = 0;
      for (std::size_t body = 0; body < bodies.size(); ++body)
        for (const Raster::Triangle& triangle : triangles[body]) {
          const std::optional<double> here = nearness(triangle, at);
          if (!here) continue;
          if (!nearest || *nearest != body) lead = std::abs(*here - height);
          if (*here < height) continue;
          nearest = body;
          height = *here;
        }
      if (nearest && lead < 0.5) continue;
      EXPECT_EQ(raster.body_at(at.x(), at.y()), nearest) << at.transpose();
      if (nearest) ++seen[*nearest];
    }
  return seen;
}

TEST(Raster, TheNearestIsSeenInAHeapOfBoxesThatPierceOneAnother) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> draw(-1, 1);
  const auto vector = [&] { return Vector3d(draw(random), draw(random), draw(random)); };
  std::vector<Body> heap;
  for (int i = 0; i < 10; ++i) {
    const Vector3d edges = 0.5 * vector().cwiseAbs() + Vector3d::Constant(0.1);
    heap.push_back({Box{edges}, turned(3 * draw(random), vector(), 0.4 * vector())});
  }
  int total = 0;
  for (const int count : expect_nearest_seen(heap, 5)) total += count;
  EXPECT_GT(total, 200);
}

TEST(Raster, ACapsuleThatPiercesABoxIsSeenOnBothSides) {
  const std::vector<int> seen = expect_nearest_seen(
      {{Box{{0.5, 0.5, 0.5}}, {}}, {Capsule{0.1, 1.2}, turned(1, {1, 0.3, 0}, {0, 0, 0})}}, 5);
  EXPECT_GT(seen[0], 20);
  EXPECT_GT(seen[1], 20);
}

TEST(Raster, RodsRoundAboutInACircleAreEachInFrontOfOne) {
  std::vector<Body> rods;
  for (int i = 0; i < 3; ++i) {
    const Pose around = turned(2 * std::numbers::pi / 3 * i, {0, 0, 1}, {0, 0, 0});
    rods.push_back({Cylinder{0.05, 1.4},
                    around * turned(std::numbers::pi / 2 - 0.25, {1, 0, 0}, {0.3, 0, 0})});
  }
  for (const int count : expect_nearest_seen(rods, 4)) EXPECT_GT(count, 20);
}

Ring circle(int corners, double radius, double wire) {
  Ring ring{.corners = {}, .radius = wire};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return ring;
}

TEST(Raster, ARingThroughAnotherLiesBeforeItHereAndBehindItThere) {
  const std::vector<Body> linked = {{circle(12, 0.5, 0.06), turned(0.3, {0, 1, 0}, {-0.25, 0, 0})},
                                    {circle(4, 0.5, 0.06), turned(1.2, {1, 0.3, 0}, {0.25, 0, 0})}};
  const Raster raster = drawn(triangles_of(linked));
  // Where the middle lines of two segments cross in the picture, the nearer one is seen.
  std::multiset<std::size_t> in_front;
  const auto corner = [&](std::size_t ring, std::size_t i) -> Vector3d {
    const std::vector<Vector3d>& corners = std::get<Ring>(linked[ring].geometry).corners;
    return on_page(linked[ring].pose * corners[i % corners.size()]);
  };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const Vector3d a = corner(0, i), u = corner(0, i + 1) - a, b = corner(1, j),
                     v = corner(1, j + 1) - b;
      Eigen::Matrix2d lines;
      lines << u.head<2>(), -v.head<2>();
      const Vector2d share = lines.inverse() * (b - a).head<2>();
      if (share.minCoeff() < 0 || share.maxCoeff() > 1) continue;
      const Vector3d first = a + share.x() * u, second = b + share.y() * v;
      const std::size_t nearer = first.z() > second.z() ? 0 : 1;
      EXPECT_EQ(raster.body_at(first.x(), first.y()), nearer) << first.transpose();
      in_front.insert(nearer);
    }
  EXPECT_GE(in_front.count(0), 1u);
  EXPECT_GE(in_front.count(1), 1u);
}

TEST(Raster, OfTwoThatShareASurfaceTheFirstIsSeen) {
  // Two capsules in a row, whose half spheres between them are one sphere.
  const Capsule capsule{0.2, 0.5};
  const auto triangles = triangles_of({{capsule, {Matrix3d::Identity(), {0, 0, -0.25}}},
                                       {capsule, turned(0.1, {0, 0, 1}, {0, 0, 0.25})}});
  Raster raster(kSize, kSize);
  for (const std::size_t body : {1, 0})
    for (const Raster::Triangle& triangle : triangles[body]) raster.add(triangle, body, 0xffffff);
  EXPECT_EQ(raster.body_at(kSize / 2, kSize / 2 - 5), 1u) << "on the sphere";
  EXPECT_EQ(raster.body_at(kSize / 2, kSize / 2 - 40), 0u) << "of the lower one alone";
}

const Raster::Triangle front = {Vector3d(20, 20, 0), Vector3d(180, 20, 0), Vector3d(20, 180, 0)};

TEST(Raster, FromInsideNothingIsSeenNorOfWhatHasNoArea) {
  Raster raster(kSize, kSize);
  raster.add({front[0], front[2], front[1]}, 0, 0xffffff);
  raster.add({front[0], front[0], front[1]}, 0, 0xffffff);
  EXPECT_FALSE(raster.body_at(50, 50));
}

TEST(Raster, WhatLiesBesideThePageIsLeftOut) {
  Raster raster(kSize, kSize);
  raster.add({Vector3d(-500, -500, 0), Vector3d(900, -500, 0), Vector3d(0, 900, 0)}, 3, 0xffffff);
  raster.add({Vector3d(500, 500, 9), Vector3d(600, 500, 9), Vector3d(500, 600, 9)}, 4, 0xffffff);
  for (const double x : {0.1, 100.0, 199.9}) EXPECT_EQ(raster.body_at(x, 0.1), 3u);
}

std::uint32_t number_at(const std::string& png, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t k = at; k < at + 4; ++k)
    number = number << 8 | static_cast<unsigned char>(png.at(k));
  return number;
}

/// Pixels of an image file, from the top, four bytes each: checks sizes, sums and what the format
/// says of its one block of rows.
struct Decoded {
  explicit Decoded(const std::string& png) {
    EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n"));
    std::string names, packed;
    for (std::size_t at = 8; at < png.size(); at += 12 + number_at(png, at)) {
      const std::string chunk = png.substr(at + 4, 4 + number_at(png, at));
      const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(chunk.data()), chunk.size());
      EXPECT_EQ(number_at(png, at + 4 + chunk.size()), sum) << chunk.substr(0, 4);
      names += chunk.substr(0, 4);
      if (chunk.starts_with("IDAT")) packed = chunk.substr(4);
    }
    EXPECT_EQ(names, "IHDRIDATIEND");
    width = number_at(png, 16);
    height = number_at(png, 20);
    uLongf length = height * (1 + 4 * width);
    rows.resize(length);
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &length,
                         reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
              Z_OK);
    EXPECT_EQ(length, rows.size());
  }
  int channel(std::size_t x, std::size_t y, int which) const {
    return static_cast<unsigned char>(rows.at(y * (1 + 4 * width) + 1 + 4 * x + which));
  }
  int alpha(std::size_t x, std::size_t y) const { return channel(x, y, 3); }

  std::size_t width = 0, height = 0;
  std::string rows;
};

TEST(Raster, IsAnImageFileThatIsTransparentBesideTheBodiesAndFaintInTheirShadows) {
  Raster raster(kSize, kSize);
  raster.add(front, 0, 0xff0000);
  raster.add_shadow({Vector3d(20, 100, 5), Vector3d(180, 100, 5), Vector3d(180, 180, 5)});
  const Decoded image(raster.png());
  ASSERT_EQ(image.width, 400u);
  ASSERT_EQ(image.height, 400u);
  EXPECT_EQ(image.alpha(10, 10), 0);
  EXPECT_EQ(image.alpha(80, 320), 255) << "the body, low in the page";
  EXPECT_GT(image.channel(80, 320, 0), 200);
  EXPECT_EQ(image.channel(80, 320, 1), 0);
  EXPECT_GT(image.alpha(340, 160), 0) << "a shadow";
  EXPECT_LT(image.alpha(340, 160), 60);
  EXPECT_EQ(image.alpha(160, 190), 255) << "a shadow lies on no body";
}

/// Whether a pixel is as dark as lines are.
bool dark(const Decoded& image, std::size_t x, std::size_t y) {
  return image.alpha(x, y) == 255 && image.channel(x, y, 0) < 120;
}

TEST(Raster, LinesAreDrawnWhereWhatIsSeenEndsAndWhereItBendsAndNowhereElse) {
  // A plate before another, both in the plane of the picture; the lower one bends to the right.
  const auto add_plate = [](Raster& raster, double left, double right, double z, double fall) {
    const Vector3d a(left, 40, z), b(right, 40, z - fall), c(right, 160, z - fall), d(left, 160, z);
    raster.add({a, b, c}, 0, 0xffffff);
    raster.add({a, c, d}, 0, 0xffffff);
  };
  Raster raster(kSize, kSize);
  add_plate(raster, 20, 120, 0, 0);
  add_plate(raster, 120, 180, 0, 120);
  add_plate(raster, 40, 60, 30, 0);
  const Decoded image(raster.png());
  const std::size_t y = 150;
  EXPECT_TRUE(dark(image, 40, y)) << "the left side";
  EXPECT_TRUE(dark(image, 80, y)) << "of the plate in front";
  EXPECT_TRUE(dark(image, 240, y)) << "the bend";
  EXPECT_TRUE(dark(image, 359, y)) << "the right side";
  for (const std::size_t x : {60, 78, 100, 122, 200, 300}) EXPECT_FALSE(dark(image, x, y)) << x;
  for (std::size_t up = 100; up < 300; ++up) EXPECT_FALSE(dark(image, 160, up)) << "a diagonal";
}

TEST(Raster, WhatIsThinKeepsItsColourButHasLinesBeforeOtherBodies) {
  Raster raster(kSize, kSize);
  raster.add({Vector3d(20, 100, 9), Vector3d(180, 100, 9), Vector3d(180, 102, 9)}, 0, 0xffffff);
  raster.add({Vector3d(100, 60, 0), Vector3d(200, 60, 0), Vector3d(150, 160, 0)}, 1, 0xffffff);
  const Decoded image(raster.png());
  for (std::size_t x = 180; x < 200; ++x) EXPECT_FALSE(dark(image, x, 199)) << x;
  EXPECT_TRUE(dark(image, 320, 199));
  EXPECT_FALSE(dark(image, 320, 201)) << "behind the line";
}

TEST(Raster, WithoutBodiesIsEmpty) {
  const Raster raster(3, 2);
  EXPECT_FALSE(raster.body_at(1, 1));
  EXPECT_EQ(Decoded(raster.png()).width, 6u);
}

}  // namespace
}  // namespace lcp
