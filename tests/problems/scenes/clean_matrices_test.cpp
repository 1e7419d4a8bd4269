// Clean twins of the contact matrices of every scene, as it is simulated.

#include <gtest/gtest.h>

#include "problems/decompositions.h"
#include "problems/scenes/scene.h"
#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::record;

class OnScenes : public testing::TestWithParam<std::string> {};

double least_eigenvalue(const MatrixXd& W) {
  const VectorXd values = symmetric_eigen((W + W.transpose()) / 2).values;
  return values(0) / values.maxCoeff();
}

TEST_P(OnScenes, HaveCleanTwinsThatDifferByRounding) {
  const SceneSetup setup = make_scene(GetParam()).setup;
  Simulation simulation(setup.system, setup.stepping);
  double apart = 0, clean = 0, ada = 0;
  Index frames = 0;  // with contact
  const auto compare = [&](const Frame& frame) {
    if (frame.contacts.size() == 0 || frames++ % 10 != 0) return;
    const ContactProblem twin = simulation.clean_contacts(frame);
    apart = std::max(apart, cases::relative_error(frame.contacts.W, twin.W));
    clean = std::min(clean, least_eigenvalue(twin.W));
    ada = std::min(ada, least_eigenvalue(frame.contacts.W));
  };
  for (Index step = 0; step < 500 && frames < 50; ++step)
    simulation.step(cases::solver_in_the_loop(), compare);
  EXPECT_EQ(frames, 50);
  EXPECT_LE(record("W", apart), 1e-9);
  EXPECT_GE(record("least eigenvalue", clean), -1e-15);
  record("least eigenvalue, ADA", ada);
}

INSTANTIATE_TEST_SUITE_P(All, OnScenes,
                         testing::Values("squat", "tap-dance", "hoist", "net", "ring"),
                         [](const auto& each) {
                           return each.param == "tap-dance" ? std::string("tap_dance") : each.param;
                         });

}  // namespace
}  // namespace lcp
