#pragma once

#include <functional>

#include "problems/contact/carried_over.h"
#include "problems/contact/friction_lcp.h"
#include "solvers/result.h"

namespace lcp {

/// The solver of a frame's contacts. Both may be watched or timed by whoever hands them over.
struct ContactSolver {
  std::function<Result(const Problem&, const Call&)> solve;
  /// Whether an answer may act. The paper counts a solution whose error exceeds e_max as failed.
  std::function<bool(const Problem&, const Result&)> accept;
};

/// How the LCP of a frame is posed and begun.
struct ContactModel {
  enum class Start {
    cold,  ///< From the empty basis.
    /// From the normals that are active in the frictionless solution (IV-C), those of them that are
    /// independent (see independent_contacts).
    two_step,
    all_active,  ///< From all of them, be the basis singular up to rounding: there to be measured.
    previous,    ///< From the frictional solution of the frame before (see carried_over).
  };

  FrictionModel friction;
  Start start = Start::two_step;
  /// Contacts without force in the frictionless solution are left out of the frictional LCP. What
  /// they do under the forces found is not looked at when those act.
  bool active_only = false;
};

/// Whose forces act in a frame.
enum class Applied {
  frictional,
  frictionless,  ///< The frictional LCP failed: bodies do not sink, but slip.
  none,          ///< Both failed.
};

/// A frame's two LCPs, their answers, and the forces that act.
struct ContactSolution {
  Problem frictionless, frictional;  ///< In full, whatever the model leaves out.
  Result without_friction;
  Result with_friction;                              ///< In the rows of the full LCP.
  bool solved_without = false, solved_with = false;  ///< Accepted.
  std::optional<Index> active;  ///< Contacts whose a_i is basic without friction; where known.
  Applied applied = Applied::none;
  VectorXd forces;  ///< 3 Nc, N, contact axes.
};

/// Solves the frictionless LCP, then the frictional one (IV-C), and applies the rule of V-A: where
/// the frictional answer is not accepted the frictionless one acts, and where that is not either,
/// nothing does. `previous` is the frictional solution of the frame before, where that was accepted.
/// Without what the model wants to start from (an accepted frictionless basis, or `previous`), the
/// frictional LCP is started cold and that counts as a restart. Where no contact has friction the
/// two are the same LCP: it is solved once, cold, and its answer is both. Source: K. Yamane,
/// Y. Nakamura, "A Numerically Robust LCP Solver for Simulating Articulated Rigid Bodies in
/// Contact", RSS 2008, IV-C, V-A.
ContactSolution solve_contacts(const ContactProblem& problem, const ContactModel& model,
                               const ContactSolver& solver,
                               const std::optional<SolutionByContact>& previous = {});

/// The frame's solutions that were accepted, for the next one. `contacts` are the frame's.
FrameSolutions accepted_solutions(const ContactSolution& solution,
                                  const std::vector<Contact>& contacts);

}  // namespace lcp
