#include "tests/problems/io/corruption.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <random>

namespace lcp::corruption {

namespace {

constexpr std::string_view digits = "0123456789.+-eE";
constexpr std::array<const char*, 24> numbers = {
    "0",          "-0",          "1",          "-1",
    "2",          "3",           "7",          "16384",
    "16385",      "1e9",         "65536",      "-2",
    "2147483647", "-2147483648", "4294967296", "9223372036854775807",
    "1e308",      "-1e308",      "1e999",      "1e-320",
    "nan",        "inf",         "0x10",       "1e"};
constexpr std::array<std::int64_t, 10> integers = {0,   1,     -1,    2,          127,
                                                   255, 32767, 65535, 2147483647, -2147483648};

class Damage {
 public:
  Damage(std::string bytes, std::uint64_t seed) : bytes_(std::move(bytes)), generator_(seed) {}

  void once() {
    switch (below(10)) {
      case 0:
        return flip();
      case 1:
        return overwrite(1);
      case 2:
        return bytes_.resize(below(bytes_.size() + 1));
      case 3:
        return insert(std::string(1 + below(8), static_cast<char>(below(256))));
      case 4:
        return cut();
      case 5:
        return insert(piece());
      case 6:
        return exchange();
      case 7:
        return overwrite(std::size_t{1} << below(4));
      default:
        return renumber();
    }
  }

  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : generator_() % bound; }
  std::string take() { return std::move(bytes_); }

 private:
  std::size_t place() { return below(bytes_.size()); }
  std::string piece() { return bytes_.substr(place(), 1 + below(64)); }
  void insert(const std::string& piece) { bytes_.insert(below(bytes_.size() + 1), piece); }

  void flip() {
    if (!bytes_.empty()) bytes_[place()] ^= static_cast<char>(1 << below(8));
  }

  void overwrite(std::size_t size) {
    if (bytes_.size() < size) return;
    const std::int64_t number =
        below(4) == 0 ? static_cast<std::int64_t>(generator_()) : integers[below(integers.size())];
    std::memcpy(&bytes_[below(bytes_.size() - size + 1)], &number, size);
  }

  void cut() {
    const std::size_t from = place();
    if (!bytes_.empty()) bytes_.erase(from, 1 + below(std::min<std::size_t>(64, bytes_.size())));
  }

  void exchange() {
    const std::size_t size = 1 + below(16);
    if (bytes_.size() < 2 * size) return;
    const std::size_t one = below(bytes_.size() - 2 * size + 1);
    const std::size_t two = one + size + below(bytes_.size() - one - 2 * size + 1);
    std::swap_ranges(bytes_.begin() + static_cast<std::ptrdiff_t>(one),
                     bytes_.begin() + static_cast<std::ptrdiff_t>(one + size),
                     bytes_.begin() + static_cast<std::ptrdiff_t>(two));
  }

  void renumber() {
    const std::size_t begin = bytes_.find_first_of(digits, place());
    if (begin == std::string::npos) return;
    const std::size_t end = std::min(bytes_.find_first_not_of(digits, begin), bytes_.size());
    bytes_.replace(begin, end - begin, numbers[below(numbers.size())]);
  }

  std::string bytes_;
  std::mt19937_64 generator_;
};

}  // namespace

std::string damaged(std::string bytes, std::uint64_t seed) {
  Damage damage(std::move(bytes), seed);
  // One damage leaves many files readable, several reach further.
  const std::size_t times = damage.below(2) == 0 ? 1 : 2 + damage.below(3);
  for (std::size_t i = 0; i < times; ++i) damage.once();
  return damage.take();
}

}  // namespace lcp::corruption
