#pragma once

#include <string>
#include <vector>

#include "solvers/linalg/scaled_problem.h"
#include "solvers/registry.h"

namespace lcp {

/// Options that every peer has.
struct PeerOptions {
  bool scale = true;
};

/// The option `scale`.
Option scale_option(PeerOptions& options);

/// While it lives, a call into an outside library is under way: what the library prints on file
/// descriptors 1 and 2 goes to /dev/null, and if it ends the process, by a signal or by exit(), one
/// line on the real stderr says which row did it. Costs some ten system calls, several microseconds,
/// unless silence_outside_calls() was called before. Not for use from several threads at once.
class OutsideCall {
 public:
  /// `row` must outlive the call.
  explicit OutsideCall(const char* row);
  ~OutsideCall();
  OutsideCall(const OutsideCall&) = delete;
  OutsideCall& operator=(const OutsideCall&) = delete;
};

/// The LCP as ODE's kernel and its kin take it: A x = b + w with 0 <= x, no friction indices. They
/// destroy A and b.
struct BoxedForm {
  MatrixXd A;  ///< `padded` x n: column i is row i of M, then zeros.
  VectorXd x, w, b, low, high;
  std::vector<int> friction;  ///< -1: a row whose bounds depend on no other.

  BoxedForm(const ScaledProblem& scaled, Index padded);
};

/// Why a problem cannot be handed to a peer, or nothing.
using Obstacle = std::string;

/// Unless |M - M'| <= `symmetry` max |M|.
Obstacle unsymmetric(const MatrixXd& M, double symmetry);
/// Unless every M_ii > 0.
Obstacle no_positive_diagonal(const MatrixXd& M);
/// Unless every M_ii >= 0.
Obstacle negative_diagonal(const MatrixXd& M);
/// Where the caller gives a start to a method that cannot take one.
Obstacle any_start(const Call& call);

/// Claim::unsupported with z = 0.
Result refuse(const Problem& problem, const Obstacle& why);

/// Claim::solved of the problem without rows, which no library is asked about.
Result solved_empty();

/// The answer of a library in the problem's own units. `z` and `w` are as the library left them, in
/// the scale it worked in; w may be empty. They are not repaired: only where z is not finite it
/// becomes 0 and a claim of success `singular`.
Result outside_result(const ScaledProblem& scaled, Claim claim, std::string message, VectorXd z,
                      VectorXd w, const Work& work);

}  // namespace lcp
