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
  const std::size_t mask = slots_.size() - 1, words = key.z_basic.size();
  for (std::size_t slot = key.hash & mask;; slot = (slot + 1) & mask) {
    if (slots_[slot] == 0) return slot;
    const std::size_t number = static_cast<std::size_t>(slots_[slot]) - 1;
    if (seen_[number].hash == key.hash && seen_[number].entering == key.entering &&
        std::equal(key.z_basic.begin(), key.z_basic.end(), &words_[number * words]))
      return slot;
  }
}

void Visited::grow(std::size_t words) {
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), 0);
  seen_.reserve(slots_.size() / 2);
  words_.reserve(slots_.size() / 2 * words);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t number = 0; number < seen_.size(); ++number) {  // all different
    std::size_t slot = seen_[number].hash & mask;
    while (slots_[slot] != 0) slot = (slot + 1) & mask;
    slots_[slot] = static_cast<std::int32_t>(number + 1);
  }
}

bool Visited::insert(const BasisKey& key) {
  if (2 * seen_.size() >= slots_.size()) grow(key.z_basic.size());
  const std::size_t slot = slot_of(key);
  if (slots_[slot] != 0) return false;
  seen_.push_back({key.hash, key.entering});
  words_.insert(words_.end(), key.z_basic.begin(), key.z_basic.end());
  slots_[slot] = static_cast<std::int32_t>(seen_.size());
  return true;
}

void Visited::copy_key(Index number, BasisKey& key) const {
  const auto begin = words_.begin() + number * static_cast<Index>(key.z_basic.size());
  std::copy_n(begin, key.z_basic.size(), key.z_basic.begin());
  key.hash = seen_[number].hash;
  key.entering = seen_[number].entering;
}

}  // namespace lcp
