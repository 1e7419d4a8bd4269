// ben-gharbia-gilbert: P-matrices on which the Newton-min method cycles.
//
// What      Circulant M with 1 on the diagonal and, below it, 2 (n odd) or 4/3 and 1/2 (n even),
//           q = 1. The method that solves w_i = 0 for all i with w_i < z_i and sets the other z_i to
//           0, again and again, cycles through n sets when it starts at -e_1. z = 0 is the only
//           solution, so that pivoting methods without a start have nothing to do and tables count
//           these instances as trivial: they are for methods that are handed a start.
// Count     Instance k has n + k rows, odd and even in turn.
// Seed      Of the permutations of the variables where permute=on; otherwise it changes nothing.
// Class     P-matrix: all 2^n - 1 principal minors were computed for n = 3 ... 10.
// Source    I. Ben Gharbia, J. Ch. Gilbert, Nonconvergence of the plain Newton-min algorithm for
//           linear complementarity problems with a P-matrix, Mathematical Programming 134, 2012.

#include "problems/families/growing_series.h"

namespace lcp {
namespace {

constexpr Index kSmallest = 3;  // Newton-min converges on smaller P-matrices.
constexpr Index kLargest = 1000;

const FamilyRegistration registration{
    {"ben-gharbia-gilbert", "P-matrices on which Newton-min cycles from -e_1; z = 0 solves them",
     "Ben Gharbia and Gilbert 2012", 10},
    GrowingKnobs{.n = 5},
    [](GrowingKnobs& knobs) { return growing_options(knobs, kSmallest, kLargest); },
    [](const GrowingKnobs& knobs, const Draw& draw) {
      return growing_series(knobs, kLargest, draw, ben_gharbia_gilbert);
    }};

}  // namespace
}  // namespace lcp
