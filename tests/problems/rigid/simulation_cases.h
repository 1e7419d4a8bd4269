#pragma once

#include <algorithm>

#include "problems/rigid/simulation.h"
#include "solvers/registry.h"
#include "tests/problems/rigid/figures.h"
#include "tests/problems/rigid/random_models.h"

namespace lcp::cases {

constexpr double kGravity = 9.80665;  // m/s^2

/// A row of the registry in the loop; what it claims to have solved acts.
inline ContactSolver solver_in_the_loop(const std::string& spelling = "best-first") {
  return {
      .solve = [made = make_solver(spelling)](
                   const Problem& problem,
                   const Call& call) { return made.solver->solve(problem, call); },
      .accept = [](const Problem&, const Result& result) { return result.claim == Claim::solved; }};
}

/// A free body whose frame is at its centre of mass.
inline Link free_body(double mass, const Matrix3d& inertia) {
  Link link;
  link.name = "body";
  link.mass = mass;
  link.inertia = inertia;
  return link;
}

inline Link free_box(double mass, const Vector3d& edges) {
  return free_body(mass, box_inertia(mass, edges));
}

inline Link free_sphere(double mass, double radius) {
  return free_body(mass, 0.4 * mass * radius * radius * Matrix3d::Identity());
}

/// Corners of the lower face of a box, in its frame.
inline std::vector<Vector3d> lower_corners(const Vector3d& edges) {
  const Vector3d h = edges / 2;
  return {{h.x(), h.y(), -h.z()},
          {-h.x(), h.y(), -h.z()},
          {-h.x(), -h.y(), -h.z()},
          {h.x(), -h.y(), -h.z()}};
}

/// The plane through the origin with this normal as the ground for points of link 0: those touch
/// that are no more than `reach` above it.
inline auto points_on_plane(std::vector<Vector3d> points, const Vector3d& normal,
                            double reach = 0) {
  return [points = std::move(points), normal, reach](const Kinematics& k) {
    std::vector<ContactPoint> found;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3d position = k.pose[0] * points[i];
      const double depth = -normal.dot(position);
      if (depth >= -reach)
        found.push_back({.position = position,
                         .normal = normal,
                         .depth = depth,
                         .id = {body_of(0), 0, static_cast<Index>(i)}});
    }
    return found;
  };
}

/// Spheres (link i of `radii[i]`) that touch one another where they overlap.
inline auto spheres_on_spheres(std::vector<double> radii) {
  return [radii = std::move(radii)](const Kinematics& k) {
    std::vector<ContactPoint> found;
    const Index count = static_cast<Index>(radii.size());
    for (Index a = 0; a < count; ++a) {
      for (Index b = a + 1; b < count; ++b) {
        const Vector3d between = k.pose[a].p - k.pose[b].p;
        const double depth = radii[a] + radii[b] - between.norm();
        if (depth < 0) continue;
        const Vector3d normal = between.normalized();
        found.push_back({.position = k.pose[b].p + (radii[b] - depth / 2) * normal,
                         .normal = normal,
                         .depth = depth,
                         .id = {body_of(a), body_of(b), 0}});
      }
    }
    return found;
  };
}

/// One link in the world that touches things.
inline System one_body(Link link, decltype(System::collide) collide, double mu) {
  Model model({std::move(link)});
  State start = state_at_zero(model);
  return {.model = std::move(model),
          .start = std::move(start),
          .handles = {0},
          .collide = std::move(collide),
          .mu = mu};
}

/// Steps until `duration` has passed, counting frames whose frictional LCP was not solved.
inline Index run(Simulation& simulation, double duration, const ContactSolver& solver,
                 const std::function<void(const Frame&)>& look = {}) {
  Index failures = 0;
  const Index steps = static_cast<Index>(std::lround(duration / simulation.stepping().dt));
  for (Index i = 0; i < steps; ++i)
    simulation.step(solver, [&](const Frame& frame) {
      failures += frame.contacts.size() > 0 && frame.solution.applied != Applied::frictional;
      if (look) look(frame);
    });
  return failures;
}

}  // namespace lcp::cases
