#pragma once

#include <memory>
#include <vector>

#include "problems/rigid/kinematics.h"

namespace lcp {

/// How chosen links (handles) answer to forces on them, eqs. (9), (10):
///
///     a = Phi F + phi,   a, F (6N): accelerations of and forces on the N handles, each (6) at its
///                        own point.
///
/// Near a light link entries of Phi at O grow with the square of its distance from O, and what they
/// say of the link by itself is lost in their rounding; at points near the links it is not.
struct HandleDynamics {
  MatrixXd Phi;                  ///< 6N x 6N, inverse articulated-body inertias; symmetric.
  VectorXd phi;                  ///< 6N, bias accelerations.
  std::vector<Vector3d> points;  ///< N, from O; m.
};

/// The same with all points at O.
HandleDynamics at_origin(const HandleDynamics& dynamics);

/// Throws std::invalid_argument unless `handles` are links of the model, ascending. `where` begins the
/// message.
void check_handles(const Model& model, const std::vector<Index>& handles, const std::string& where);

/// What a whole system does under forces on its handles.
struct Accelerations {
  VectorXd joints;              ///< du/dt, in the order of u; 0 for prescribed joints.
  std::vector<Vector6d> links;  ///< Spatial acceleration of each link at O.
};

struct AssemblyOptions {
  /// Directions in which a loop's joint answers less than this share of what the two bodies would
  /// by themselves are held already: the joint transmits nothing along them. Closing planar loops of
  /// hinges leaves three such directions at rounding, about 1e-12.
  double redundancy = 1e-10;
};

/// Forward dynamics by assembly and disassembly (ADA): two subassemblies with handles joined by a
/// joint become one, until the system is one assembly whose handles are those asked for; then the
/// joints' forces follow in reverse order.
///
///     g_i = Phi_ic - Phi_ip,   Q = g_c - g_p,   Gamma = T'QT,   W = T Gamma^-1 T',
///     f = F tau - W (Q F tau + b_c - b_p - sigma),                        force on the child
///     Phi'_ij = Phi_ij - g_i W g_j',   b'_i = b_i + g_i f,
///
/// g_i at the point of i, Q, T and f at the joint, where p and c are parent and child, T (6 x
/// constraints) spans the forces a joint transmits, T'S = 0, and F its torques, S'F = 1. A prescribed
/// or fixed joint transmits all, T = 1. A free link's joint transmits none and is never assembled.
/// The world is a body with Phi = 0. The joint of a loop is closed by the same formula where both p
/// and c belong to one assembly; where links may be held twice Gamma^-1 is the inverse on the range
/// of Gamma, and the joint force the least of those that hold, each component measured by how the two
/// bodies by themselves would answer to it.
///
/// Source: K. Yamane, Y. Nakamura, "Efficient Parallel Dynamics Computation of Human Figures", ICRA
/// 2002; R. Featherstone, IJRR 18 (1999), 867-892. Cost: per joint O(h^2) products of 6 x 6 blocks
/// for h handles open at once; the order of joints is a balanced tree. Rounding: Phi' is a
/// difference. Where joints are prescribed and the whole moves as one body, what should vanish is
/// left as noise (about 1e-12 of the largest entry, either sign).
class ForwardDynamics {
 public:
  /// `handles` are links, ascending; `model` must outlive this. Throws std::invalid_argument when one
  /// does not exist or is repeated.
  ForwardDynamics(const Model& model, std::vector<Index> handles,
                  const AssemblyOptions& options = {});
  ~ForwardDynamics();
  ForwardDynamics(ForwardDynamics&&) noexcept;
  ForwardDynamics& operator=(ForwardDynamics&&) noexcept;

  /// Assembles the system where it is. `torques` (as u; entries of prescribed and free joints are
  /// not read) act in the joints, N m; `gravity` in m/s^2, world axes; `forces` on each link, (moment
  /// about O; force), or none where empty. Throws std::invalid_argument where there is another number
  /// of them.
  void assemble(const Kinematics& kinematics, const VectorXd& torques, const Vector3d& gravity,
                const std::vector<Vector6d>& forces = {});

  const std::vector<Index>& handles() const;
  /// Of what was assembled last, each handle at the origin of its link's frame.
  HandleDynamics handle_dynamics() const;

  /// Disassembles what was assembled last, under `forces` (6N, at O) on the handles.
  Accelerations disassemble(const VectorXd& forces);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Whether all links move as one body: a free link that carries prescribed and fixed joints only,
/// without loops.
bool moves_as_one_body(const Model& model);

/// The same for a system that moves as one body, from the inertia M of the composite body: Phi_ij =
/// M^-1 for all i, j, exactly of rank 6. JointSpace gives the same matrices for other systems too;
/// here phi as well is free of the ADA's noise, and one and the same for all points of a link.
/// Throws std::invalid_argument for another system, and on handles as ForwardDynamics does.
class CompositeBody {
 public:
  CompositeBody(const Model& model, std::vector<Index> handles);

  HandleDynamics handle_dynamics(const Kinematics& kinematics, const Vector3d& gravity) const;
  /// A = L^-1 (sum of J's 6-column blocks)', M = L L': J Phi J' = A'A, A is 6 x rows of J.
  MatrixXd contact_factor(const Kinematics& kinematics, const MatrixXd& J) const;

 private:
  const Model* model_;
  std::vector<Index> handles_;
};

}  // namespace lcp
