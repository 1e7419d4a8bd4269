#include "problems/published.h"

#include <gtest/gtest.h>

#include <set>

#include "problems/registry.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

/// Relative to the largest number of what is compared; the instances are small and well scaled.
constexpr double rounding = 1e-12;

/// max_i |min(z_i, w_i)| over the largest of 1, |z|, |q|.
double residual(const Problem& problem, const VectorXd& z) {
  const VectorXd w = problem.M * z + problem.q;
  const double scale = std::max({1.0, z.cwiseAbs().maxCoeff(), problem.q.cwiseAbs().maxCoeff()});
  return z.cwiseMin(w).cwiseAbs().maxCoeff() / scale;
}

struct Case {
  Instance instance;
  ExpectedOutcome expected;
};

void PrintTo(const Case& one, std::ostream* out) {
  *out << one.instance.name << " with " << one.expected.solver;
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const PublishedInstance& published : published_instances())
    for (const ExpectedOutcome& expected : published.expected)
      cases.push_back({published.instance, expected});
  return cases;
}

/// published/cps-4.4.7 and lexicographic:delta=... become cps_4_4_7_lexicographic.
std::string test_name(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.instance.name.substr(std::string("published/").size()) + "_" +
                     parse_spelling(info.param.expected.solver).name;
  for (char& letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
  return name;
}

class PublishedOutcome : public testing::TestWithParam<Case> {};

TEST_P(PublishedOutcome, ComesOutOfTheRowItIsStatedFor) {
  const auto& [instance, expected] = GetParam();
  const Result result = make_solver(expected.solver).solver->solve(instance.problem);
  EXPECT_EQ(to_string(result.claim), to_string(expected.claim)) << result.message;
  if (expected.pivots) {
    EXPECT_EQ(result.work.pivots, *expected.pivots);
  }
  if (expected.claim == Claim::solved) {
    EXPECT_LE(residual(instance.problem, result.z), rounding);
  }
  if (expected.z) {
    EXPECT_LE((result.z - *expected.z).norm(), rounding * (1 + expected.z->norm()));
  }
}

INSTANTIATE_TEST_SUITE_P(Table, PublishedOutcome, testing::ValuesIn(all_cases()), test_name);

TEST(PublishedInstances, HaveSolutionsThatSolveThem) {
  int stated = 0;
  for (const auto& [instance, expected] : published_instances()) {
    if (!instance.known_solution) continue;
    EXPECT_LE(residual(instance.problem, *instance.known_solution), rounding) << instance.name;
    ++stated;
  }
  EXPECT_GT(stated, 0);
}

TEST(PublishedInstances, HaveNamesOfTheirOwnAndASource) {
  std::set<std::string> names;
  for (const auto& [instance, expected] : published_instances()) {
    EXPECT_TRUE(names.insert(instance.name).second) << instance.name;
    EXPECT_FALSE(instance.provenance.at("source").empty()) << instance.name;
    EXPECT_FALSE(expected.empty()) << instance.name;
  }
}

TEST(PublishedInstances, AllowTheExponentialFamiliesTwiceTheirPivots) {
  for (const auto& [instance, expected] : published_instances()) {
    const bool exponential = instance.name.starts_with("published/murty-exponential") ||
                             instance.name.starts_with("published/fathi");
    const Index n = instance.problem.size();
    EXPECT_EQ(instance.problem.pivot_limit, exponential ? Index{2} << n : 0) << instance.name;
  }
}

TEST(PublishedFamily, DrawsTheTableFromItsBeginning) {
  const std::vector<PublishedInstance>& table = published_instances();
  EXPECT_EQ(generate("published", {.count = 0}).size(), table.size());
  const std::vector<Instance> three = generate("published", {.count = 3});
  ASSERT_EQ(three.size(), 3u);
  for (std::size_t i = 0; i < three.size(); ++i) {
    EXPECT_EQ(three[i].name, table[i].instance.name);
    EXPECT_EQ(three[i].sha256, table[i].instance.sha256);
  }
}

TEST(PublishedFamily, RefusesToDrawMoreThanItHas) {
  const Index too_many = static_cast<Index>(published_instances().size()) + 1;
  EXPECT_THROW(generate("published", {.count = too_many}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
