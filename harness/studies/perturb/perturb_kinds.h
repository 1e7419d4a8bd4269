#pragma once

#include <functional>
#include <string>

#include "problems/drawing/random.h"
#include "problems/instance.h"

namespace lcp {

/// An instance after a change that should not matter, and the way of its answers back.
struct Disturbed {
  Instance instance;
  /// z (n) of the original problem from z (n) of this one.
  std::function<VectorXd(const VectorXd&)> back;
};

/// All disturbances keep what an instance knows (known solution, previous solution, active contacts,
/// covering vector, pivot limit) and carry it over. Matrices and scales are computed anew as
/// assemble_friction_lcp (with friction blocks) and set_plain_scales (without) do, so that what is
/// exact there (opposite directions, the ones of E, mu) stays exact; an instance with scales of its
/// own keeps them, in the new units. The name gets `~LABEL` behind it.
///
/// Throws std::invalid_argument, saying why, where reason_against_reassembly names a reason.
/// Cost: O(n^2) each.

/// Why the blocks of a problem cannot stand for its M and q; empty where they can, and where it has
/// none. M and q may differ from what assemble_friction_lcp makes of the blocks by
/// `reassembly_tolerance` of their largest entries.
inline constexpr double reassembly_tolerance = 1e-13;
std::string reason_against_reassembly(const Problem& problem);

/// Every number of M and q times 1 + k 2^-52, rounded, k uniform in {-last_bits ... last_bits}: with friction
/// blocks, every number of W and vbar. Zeros stay zeros, and a matrix that is symmetric to the bit
/// stays so. z is kept.
Disturbed with_noise(const Instance& instance, Index last_bits, Random& random,
                     const std::string& label);

/// Another order of rows, and of contacts within the friction blocks: place j holds what stood at
/// rows[j], contacts[j].
struct Order {
  std::vector<Index> rows;
  std::vector<Index> contacts;  ///< Empty without friction blocks.
};

/// Any order; of a problem with friction blocks, any that leaves the b_i1 ... b_im of a contact
/// together, as FrictionBlocks asks.
Order random_order(const Problem& problem, Random& random);

Order inverse(const Order& order);

/// Nothing is computed: every number is the original's, to the bit.
Disturbed permuted(const Instance& instance, const Order& order, const std::string& label);

/// Units of length and force: a new number is the number in m (m/s) or N times these.
struct Units {
  double length = 1;
  double force = 1;
};

/// W times length / force, vbar times length; z is force (a, b) or velocity (lambda). A plain LCP has
/// no units: its q is read as velocities and its z as forces.
Disturbed in_units(const Instance& instance, const Units& units, const std::string& label);

/// The tangent axes of contact i turned about its normal by steps[i] (one per contact) spacings 2 pi /
/// m of its m friction directions, which keep their coordinates: the same polygon with other labels,
/// so that z maps back by relabelling, and W and vbar in other axes, rounded anew.
///
/// Throws std::invalid_argument also where reason_against_turning names a reason.
Disturbed turned_by_steps(const Instance& instance, const std::vector<Index>& steps,
                          const std::string& label);

/// The same by any angles (rad, one per contact): another polygon, and so another problem. An answer
/// maps back to the same contact forces, written in the two original directions next to each.
Disturbed turned_by_angles(const Instance& instance, const VectorXd& angles,
                           const std::string& label);

/// Why no contact can be turned; empty where one can: there must be friction, and the directions be a
/// regular polygon (to `polygon_tolerance`), or their labels would not be exchangeable.
inline constexpr double polygon_tolerance = 1e-12;
std::string reason_against_turning(const Problem& problem);

/// q (vbar) times 10^exponent; z along with it.
Disturbed with_scaled_q(const Instance& instance, int exponent, const std::string& label);

}  // namespace lcp
