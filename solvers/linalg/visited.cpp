#include "solvers/linalg/visited.h"

#include <algorithm>

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

void BasisKey::follow(const Labels& labels, Variable entered, Variable left, Variable next) {
  flip(labels, entered);
  flip(labels, left);
  set_entering(next);
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

std::size_t Visited::slot_of(const BasisKey& key) const {
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t slot = key.hash & mask;; slot = (slot + 1) & mask) {
    if (slots_[slot] == 0) return slot;
    const BasisKey& known = keys_[slots_[slot] - 1];
    if (known.hash == key.hash && known.entering == key.entering && known.z_basic == key.z_basic)
      return slot;
  }
}

void Visited::grow() {
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), 0);
  for (std::size_t number = 0; number < keys_.size(); ++number)
    slots_[slot_of(keys_[number])] = static_cast<std::int32_t>(number + 1);
}

bool Visited::insert(const BasisKey& key) {
  if (2 * keys_.size() >= slots_.size()) grow();
  const std::size_t slot = slot_of(key);
  if (slots_[slot] != 0) return false;
  keys_.push_back(key);
  slots_[slot] = static_cast<std::int32_t>(keys_.size());
  return true;
}

}  // namespace lcp
