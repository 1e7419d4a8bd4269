#include "harness/studies/suites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>

#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

/// Throws unless the family and the knobs of a spelling exist; generates nothing, which may take long.
void check_family(const std::string& text) {
  const Spelling spelling = parse_spelling(text);
  const auto row = std::find_if(families().begin(), families().end(), [&](const FamilyRow& each) {
    return each.info.name == spelling.name;
  });
  if (row == families().end()) throw std::invalid_argument(text);
  const std::unique_ptr<Family> family = row->make();
  apply(family->options(), spelling, row->info.name);
}

void check_scene(const std::string& text) {
  const Spelling spelling = parse_spelling(text);
  const auto row = std::find_if(scenes().begin(), scenes().end(), [&](const SceneRow& each) {
    return each.info.name == spelling.name;
  });
  if (row == scenes().end()) throw std::invalid_argument(text);
  const std::unique_ptr<Scene> scene = row->make();
  apply(scene->options(), spelling, row->info.name);
}

TEST(Suites, NameOnlySolversThatExistAndEachOnce) {
  for (const Suite& suite : suites()) {
    EXPECT_EQ(make_solvers(suite.solvers).size(), suite.solvers.size()) << suite.name;
    EXPECT_FALSE(suite.solvers.empty()) << suite.name;
  }
}

TEST(Suites, RunEveryRowOfOursThatDoesNotStayOutInTheOrderOfPlaces) {
  const std::vector<std::string> names = find_suite("default").solvers;
  std::vector<int> places;
  std::set<std::string> run;
  for (const std::string& name : names) {
    const RowInfo& info = find_row(parse_spelling(name).name).info;
    places.push_back(info.in_suites.place);
    run.insert(info.name);
  }
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
  for (const Row& row : registry())
    EXPECT_EQ(run.count(row.info.name) == 1,
              !row.info.peer() && !row.info.in_suites.settings.empty())
        << row.info.name;
  for (const char* suite : {"contact", "full", "scaling", "small"})
    EXPECT_EQ(find_suite(suite).solvers, names) << suite;
}

TEST(Suites, AreThoseTheUserWasPromised) {
  for (const char* name : {"default", "small", "contact", "paper", "peers", "scaling", "full"})
    EXPECT_GT(size(find_suite(name)), 0) << name;
}

TEST(Suites, NameOnlyFamiliesThatExist) {
  for (const Suite& suite : suites())
    for (const SuitePart& part : suite.parts)
      EXPECT_NO_THROW(part.scene.empty() ? check_family(part.family) : check_scene(part.scene))
          << part.spelling();
}

TEST(Suites, AreSortedByName) {
  EXPECT_TRUE(std::is_sorted(suites().begin(), suites().end(),
                             [](const Suite& a, const Suite& b) { return a.name < b.name; }));
}

TEST(Suites, GenerateAsManyInstancesAsTheySay) {
  EXPECT_EQ(static_cast<Index>(generate(find_suite("small")).size()), size(find_suite("small")));
  const Suite thin = {"thin", "", {{"published", 7, 3}, {"published", 4, 1}}, {}};
  EXPECT_EQ(size(thin), 3 + 4);
  EXPECT_EQ(generate(thin).size(), 7u);
}

TEST(Suites, HoldFramesOfScenesOneInSoMany) {
  SuitePart part;
  part.count = 4;
  part.every = 2;
  part.scene = "hoist:links=8,plates=1,lift=0,toss=0,clearance=0";
  const Suite suite = {"frames", "", {part}, {}};
  const std::vector<Instance> frames = generate(suite);
  ASSERT_EQ(static_cast<Index>(frames.size()), size(suite));
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(corpus_of(frames[0].name), make_scene(part.scene).spelling);
  EXPECT_TRUE(frames[0].problem.friction);
  EXPECT_NE(frames[0].sha256, frames[1].sha256);
}

TEST(Suites, UnknownOnesAreRefusedWithTheList) {
  try {
    find_suite("nosuch");
    FAIL() << "found";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("'nosuch', known are: "), std::string::npos);
    for (const Suite& suite : suites())
      EXPECT_NE(std::string(error.what()).find(suite.name), std::string::npos) << suite.name;
  }
}

std::vector<std::string> names(const std::vector<Instance>& instances) {
  std::vector<std::string> names;
  for (const Instance& instance : instances) names.push_back(instance.name);
  return names;
}

std::vector<Instance> two_corpora() {
  std::vector<Instance> instances;
  for (const char* name : {"a/0", "b/0", "a/1", "a/2", "b/1", "a/3"})
    instances.emplace_back().name = name;
  return instances;
}

TEST(Thinning, KeepsEveryKthOfEachCorpus) {
  EXPECT_EQ(names(thinned(two_corpora(), 2, 0)), (std::vector<std::string>{"a/0", "b/0", "a/2"}));
}

TEST(Thinning, KeepsTheFirstOfEachCorpus) {
  EXPECT_EQ(names(thinned(two_corpora(), 1, 1)), (std::vector<std::string>{"a/0", "b/0"}));
  EXPECT_EQ(names(thinned(two_corpora(), 1, 0)).size(), 6u);
}

}  // namespace
}  // namespace lcp
