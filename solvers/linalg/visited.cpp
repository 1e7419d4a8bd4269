#include "solvers/linalg/visited.h"

namespace lcp {

namespace {

/// A fixed random number for each basis element (splitmix64); a set's hash is the xor of its
/// elements' numbers, so that a pivot changes it by two.
std::uint64_t number_of(std::uint64_t element) {
  std::uint64_t x = (element + 1) * 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// Entering variables get numbers apart from those of basic ones.
std::uint64_t entering_number(Variable v) {
  return number_of((std::uint64_t{1} << 32) + static_cast<std::uint64_t>(v));
}

}  // namespace

BasisKey::BasisKey(const Labels& labels, Variable next) : z_basic(labels.size() / 64 + 1, 0) {
  for (const Variable v : labels.basic()) flip(labels, v);
  set_entering(next);
}

BasisKey BasisKey::after(const Labels& labels, Variable entered, Variable left,
                         Variable next) const {
  BasisKey key = *this;
  key.flip(labels, entered);
  key.flip(labels, left);
  key.set_entering(next);
  return key;
}

void BasisKey::flip(const Labels& labels, Variable v) {
  if (labels.is_w(v)) return;
  const Index bit = labels.index(v);  // n for z0
  z_basic[bit / 64] ^= std::uint64_t{1} << (bit % 64);
  hash ^= number_of(static_cast<std::uint64_t>(bit));
}

void BasisKey::set_entering(Variable next) {
  if (entering >= 0) hash ^= entering_number(entering);
  entering = next;
  if (entering >= 0) hash ^= entering_number(entering);
}

bool Visited::contains(const BasisKey& key) const {
  const auto [begin, end] = keys_.equal_range(key.hash);
  for (auto known = begin; known != end; ++known)
    if (known->second.entering == key.entering && known->second.z_basic == key.z_basic) return true;
  return false;
}

bool Visited::insert(const BasisKey& key) {
  if (contains(key)) return false;
  keys_.emplace(key.hash, key);
  return true;
}

}  // namespace lcp
