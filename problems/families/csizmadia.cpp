// csizmadia: an M-matrix whose handicap grows exponentially.
//
// What      M has 1 on the diagonal and -1 below it, q such that z = w' = 1, 0, 1, ... with w = 1 - z
//           solves; data and solution are exact. The bounds on interior-point methods for sufficient
//           matrices grow with the handicap, exponential in n here; for a pivoting method n pivots
//           or so are enough.
// Count     Instance k has n + k rows.
// Seed      Of the permutations of the variables where permute=on; otherwise it changes nothing.
// Class     P-matrix (triangular, diagonal positive) and M-matrix: the solution is unique.
// Source    E. de Klerk, M. E.-Nagy, On the complexity of computing the handicap of a sufficient
//           matrix, Mathematical Programming 129, 2011, who credit Zs. Csizmadia; hnm4lcp.

#include "problems/families/growing_series.h"

namespace lcp {
namespace {

constexpr Index kLargest = 1000;

const FamilyRegistration registration{
    {"csizmadia", "triangular M-matrix whose handicap grows exponentially",
     "de Klerk and E.-Nagy 2011", 9},
    GrowingKnobs{.n = 20},
    [](GrowingKnobs& knobs) { return growing_options(knobs, 1, kLargest); },
    [](const GrowingKnobs& knobs, const Draw& draw) {
      return growing_series(knobs, kLargest, draw, csizmadia);
    }};

}  // namespace
}  // namespace lcp
