// fathi: symmetric and nearly symmetric relatives of Murty's family, tied at nearly every pivot.
//
// What      L unit lower triangular with 2 below the diagonal; M = LL' (variant 1), LL' + 4
//           (variant 2), LL' - 4 outside the first column (variant 3); q = -1, solution e_1 / M_11.
//           In the order of the variables given here lexicographic Lemke takes 2^n pivots and Lemke
//           with the first index 2; relabelled, either took 2 ... 16 for n = 4 ... 12 (seed 1).
// Count     Instance k has n + k rows.
// Seed      Of the permutations of the variables where permute=on; otherwise it changes nothing.
// Class     Variants 1 and 2 are symmetric positive definite, variant 3 is an unsymmetric P-matrix.
//           Pivot limit 2^(n+1).
// Source    Y. Fathi, Computational complexity of LCPs associated with positive definite symmetric
//           matrices, Mathematical Programming 17, 1979; variants 2 and 3 as in hnm4lcp.

#include "problems/families/growing_series.h"

namespace lcp {
namespace {

constexpr Index kLargest = 24;  // 16.8 million pivots.

struct FathiKnobs {
  Index variant = 1;
  GrowingKnobs growing = {.n = 4};
};

OptionTable knob_table(FathiKnobs& knobs) {
  OptionTable table = growing_options(knobs.growing, 1, kLargest);
  table.insert(table.begin(), count("variant", knobs.variant, 1, 3,
                                    "M is LL', LL' + 4, or LL' - 4 outside the first column"));
  return table;
}

std::vector<Instance> generate_fathi(const FathiKnobs& knobs, const Draw& draw) {
  return growing_series(knobs.growing, kLargest, draw,
                        [&](Index n) { return fathi(static_cast<int>(knobs.variant), n); });
}

const FamilyRegistration registration{
    {"fathi", "exponential family, M symmetric positive definite: nearly every ratio test tied",
     "Fathi 1979", 9},
    FathiKnobs{},
    knob_table,
    generate_fathi};

}  // namespace
}  // namespace lcp
