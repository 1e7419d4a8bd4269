#include "problems/scenes/humanoid/magnum.h"

#include <numbers>

namespace lcp::magnum {

namespace {

/// A link with its joint, about its own z axis. Those on the right are the mirror images of those on the
/// left.
struct Row {
  const char* name;
  Index parent;
  double rotation[9];      ///< Of the link's frame in the parent's at angle 0, row by row.
  double position[3];      ///< m.
  double mass;             ///< kg.
  double centre[3];        ///< Of mass, link frame, m.
  double inertia[6];       ///< xx, yy, zz, xy, xz, yz about the centre of mass, link axes, kg m^2.
  double low[3], high[3];  ///< Box around the shapes, link frame, m; empty: see parts, or none.
};

constexpr double h = std::numbers::sqrt2 / 2;

// clang-format off
constexpr Row table[] = {
    {"body", -1, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0},
     2.983032, {-0.069189, 0.000422, 0.008568}, {0.012246, 0.014523, 0.011317, 8.3e-05, -0.001497, 3.8e-05},
     {0, 0, 0}, {0, 0, 0}},
    {"left_shoulder_flexion", 0, {0, -1, 0, -h, 0, -h, h, 0, -h}, {-0.046, 0.069539, 0.052662},
     0.147856, {-0.00556493, 0.003484, -0.038542976}, {5.4e-05, 0.00012, 0.000126, 1e-06, -2.6e-05, -1e-06},
     {-0.0427, -0.0445, -0.1063}, {0.03, 0.0445, -0.024}},
    {"left_shoulder_abduction", 1, {-h, h, 0, 0, 0, -1, -h, -h, 0}, {-0.02114319986, 0.005, -0.06114281625},
     0.146784, {0.002341, -0.033864, 0.003333}, {0.000202, 4.2e-05, 0.000189, 9e-06, 0, -8e-06},
     {-0.018, -0.1, -0.0245}, {0.0235, 0.018, 0.0225}},
    {"left_elbow_rotation", 2, {1, 0, 0, 0, 0, 1, 0, -1, 0}, {0, -0.077, 0.005},
     0.077469, {1.1e-05, 0.001119, -0.02598}, {4.3e-05, 4.2e-05, 1e-05, 0, 0, -1e-06},
     {0, 0, 0}, {0, 0, 0}},
    {"left_elbow_flexion", 3, {1, 0, 0, 0, 0, 1, 0, -1, 0}, {0, 0.005, -0.044},
     0.171038, {0.002123, 0.029914, -0.000185}, {0.000195, 5.7e-05, 0.000171, -6e-06, -1e-06, -9e-06},
     {-0.019, -0.019, -0.0225}, {0.0265, 0.1067, 0.0245}},
    {"left_hip_flexion", 0, {0, 1, 0, 0, 0, -1, -1, 0, 0}, {-0.046, 0.029, -0.092},
     0.106071, {1e-05, -0.001533, -0.025129}, {7.1e-05, 6.5e-05, 2.4e-05, 0, 0, 3e-06},
     {0, 0, 0}, {0, 0, 0}},
    {"left_hip_abduction", 5, {0, 1, 0, 0, 0, 1, 1, 0, 0}, {0, -0.011, -0.046},
     0.374062, {0.006225, 0.041239, 0.008906}, {0.000436, 0.00019, 0.000389, 8.2e-05, 5e-06, 4e-06},
     {-0.019, -0.019, -0.034}, {0.042, 0.121, 0.034}},
    {"left_knee_rotation", 6, {0, -1, 0, 0, 0, -1, 1, 0, 0}, {0.025, 0.097, 0.011},
     0.077328, {-6.3e-05, 0.001114, -0.026101}, {4.3e-05, 4.2e-05, 1e-05, 0, 0, -1e-06},
     {0, 0, 0}, {0, 0, 0}},
    {"left_knee_flexion", 7, {1, 0, 0, 0, 0, 1, 0, -1, 0}, {0, 0.005, -0.044},
     0.341003, {-0.002346, 0.048179, -0.0007}, {0.000552, 0.00016, 0.000505, -4.2e-05, -3e-06, -1.7e-05},
     {-0.045, -0.041, -0.0372}, {0.032, 0.132, 0.0342}},
    {"left_ankle_flexion", 8, {0, 1, 0, 1, 0, 0, 0, 0, -1}, {-0.008, 0.113, 0},
     0.09306, {1.1e-05, -0.003433, 0.001456}, {3.4e-05, 2e-05, 2.7e-05, 0, 0, -2e-06},
     {0, 0, 0}, {0, 0, 0}},
    {"left_ankle_abduction", 9, {0, -1, 0, 0, 0, 1, -1, 0, 0}, {0, -0.044, 0.0065},
     0.329776, {6e-06, -0.032342, 0.02845}, {0.000568, 0.000534, 0.000236, 0, 0, -0.000112},
     {0, 0, 0}, {0, 0, 0}},
};
// clang-format on

/// Shapes that one box would not do justice: head, chest, waist, hips and backpack; ankles and feet.
constexpr struct {
  Index link;
  double low[3], high[3];
} parts[] = {
    {0, {-0.0729, -0.0336, 0.076}, {0.0059, 0.0336, 0.15}},
    {0, {-0.085, -0.0814, -0.002}, {0.035, 0.0814, 0.076}},
    {0, {-0.085, -0.064, -0.037}, {0.0084, 0.064, -0.002}},
    {0, {-0.066, -0.0535, -0.112}, {0.006, 0.0535, -0.037}},
    {0, {-0.172, -0.075, -0.058}, {-0.085, 0.075, 0.117}},
    {10, {-0.018, -0.046, -0.014}, {0.018, 0.018, 0.07}},
    {10, {-0.037, -0.0562, -0.001}, {0.037, -0.03, 0.102}},
};

constexpr Index rows = std::size(table), limbs = rows - 1;  // limbs: links on one side
static_assert(rows + limbs == 21);

Vector3d vector(const double (&numbers)[3]) { return Vector3d(numbers); }

Link link(const Row& row) {
  Link made;
  made.name = row.name;
  made.parent = row.parent;
  made.joint = row.parent == Link::world ? JointKind::free : JointKind::prescribed;
  made.in_parent = {Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(row.rotation),
                    vector(row.position)};
  made.mass = row.mass;
  made.centre = vector(row.centre);
  const double* I = row.inertia;
  made.inertia << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2];
  return made;
}

/// Frames on the right have their z axis the other way; the body's own frame is mirrored along y.
const Vector3d kFlipZ(1, 1, -1), kFlipY(1, -1, 1);

Link mirrored(Link link) {
  const bool on_body = link.parent == body;
  const Vector3d& across = on_body ? kFlipY : kFlipZ;
  const auto flipped = [](const Matrix3d& m, const Vector3d& left, const Vector3d& right) {
    return Matrix3d((left.asDiagonal() * m * right.asDiagonal()).array() + 0.0);  // no -0
  };
  link.name = "right" + link.name.substr(std::string_view("left").size());
  if (!on_body) link.parent += limbs;
  link.in_parent.R = flipped(link.in_parent.R, across, kFlipZ);
  link.in_parent.p = across.cwiseProduct(link.in_parent.p).array() + 0.0;
  link.centre = kFlipZ.cwiseProduct(link.centre).array() + 0.0;
  link.inertia = flipped(link.inertia, kFlipZ, kFlipZ);
  return link;
}

}  // namespace

Model model() {
  std::vector<Link> made;
  for (const Row& row : table) made.push_back(link(row));
  for (Index i = 1; i < rows; ++i) made.push_back(mirrored(made[i]));
  return Model(std::move(made));
}

std::vector<collision::Shape> link_boxes() {
  std::vector<collision::Shape> boxes;
  const auto add = [&](Index link, const double(&from)[3], const double(&to)[3], bool right) {
    Vector3d low = vector(from), high = vector(to);
    if (right) {
      low.z() = -to[2];
      high.z() = -from[2];
    }
    boxes.push_back({.geometry = collision::Box{high - low},
                     .link = right ? link + limbs : link,
                     .in_link = {Matrix3d::Identity(), (low + high) / 2}});
  };
  for (const bool right : {false, true})
    for (Index i = 1; i < rows; ++i)
      if (vector(table[i].low) != vector(table[i].high)) add(i, table[i].low, table[i].high, right);
  for (const bool right : {false, true})
    for (const auto& part : parts)
      if (part.link != body || !right) add(part.link, part.low, part.high, right);
  return boxes;
}

std::array<Index, 6> leg(Side side) {
  const Index hip = side == Side::left ? 5 : 15;
  return {hip, hip + 1, hip + 2, hip + 3, hip + 4, hip + 5};
}

Pose sole(Side side) {
  const double s = side == Side::left ? 1 : -1;
  Pose pose;
  pose.R << 0, s, 0, 0, 0, 1, s, 0, 0;
  pose.p = {0, -0.0562, s * 0.044};
  return pose;
}

std::vector<Vector3d> sole_points(bool mid_edges) {
  const Vector3d corners[] = {{sole_front, sole_half_width, 0},
                              {sole_back, sole_half_width, 0},
                              {sole_back, -sole_half_width, 0},
                              {sole_front, -sole_half_width, 0}};
  std::vector<Vector3d> points;
  for (int k = 0; k < 4; ++k) {
    points.push_back(corners[k]);
    if (mid_edges) points.push_back((corners[k] + corners[(k + 1) % 4]) / 2);
  }
  return points;
}

}  // namespace lcp::magnum
