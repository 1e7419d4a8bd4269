#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "solvers/linalg/labels.h"

namespace lcp {

/// An almost complementary basis together with the variable that enters next. Since of every pair
/// w_i, z_i exactly one is basic, but for the pair of the entering variable, the set of basic z and
/// the entering variable tell the basis.
struct BasisKey {
  std::vector<std::uint64_t> z_basic;  ///< Bit i: z_i is basic; bit n: z0 is.
  Variable entering = -1;
  std::uint64_t hash = 0;

  BasisKey(const Labels& labels, Variable next);
  /// The key after one more pivot, O(1) hashing.
  BasisKey after(const Labels& labels, Variable entered, Variable left, Variable next) const;

 private:
  void flip(const Labels& labels, Variable v);
  void set_entering(Variable next);
};

/// The keys seen so far. A hash that is known is confirmed by comparing the bases.
class Visited {
 public:
  /// False if the key was there already.
  bool insert(const BasisKey& key);
  bool contains(const BasisKey& key) const;

 private:
  std::unordered_multimap<std::uint64_t, BasisKey> keys_;  // looked up, never iterated
};

}  // namespace lcp
