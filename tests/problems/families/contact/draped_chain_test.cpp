#include <gtest/gtest.h>

#include "problems/registry.h"
#include "solvers/registry.h"
#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

TEST(DrapedChain, HasTwentyFourContactsThatAllInfluenceOneAnother) {
  const Instance frame = generate("draped-chain", {.count = 1}).front();
  EXPECT_EQ(frame.problem.size(), 240);
  const MatrixXd& W = frame.problem.friction->W;
  EXPECT_EQ(W, W.transpose().eval());
  for (Index i = 0; i < 24; ++i)
    for (Index j = 0; j < 24; ++j)
      EXPECT_GT((W.block<3, 3>(3 * i, 3 * j).norm()), 1e-12 * W.norm()) << i << ", " << j;
}

TEST(DrapedChain, GoesOnFromTheFrameBeforeUntilItIsShakenAgain) {
  const std::vector<Instance> frames = generate("draped-chain:shake_every=2", {.count = 4});
  EXPECT_EQ(frames[0].provenance.at("start"), "seeded sliding and shaking");
  EXPECT_EQ(frames[1].provenance.at("start"), "forces of draped-chain:shake_every=2/0000");
  EXPECT_EQ(frames[2].provenance.at("start"), "seeded sliding and shaking");
  EXPECT_EQ(frames[3].provenance.at("start"), "forces of draped-chain:shake_every=2/0002");
  EXPECT_EQ(frames[3].provenance.at("fallbacks"), "0");
  // The pose moves too.
  EXPECT_NE(frames[0].problem.friction->W, frames[1].problem.friction->W);
}

TEST(DrapedChain, HeavierEndsChangeTheMobilityOfTheContacts) {
  const auto W = [](const char* family) {
    return generate(family, {.count = 1}).front().problem.friction->W;
  };
  EXPECT_GT((W("draped-chain:mass_ratio=1") - W("draped-chain:mass_ratio=100")).norm(),
            1e-3 * W("draped-chain:mass_ratio=1").norm());
}

TEST(DrapedChain, IsTheSameTwiceAndDiffersBetweenSeeds) {
  const std::vector<Instance> once = generate("draped-chain", {.count = 3, .seed = 2});
  const std::vector<Instance> again = generate("draped-chain", {.count = 3, .seed = 2});
  const std::vector<Instance> other = generate("draped-chain", {.count = 3, .seed = 3});
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_EQ(once[k].sha256, again[k].sha256);
    EXPECT_NE(once[k].sha256, other[k].sha256);
  }
}

TEST(DrapedChain, IsSolvedByTheSearch) {
  const NamedSolver solver = make_solver("best-first");
  for (const Instance& frame : generate("draped-chain", {.count = 4})) {
    const Result result = solver.solver->solve(frame.problem);
    EXPECT_EQ(to_string(result.claim), "solved") << frame.name;
    EXPECT_LT(cases::natural_residual(frame.problem, result.z), 1e-9) << frame.name;
  }
}

TEST(DrapedChain, FallsFreelyWhereNoBeadTouchesTheRod) {
  // Flung off the rod; the first frame still touches.
  const std::vector<Instance> frames =
      generate("draped-chain:shake_speed=0,slide_speed=20,shake_every=100", {.count = 60});
  EXPECT_GT(frames.front().problem.size(), 0);
  EXPECT_EQ(frames.back().problem.size(), 0);
}

TEST(DrapedChain, RefusesAChainThatCannotLieOnARod) {
  EXPECT_THROW(generate("draped-chain:links=8,wrapped=12", {.count = 1}), std::invalid_argument);
  EXPECT_THROW(generate("draped-chain:wrapped=2,bead_radius=0.5", {.count = 1}),
               std::invalid_argument);
}

}  // namespace
}  // namespace lcp
