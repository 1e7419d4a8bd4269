#pragma once

#include <cstdint>
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
  /// Makes this the key after one more pivot, O(1) hashing.
  void follow(const Labels& labels, Variable entered, Variable left, Variable next);

 private:
  void flip(const Labels& labels, Variable v);
  void set_entering(Variable next);
};

/// The keys seen so far, numbered in order. A hash that is known is confirmed by comparing the bases.
class Visited {
 public:
  /// False if the key was there already.
  bool insert(const BasisKey& key);
  void copy_key(Index number, BasisKey& key) const;
  Index size() const { return static_cast<Index>(seen_.size()); }

 private:
  struct Seen {
    std::uint64_t hash;
    Variable entering;
  };
  std::vector<Seen> seen_;
  std::vector<std::uint64_t> words_;  ///< z_basic of all, one after the other.
  std::vector<std::int32_t> slots_;  ///< Open addressing by hash: number + 1, or 0; a power of two.

  /// Slot of the key, or the free one where it belongs.
  std::size_t slot_of(const BasisKey& key) const;
  /// Doubles the table, with room for as many keys of `words` words each as it may hold.
  void grow(std::size_t words);
};

}  // namespace lcp
