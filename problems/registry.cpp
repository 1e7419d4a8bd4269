#include "problems/registry.h"

namespace lcp {

namespace {

using Families = Catalogue<FamilyInfo, Family>;

}  // namespace

const std::vector<FamilyRow>& families() { return Families::instance().rows(); }

std::string full_family_spelling(const std::string& text) {
  return Families::instance().make(text).spelling;
}

std::vector<Instance> generate(const std::string& text, Draw draw) {
  const FamilyRow::Made family = Families::instance().make(text);
  if (draw.count == 0) draw.count = family.info.default_count;
  draw.corpus = family.spelling;
  std::vector<Instance> instances = family.thing->run(draw);
  for (Instance& instance : instances) {
    instance.provenance["family"] = draw.corpus;
    instance.provenance["seed"] = std::to_string(draw.seed);
  }
  return instances;
}

}  // namespace lcp
