// murty: Murty's exponential family, on which Lemke takes 2^n pivots.
//
// What      M unit lower triangular with 2 below the diagonal, q_i = -(2^(n-i+1) + ... + 2^n); the
//           solution is 2^n e_1. Data and solution are exact. No ratio test is tied: every rule for
//           ties walks the same path, however the variables are labelled.
// Count     Instance k has n + k rows: its pivots are twice those of instance k - 1.
// Seed      Of the permutations of the variables where permute=on; otherwise it changes nothing.
// Class     P-matrix (triangular, diagonal positive). Pivot limit 2^(n+1).
// Source    K. G. Murty, Linear Complementarity, Linear and Nonlinear Programming, 1988, chapter 6.

#include "problems/families/growing_series.h"

namespace lcp {
namespace {

constexpr Index kLargest = 24;  // 16.8 million pivots.

const FamilyRegistration murty{
    {"murty", "Murty's exponential family: Lemke takes 2^n pivots, none tied",
     "Murty 1988, chapter 6", 9},
    GrowingKnobs{.n = 4},
    [](GrowingKnobs& knobs) { return growing_options(knobs, 1, kLargest); },
    [](const GrowingKnobs& knobs, const Draw& draw) {
      return growing_series(knobs, kLargest, draw, murty_exponential);
    }};

}  // namespace
}  // namespace lcp
