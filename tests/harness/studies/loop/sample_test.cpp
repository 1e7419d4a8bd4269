// Frames of the robot's scenes, as `simulate --dump` wrote them: tests/data/scenes.hdf5 holds squat
// frames 17, 141, 659 and tap-dance frames 400, 2500, 9985 (friction, no friction; the first of each
// also with the composite body's matrix). Five of them kept a search by row order with a cost grid of
// 1e-9 busy for more than 1500 nodes.

#include <gtest/gtest.h>

#include "harness/judge/judge.h"
#include "problems/decompositions.h"
#include "problems/io/load.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

const std::vector<Instance>& sample() {
  static const std::vector<Instance> instances = load_instances(SCENES_SAMPLE);
  return instances;
}

bool frictional(const Instance& instance) {
  return instance.name.find("+frictionless") == std::string::npos;
}

Index solved(const std::string& solver) {
  const NamedSolver named = make_solver(solver);
  Index count = 0;
  for (const Instance& instance : sample())
    if (frictional(instance))
      count +=
          judge(instance, named.solver->solve(instance.problem), 1e-6).verdict == Verdict::solved;
  return count;
}

TEST(SceneSample, HoldsFramesOfBothScenes) {
  Index squats = 0, dances = 0;
  for (const Instance& instance : sample()) {
    squats += instance.name.starts_with("squat");
    dances += instance.name.starts_with("tap-dance");
    EXPECT_EQ(instance.sha256, content_hash(instance.problem)) << instance.name;
  }
  EXPECT_EQ(squats, 7);
  EXPECT_EQ(dances, 7);
}

TEST(SceneSample, TheSearchSolvesAllInFewNodes) {
  for (const char* row : {"best-first", "best-first-lexicographic"}) {
    const NamedSolver solver = make_solver(row);
    for (const Instance& instance : sample()) {
      const Result result = solver.solver->solve(instance.problem);
      EXPECT_EQ(judge(instance, result, 1e-6).verdict, Verdict::solved) << row << instance.name;
      EXPECT_LE(result.work.nodes, 400) << row << " " << instance.name;
    }
  }
}

TEST(SceneSample, FollowingASinglePathLosesFrames) {
  for (const char* row :
       {"lemke", "lexicographic", "lexicographic-pivot", "lemke-revised", "lexicographic-revised"})
    EXPECT_LT(solved(row), 8) << row;
}

TEST(SceneSample, MovesAsOneBody) {
  for (const Instance& instance : sample()) {
    if (!frictional(instance)) continue;
    const VectorXd values = singular_values(instance.problem.friction->W);
    EXPECT_GT(values(5), 1e-7 * values(0)) << instance.name;
    EXPECT_LT(values(6), 1e-9 * values(0)) << instance.name;
  }
}

}  // namespace
}  // namespace lcp
