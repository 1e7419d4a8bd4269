#include "solvers/result.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace lcp {

const std::vector<Claim>& all_claims() {
  static const std::vector<Claim> claims = {Claim::solved,     Claim::ray,        Claim::exhausted,
                                            Claim::infeasible, Claim::cycle,      Claim::limit,
                                            Claim::singular,   Claim::unsupported};
  return claims;
}

std::string to_string(Claim claim) {
  switch (claim) {
    case Claim::solved:
      return "solved";
    case Claim::ray:
      return "ray";
    case Claim::exhausted:
      return "exhausted";
    case Claim::infeasible:
      return "infeasible";
    case Claim::cycle:
      return "cycle";
    case Claim::limit:
      return "limit";
    case Claim::singular:
      return "singular";
    case Claim::unsupported:
      return "unsupported";
  }
  return "?";
}

Claim claim_from_string(const std::string& name) {
  std::vector<std::string> names;
  for (const Claim claim : all_claims()) {
    names.push_back(to_string(claim));
    if (names.back() == name) return claim;
  }
  throw std::invalid_argument(
      fmt::format("unknown claim '{}', expected one of {}", name, fmt::join(names, ", ")));
}

Work& Work::operator+=(const Work& other) {
  pivots += other.pivots;
  path += other.path;
  nodes += other.nodes;
  generated += other.generated;
  largest_queue = std::max(largest_queue, other.largest_queue);
  replayed += other.replayed;
  factorisations += other.factorisations;
  sweeps += other.sweeps;
  start_pivots += other.start_pivots;
  restarts += other.restarts;
  frictionless_pivots += other.frictionless_pivots;
  return *this;
}

}  // namespace lcp
