#include "problems/instance.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <stdexcept>

#include "solvers/errors.h"

namespace lcp {

namespace {

static_assert(std::endian::native == std::endian::little, "content_hash feeds doubles as they lie");

/// SHA-256 over numbers, each as eight bytes of an IEEE double.
class NumberHash {
 public:
  NumberHash() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    require(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }

  void add(double value) { add(&value, 1); }

  /// Counts and row numbers, which a double holds exactly.
  void add(Index value) { add(static_cast<double>(value)); }

  /// Shape, then column by column.
  void add(const MatrixXd& numbers) {
    add(numbers.rows());
    add(numbers.cols());
    add(numbers.data(), numbers.size());
  }

  void add(const std::vector<Index>& numbers) {
    add(static_cast<Index>(numbers.size()));
    for (const Index number : numbers) add(number);
  }

  std::string hexadecimal() {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned length = 0;
    require(EVP_DigestFinal_ex(context_.get(), digest, &length) == 1);
    std::string text;
    for (unsigned i = 0; i < length; ++i) text += fmt::format("{:02x}", digest[i]);
    return text;
  }

 private:
  /// Many numbers at once: one at a time takes OpenSSL twice as long.
  void add(const double* numbers, Index count) {
    constexpr Index most = 4096;
    double buffer[most];
    for (Index done = 0; done < count; done += most) {
      const Index size = std::min(most, count - done);
      // -0 + 0 is +0; every other number stays as it is.
      for (Index i = 0; i < size; ++i) buffer[i] = numbers[done + i] + 0.0;
      const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(size);
      require(EVP_DigestUpdate(context_.get(), buffer, bytes) == 1);
    }
  }

  static void require(bool done) {
    if (!done) throw std::runtime_error("OpenSSL refuses to compute a SHA-256");
  }

  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

std::string content_hash(const Problem& problem) {
  NumberHash hash;
  hash.add(problem.size());
  hash.add(problem.M);
  hash.add(problem.q);
  hash.add(problem.s_z);
  hash.add(problem.s_w);
  hash.add(problem.c);
  hash.add(problem.pivot_limit);
  hash.add(Index{problem.friction.has_value()});
  if (problem.friction)
    each_field(*problem.friction, [&](const char*, const auto& field) { hash.add(field); });
  return hash.hexadecimal();
}

std::string hash_with_previous(const Instance& instance) {
  if (!instance.previous) return instance.sha256;
  NumberHash hash;
  for (const char digit : instance.sha256) hash.add(Index{digit});
  hash.add(instance.previous->alpha);
  hash.add(instance.previous->z);
  return hash.hexadecimal();
}

void check(const Start& start, Index n, const std::string& where) {
  const auto fail = [&where](const std::string& what) {
    throw InvalidArgument("{}: {}", where, what);
  };
  for (std::size_t k = 0; k < start.alpha.size(); ++k) {
    const Index row = start.alpha[k];
    if (row < 0 || row >= n) fail(fmt::format("alpha holds row {}, expected 0 ... {}", row, n - 1));
    if (k > 0 && row <= start.alpha[k - 1])
      fail(fmt::format("alpha holds row {} behind row {}, expected ascending rows", row,
                       start.alpha[k - 1]));
  }
  if (start.z.size() != 0 && start.z.size() != n)
    fail(fmt::format("z has {} entries, expected {} or none", start.z.size(), n));
  if (!start.z.allFinite()) fail("z is not finite, expected finite numbers");
}

Instance make_instance(std::string name, Problem problem,
                       std::map<std::string, std::string> provenance) {
  const bool has_scales = problem.s_z.size() > 0 || problem.s_w.size() > 0;
  if (!has_scales && problem.M.size() > 0) set_plain_scales(problem);
  check(problem, name);
  Instance instance;
  instance.name = std::move(name);
  instance.problem = std::move(problem);
  instance.provenance = std::move(provenance);
  instance.sha256 = content_hash(instance.problem);
  return instance;
}

}  // namespace lcp
