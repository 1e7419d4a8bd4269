#include "harness/studies/sufficient/ladder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "problems/scenes/scene.h"

namespace lcp {
namespace {

const ModelAxis* find(const ModelLadder& ladder, const std::string& name) {
  for (const ModelAxis& axis : ladder.axes)
    if (axis.name == name) return &axis;
  return nullptr;
}

Rungs richest(const ModelLadder& ladder) { return Rungs(ladder.axes.size(), 0); }

TEST(ModelLadder, TheReferenceIsTheRichestOfEveryAxis) {
  const ModelLadder ladder = make_ladder("ring", "best-first", {});
  const SceneModel reference = model_of(ladder, richest(ladder));
  EXPECT_EQ(reference.label, "reference");
  EXPECT_EQ(reference.solver, "best-first");
  const Stepping stepping = make_scene(reference.scene).setup.stepping;
  EXPECT_EQ(stepping.contact.friction.directions, 16);
  EXPECT_EQ(stepping.reduction.method, ReductionOptions::Method::none);
  EXPECT_EQ(stepping.matrix, Stepping::Matrix::clean);
  EXPECT_FALSE(stepping.contact.active_only);
}

TEST(ModelLadder, FrictionlessLeavesNothingTangential) {
  const ModelLadder ladder = make_ladder("hoist", "best-first", {});
  Rungs rungs = richest(ladder);
  ASSERT_EQ(ladder.axes[0].name, "friction");
  rungs[0] = ladder.axes[0].rungs.size() - 1;
  const SceneModel model = model_of(ladder, rungs);
  EXPECT_EQ(model.label, "frictionless");
  EXPECT_EQ(make_scene(model.scene).setup.system.mu, 0);
}

TEST(ModelLadder, AxesWhoseKnobIsGivenAreKept) {
  const ModelLadder ladder = make_ladder("hoist:links=8,directions=8,matrix=ada", "best-first", {});
  EXPECT_EQ(ladder.kept, (std::vector<std::string>{"friction", "matrix"}));
  EXPECT_EQ(find(ladder, "friction"), nullptr);
  const SceneModel reference = model_of(ladder, richest(ladder));
  EXPECT_NE(reference.scene.find("links=8"), std::string::npos) << reference.scene;
  EXPECT_EQ(make_scene(reference.scene).setup.stepping.contact.friction.directions, 8);
}

TEST(ModelLadder, AnotherFrictionCoefficientLeavesTheFrictionAxisAndNoneDoesNot) {
  const ModelLadder rough = make_ladder("squat:mu=0.3", "best-first", {});
  ASSERT_NE(find(rough, "friction"), nullptr);
  EXPECT_EQ(make_scene(model_of(rough, richest(rough)).scene).setup.system.mu, 0.3);
  Rungs rungs = richest(rough);
  rungs[0] = rough.axes[0].rungs.size() - 1;
  EXPECT_EQ(make_scene(model_of(rough, rungs).scene).setup.system.mu, 0);
  EXPECT_EQ(find(make_ladder("squat:mu=0", "best-first", {}), "friction"), nullptr);
}

TEST(ModelLadder, AFinerReferenceHasTheScenesOwnStepAsARung) {
  const ModelLadder ladder = make_ladder("squat", "best-first", {}, 0.0005);
  const ModelAxis* steps = find(ladder, "time step");
  ASSERT_NE(steps, nullptr);
  std::vector<std::string> labels;
  for (const Rung& rung : steps->rungs) labels.push_back(rung.label);
  EXPECT_EQ(labels,
            (std::vector<std::string>{"dt=0.0005", "dt=0.001", "dt=0.002", "dt=0.005", "dt=0.01"}));
  EXPECT_THROW(make_ladder("squat:dt=0.002", "best-first", {}, 0.0005), std::invalid_argument);
}

TEST(ModelLadder, SolversAskedForStandBelowTheLaddersOwnAndOnce) {
  const ModelLadder ladder =
      make_ladder("squat", "best-first", {"lexicographic-revised", "best-first"});
  const ModelAxis* solvers = find(ladder, "solver");
  EXPECT_EQ(solvers->rungs.front().label, "best-first");
  EXPECT_EQ(solvers->rungs.back().label, "lexicographic-revised");
  EXPECT_EQ(std::count_if(solvers->rungs.begin(), solvers->rungs.end(),
                          [](const Rung& rung) { return rung.label == "best-first"; }),
            1);
}

TEST(ModelLadder, RefusesUnknownNames) {
  EXPECT_THROW(make_ladder("sqat", "best-first", {}), std::invalid_argument);
  EXPECT_THROW(make_ladder("squat", "worst-first", {}), std::invalid_argument);
  EXPECT_THROW(make_ladder("squat", "best-first", {"lemkey"}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
