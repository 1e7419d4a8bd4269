#pragma once

#include <string>
#include <vector>

#include "problems/instance.h"
#include "solvers/catalogue.h"

namespace lcp {

/// How many instances of a family and from which seed.
struct Draw {
  Index count = 1;
  std::uint64_t seed = 1;
  /// What instances' names begin with: the family in full spelling. generate() fills it.
  std::string corpus = {};
};

/// A generated family of instances with its knobs set. Deterministic: same knobs and draw, same bits.
/// Throws std::invalid_argument when the knobs contradict one another.
struct Family : Configured<std::vector<Instance>(const Draw&)> {
  static constexpr const char* kind = "family";
};

struct FamilyInfo {
  std::string name;
  std::string summary;
  std::string source;
  Index default_count = 1;  ///< Instances drawn when no --count is given.
};

using FamilyRow = CatalogueRow<FamilyInfo, Family>;
/// Registers a family; `draw(Knobs, Draw)` makes the instances.
using FamilyRegistration = Registered<FamilyInfo, Family>;

/// All families, sorted by name.
const std::vector<FamilyRow>& families();

/// `name:key=value,...` with the knobs that differ from their defaults alone, in their order: what
/// the names of the family's instances begin with. Throws std::invalid_argument with the list of what
/// is allowed.
std::string full_family_spelling(const std::string& text);

/// Draws instances of `name:key=value,...`; `draw.count` 0 means the family's default. Names are
/// `name:key=value,.../0000`..., with the knobs that differ from their defaults; provenance holds
/// family (full spelling) and seed. Throws
/// std::invalid_argument with the list of what is allowed.
std::vector<Instance> generate(const std::string& text, Draw draw);

}  // namespace lcp
