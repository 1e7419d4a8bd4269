#include "problems/registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace lcp {

namespace {

std::vector<FamilyRow>& rows() {
  static std::vector<FamilyRow> all;
  return all;
}

const FamilyRow& find_family(const std::string& name) {
  std::vector<std::string> names;
  for (const FamilyRow& row : rows()) {
    names.push_back(row.info.name);
    if (row.info.name == name) return row;
  }
  throw std::invalid_argument(
      fmt::format("unknown family '{}', known are: {}", name, fmt::join(names, ", ")));
}

}  // namespace

void FamilyRegistration::add(FamilyRow row) {
  const auto place = std::lower_bound(
      rows().begin(), rows().end(), row,
      [](const FamilyRow& a, const FamilyRow& b) { return a.info.name < b.info.name; });
  rows().insert(place, std::move(row));
}

const std::vector<FamilyRow>& families() { return rows(); }

std::string full_family_spelling(const std::string& text) {
  const Spelling spelling = parse_spelling(text);
  const FamilyRow& row = find_family(spelling.name);
  const std::unique_ptr<Family> family = row.make();
  apply(family->options(), spelling, row.info.name);
  return full_spelling(row.info.name, family->options(), row.make()->options());
}

std::vector<Instance> generate(const std::string& text, Draw draw) {
  const Spelling spelling = parse_spelling(text);
  const FamilyRow& row = find_family(spelling.name);
  const std::unique_ptr<Family> family = row.make();
  apply(family->options(), spelling, row.info.name);
  if (draw.count == 0) draw.count = row.info.default_count;
  draw.corpus = full_spelling(row.info.name, family->options(), row.make()->options());
  std::vector<Instance> instances = family->generate(draw);
  for (Instance& instance : instances) {
    instance.provenance["family"] = draw.corpus;
    instance.provenance["seed"] = std::to_string(draw.seed);
  }
  return instances;
}

}  // namespace lcp
