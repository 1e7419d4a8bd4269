#include "harness/studies/sufficient/study.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/studies/sufficient/report.h"
#include "problems/scenes/scene.h"
#include "tests/harness/studies/sufficient/one_axis.h"

namespace lcp {
namespace {

TEST(Criteria, TheWorstOverItsToleranceDecides) {
  const Criteria criteria;
  const Drift error{.distance = 0.5e-3, .force = 0.03, .depth = 0.1e-3, .slip = 1e-3};
  EXPECT_DOUBLE_EQ(over_tolerance(error, criteria), 1.5);
  EXPECT_EQ(exceeded(error, criteria), std::vector<std::string>{"force"});
  EXPECT_TRUE(exceeded({}, criteria).empty());
}

TEST(Sufficient, FrictionlessIsRejectedOnHoist) {
  const Study study =
      made(plan_of("hoist:links=8,lift=0,toss=0,dt=0.002", 0.12, "friction", {"frictionless"}));
  ASSERT_EQ(study.rows.size(), 1u);
  const ModelRow& row = study.rows.front();
  EXPECT_TRUE(row.broken.empty()) << row.broken;
  EXPECT_FALSE(row.passes);
  EXPECT_LT(18 * row.n, 1.5 * study.reference.n) << "no tangential rows";
  EXPECT_FALSE(study.cheapest.has_value());
}

TEST(Sufficient, FourContactsAFootAreEnoughForSquat) {
  const Study study = made(plan_of("squat", 0.025, "contacts", {"reduction=deepest-4"}));
  const ModelRow& row = study.rows.front();
  EXPECT_TRUE(row.passes) << described({study}).text;
  EXPECT_LT(row.n, 0.8 * study.reference.n);
  EXPECT_LT(over_tolerance(study.disturbed.error, study.plan.criteria), 0.25);
}

TEST(Sufficient, AModelWhoseSolverFailsIsARow) {
  const Study study = made(plan_of("squat:points=8", 0.03, "solver", {"nan-maker", "crasher"},
                                   "best-first", {"nan-maker", "crasher"}));
  ASSERT_EQ(study.rows.size(), 2u);
  EXPECT_EQ(study.rows[0].failed, study.rows[0].frames);
  EXPECT_FALSE(study.rows[0].passes) << "no force holds the robot up";
  EXPECT_NE(study.rows[1].broken.find("crashed"), std::string::npos);
  EXPECT_FALSE(study.rows[1].passes);
  const std::string text = described({study}).text;
  EXPECT_NE(text.find("broke at t = 0 s: crashed"), std::string::npos) << text;
}

TEST(Sufficient, AReferenceThatBreaksIsNone) {
  EXPECT_THROW(made(plan_of("squat:points=8", 0.03, "", {}, "crasher")), std::runtime_error);
}

TEST(Sufficient, ComparesUntilTheDisturbedReferenceIsTooFarFromItself) {
  // In the air motions part in proportion to time: 1e-5 m at 0.1 to 2 mm/s.
  StudyPlan plan = plan_of("hoist:links=8", 0.1);
  plan.disturbance = 3e-4;
  plan.criteria.trajectory = 4e-5;
  plan.criteria.window = 0.005;
  const Study study = made(plan);
  EXPECT_LT(study.horizon, 0.1);
  EXPECT_GE(study.horizon, plan.criteria.window);
  EXPECT_NE(described({study}).text.find("later differences say nothing"), std::string::npos);
  plan.disturbance = 1;
  EXPECT_THROW(made(plan), std::runtime_error) << "nothing can be told at all";
}

TEST(Sufficient, CombinesWhatPassesAlone) {
  StudyPlan plan = plan_of("squat", 0.015, "contacts", {"reduction=paper"});
  plan.ladder.axes[0].rungs.push_back({.label = "directions=4", .knobs = {{"directions", "4"}}});
  const Study study = made(plan);
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    EXPECT_EQ(study.rows[i].axis == "combination", i >= 2);
    if (i >= 2) {
      EXPECT_EQ(study.rows[i].model.label, "directions=4 + reduction=paper");
      EXPECT_LT(study.rows[i].n, std::min(study.rows[0].n, study.rows[1].n));
    }
  }
  if (study.cheapest) {
    EXPECT_TRUE(study.rows[*study.cheapest].passes);
    EXPECT_TRUE(study.rows[*study.cheapest].cheaper);
  }
}

TEST(Sufficient, RefusesAPlanThatMeansNothing) {
  for (double StudyPlan::*field :
       {&StudyPlan::duration, &StudyPlan::disturbance, &StudyPlan::patience}) {
    StudyPlan plan = plan_of("squat", 0.02);
    plan.*field = 0;
    EXPECT_THROW(made(plan), std::invalid_argument);
  }
}

TEST(Sufficient, EndsWithoutAnAnswerWhenInterrupted) {
  const std::atomic<bool> interrupted = true;
  EXPECT_THROW(study(
                   plan_of("squat", 0.02), [](const Progress&) {}, interrupted),
               Interrupted);
}

TEST(SufficientReport, SaysWhereNothingTouches) {
  const char* told = "Nothing touches in this time";
  const auto text = [](const char* scene, double duration) {
    return described({made(plan_of(scene, duration))}).text;
  };
  EXPECT_NE(text("squat:points=8", 0.001).find(told), std::string::npos);
  EXPECT_EQ(text("squat:points=8", 0.01).find(told), std::string::npos);
}

TEST(SufficientReport, HasARowForEveryModelInEveryFormat) {
  const Study study =
      made(plan_of("squat:points=8", 0.02, "contacts", {"deepest-4", "reduction=paper"}));
  const std::string csv = described({study}).csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
            static_cast<std::ptrdiff_t>(study.rows.size() + 3));
  EXPECT_NE(described({study}).json.dump().find("\"reduction=paper\""), std::string::npos);
  EXPECT_NE(described({study, study}).text.find("Cheapest model that is enough:"),
            std::string::npos);
  EXPECT_EQ(described({study, study}).csv.size() - csv.size(), csv.size() - csv.find('\n') - 1)
      << "keys once";
}

}  // namespace
}  // namespace lcp
