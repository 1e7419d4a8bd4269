#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "problems/rigid/forward_dynamics.h"

namespace lcp::cases {

/// A `Model` as MuJoCo (2.2.2) sees it, with its answers in the order and axes of our u. Prescribed
/// joints are hinges there. Needs a tree of at most 80 nested links.
class MuJoCoModel {
 public:
  /// Throws std::runtime_error with MuJoCo's message.
  MuJoCoModel(const Model& model, const Vector3d& gravity);

  /// Moves the system and computes everything below there.
  void set(const State& state);

  MatrixXd mass_matrix() const;
  VectorXd bias() const;  ///< c(q, u) of M du/dt + c = tau, with gravity.
  /// 6 x u, of a link at `origin`: omega, then the velocity of the point at `origin`.
  MatrixXd jacobian(Index link, const Vector3d& origin) const;
  /// du/dt under torques and forces (6N at `origin`) on `handles`, by MuJoCo's own forward dynamics.
  VectorXd accelerations(const std::vector<Index>& handles, const VectorXd& forces,
                         const Vector3d& origin, const VectorXd& torques);

 private:
  int body(Index link) const { return static_cast<int>(body_[link]); }
  /// T with (MuJoCo's velocities) = T u: columns permuted, angular velocities of free joints turned.
  MatrixXd velocity_map() const;

  const Model& ours_;
  std::unique_ptr<mjModel, void (*)(mjModel*)> model_;
  std::unique_ptr<mjData, void (*)(mjData*)> data_;
  std::vector<Index> body_;
};

}  // namespace lcp::cases
