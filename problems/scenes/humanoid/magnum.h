#pragma once

#include <array>
#include <vector>

#include "problems/collision/shape.h"
#include "problems/rigid/model.h"

namespace lcp::magnum {

/// UT-mu2 "magnum": the small humanoid of the paper's reference [24], 20 revolute joints, 6.712 kg,
/// 0.55 m tall. x forward, y left, z up; every joint prescribed.
///
/// Source: github.com/mi-lib/roki, example/model/magnum.ztk, commit 655bd98, MIT licence, (C) 2024
/// Tomomichi Sugihara: frames, masses, centres of mass, inertias, sole polygons; the boxes around
/// its shapes are for pictures only. Links without mass (hands, soles) are part of what carries
/// them.
Model model();

/// Boxes around the links' shapes.
std::vector<collision::Shape> link_boxes();

enum class Side { left, right };

inline constexpr Index body = 0;
inline constexpr double height = 0.55;  ///< m, standing upright.

/// Links of a leg from the hip down; the last carries the sole.
std::array<Index, 6> leg(Side side);
inline Index foot(Side side) { return leg(side).back(); }

/// Frame of the sole in its foot's link: x forward, z up, on the ground below the ankle.
Pose sole(Side side);

/// Rectangle of the sole in its own frame, m.
inline constexpr double sole_front = 0.054586, sole_back = -0.041586, sole_half_width = 0.034586;

/// Points of a sole in its own frame: its corners from the front left one round, and the middles of
/// the edges where `mid_edges`.
std::vector<Vector3d> sole_points(bool mid_edges);

}  // namespace lcp::magnum
