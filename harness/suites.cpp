#include "harness/suites.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>

namespace lcp {

namespace {

const std::vector<std::string>& own_solvers() {
  static const std::vector<std::string> all = {
      "lemke",
      "lexicographic:delta=0",
      "lexicographic:delta=1e-8",
      "lexicographic:delta=1e-6",
      "lexicographic:delta=1e-4",
      "lexicographic-pivot:delta=0",
      "lexicographic-pivot:delta=1e-8",
      "lexicographic-pivot:delta=1e-6",
      "lexicographic-pivot:delta=1e-4",
      "lemke-revised",
      "lexicographic-revised",
      "best-first",
      "best-first-lexicographic",
      "best-first-tableau:max_nodes=300",  // these two seldom end: more takes minutes
      "best-first-uniform:max_nodes=300",
      "projected-gauss-seidel",
  };
  return all;
}

/// {pivot tolerance off, on} x {tableau, factorised} x {no search, search}, everything else equal: the
/// same scale, epsilon, e_max and delta, lexicographic order, nothing polished, each basis of the
/// factorised rows factorised afresh.
const std::vector<std::string>& eight_cells() {
  static const std::vector<std::string> all = {
      "lexicographic:delta=1e-9,scale=on,pivot=0",
      "lexicographic:delta=1e-9,scale=on,pivot=1e-12",
      "lexicographic-revised:delta=1e-9,refactor_every=1,pivot=0",
      "lexicographic-revised:delta=1e-9,refactor_every=1,pivot=1e-12",
      "best-first-tableau:order=lexicographic,epsilon=1e-9,e_max=1e-6,scale=on,pivot=0,"
      "max_nodes=3000",
      "best-first-tableau:order=lexicographic,epsilon=1e-9,e_max=1e-6,scale=on,pivot=1e-12,"
      "max_nodes=3000",
      "best-first-lexicographic:polish=off,pivot=0,max_nodes=3000",
      "best-first-lexicographic:polish=off,pivot=1e-12,max_nodes=3000",
  };
  return all;
}

constexpr std::uint64_t suite_seed = 1;

Index drawn(const SuitePart& part) {
  if (part.count > 0) return part.count;
  const std::string name = parse_spelling(part.family).name;
  for (const FamilyRow& row : families())
    if (row.info.name == name) return row.info.default_count;
  throw std::invalid_argument(fmt::format("no family '{}', which a suite needs", name));
}

}  // namespace

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all = {
      {"contact",
       "both contact families in full",
       {{.family = "squat-like"}, {.family = "draped-chain"}},
       own_solvers()},
      {"default",
       "published instances and both contact families; under two minutes on two cores",
       {{.family = "published"}, {.family = "squat-like"}, {.family = "draped-chain"}},
       own_solvers()},
      {"eight-cells",
       "pivot tolerance, arithmetic and search, each on and off",
       {{.family = "draped-chain"},
        {.family = "squat-like"},
        {.family = "squat-like:contacts=64", .count = 60}},
       eight_cells(),
       64},
      {"small", "published instances", {{.family = "published"}}, own_solvers()},
  };
  return all;
}

const Suite& find_suite(const std::string& name) {
  std::vector<std::string> names;
  for (const Suite& suite : suites()) {
    names.push_back(suite.name);
    if (suite.name == name) return suite;
  }
  throw std::invalid_argument(
      fmt::format("unknown suite '{}', known are: {}", name, fmt::join(names, ", ")));
}

Index size(const Suite& suite) {
  Index total = 0;
  for (const SuitePart& part : suite.parts) total += (drawn(part) + part.every - 1) / part.every;
  return total;
}

std::vector<Instance> generate(const Suite& suite) {
  std::vector<Instance> all;
  for (const SuitePart& part : suite.parts) {
    std::vector<Instance> kept =
        thinned(generate(part.family, {.count = drawn(part), .seed = suite_seed}), part.every, 0);
    std::move(kept.begin(), kept.end(), std::back_inserter(all));
  }
  return all;
}

std::string corpus_of(const std::string& instance) {
  return instance.substr(0, instance.find('/'));
}

std::vector<Instance> thinned(std::vector<Instance> instances, Index every, Index limit) {
  std::map<std::string, Index> seen;
  std::vector<Instance> kept;
  for (Instance& instance : instances) {
    const Index place = seen[corpus_of(instance.name)]++;
    if (place % every == 0 && (limit == 0 || place / every < limit))
      kept.push_back(std::move(instance));
  }
  return kept;
}

}  // namespace lcp
