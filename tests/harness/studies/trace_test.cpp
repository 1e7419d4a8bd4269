#include "harness/studies/trace.h"

#include <gtest/gtest.h>

#include "harness/studies/laws/law_problems.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

TEST(Trace, NamesVariablesFromOne) {
  EXPECT_EQ(variable_name(0, 3), "w_1");
  EXPECT_EQ(variable_name(5, 3), "z_3");
  EXPECT_EQ(variable_name(6, 3), "z0");
}

/// z = (1), w = 2 z - 2: z0 enters for w_1, then z_1 for z0.
TEST(Trace, TellsThePivotsOfLemkeOnOneRow) {
  const Problem problem = plain_problem(MatrixXd::Constant(1, 1, 2.0), VectorXd::Constant(1, -2.0));
  Trace trace(problem);
  Call call;
  call.observer = trace.observer();
  make_solver("lemke").solver->solve(problem, call);
  ASSERT_EQ(trace.steps().size(), 2u);
  const nlohmann::ordered_json json = trace.json();
  EXPECT_EQ(json[0]["entering"], "z0");
  EXPECT_EQ(json[0]["leaving"], "w_1");
  EXPECT_EQ(json[1]["entering"], "z_1");
  EXPECT_EQ(json[1]["leaving"], "z0");
  EXPECT_DOUBLE_EQ(json[1]["ratio"].get<double>(), 1);
}

/// The basis {z_1, z_2} of M = diag(1, 4) is diag(1, 4) over max |M|, with condition 4.
TEST(Trace, ComputesTheConditionOfTheScaledBasis) {
  const Problem problem = plain_problem(MatrixXd{{1, 0}, {0, 4}}, VectorXd::Constant(2, -1.0));
  Trace trace(problem);
  const std::vector<int> basic = {2, 3};
  PivotEvent event;
  event.basic = &basic;
  trace.observer()(event);
  EXPECT_DOUBLE_EQ(trace.steps().at(0).condition.value(), 4);
}

TEST(Trace, LeavesTheConditionOutOnLargeProblems) {
  const Problem problem = plain_problem(MatrixXd::Identity(3, 3), VectorXd::Constant(3, -1.0));
  Trace trace(problem, {.largest_condition = 2});
  const std::vector<int> basic = {0, 1, 2};
  PivotEvent event;
  event.basic = &basic;
  trace.observer()(event);
  EXPECT_FALSE(trace.steps().at(0).condition);
}

TEST(Trace, ShowsNodesOnlyWhereASearchWentBack) {
  const Problem problem = plain_problem(MatrixXd::Identity(1, 1), VectorXd::Constant(1, -1.0));
  PivotEvent event;
  event.node = 1;
  Trace forward(problem), back(problem);
  forward.observer()(event);
  EXPECT_EQ(forward.text().find("parent"), std::string::npos);
  event.node = 5;
  back.observer()(event);
  EXPECT_NE(back.text().find("parent"), std::string::npos);
}

}  // namespace
}  // namespace lcp
