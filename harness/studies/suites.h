#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/registry.h"

namespace lcp {

/// Instances of one generated family, or frames of a scene.
struct SuitePart {
  std::string family = {};  ///< `name:key=value,...`
  Index count = 0;          ///< Instances drawn; 0 means the family's default.
  Index every = 1;          ///< Of these, the first and every `every`-th after it are kept.
  /// Instead of a family: of the frames with contact, as best-first drives them, so many are drawn.
  std::string scene = {};

  const std::string& spelling() const { return scene.empty() ? family : scene; }
};

/// A named choice of instances and of the solvers that meet on them.
struct Suite {
  std::string name;
  std::string summary;
  std::vector<SuitePart> parts;
  std::vector<std::string> solvers;  ///< Spellings, as make_solvers takes them.
  Index max_contacts = 60;           ///< Instances above get `not-run` rows.
};

const std::vector<Suite>& suites();

/// Throws std::invalid_argument with the list of suites.
const Suite& find_suite(const std::string& name);

/// Number of instances of a suite, without generating them.
Index size(const Suite& suite);

/// Generates the instances of a suite, all from seed 1, so that every run sees the same.
std::vector<Instance> generate(const Suite& suite);

/// How a suite draws one of its families.
struct FamilyDraw {
  std::string family;  ///< Full spelling.
  Index count = 1;     ///< Before instances are thinned.
  std::uint64_t seed = 1;
};

/// How a suite draws the family with this full spelling. Empty where it holds no such family (frames
/// of scenes come from no family), and where the suite itself is unknown: one of an older program.
std::optional<FamilyDraw> family_draw(const std::string& suite, const std::string& family);

/// The first and every `every`-th after it of each corpus of `instances`, at most `limit` (0: all)
/// of each, in their order.
std::vector<Instance> thinned(std::vector<Instance> instances, Index every, Index limit);

/// The corpus an instance belongs to: its name up to the first '/'.
std::string corpus_of(const std::string& instance);

}  // namespace lcp
