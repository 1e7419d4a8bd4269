// tests/data/hard-frames: frames of hoist on which one attempt of the search fails; its README says
// why.

#include <gtest/gtest.h>

#include "harness/judge.h"
#include "harness/measure/solve.h"
#include "problems/io/load.h"

namespace lcp {
namespace {

class HardFrame : public testing::TestWithParam<const char*> {
 protected:
  Instance instance_ = load_instances(std::string(HARD_FRAMES) + "/" + GetParam()).front();

  Result solve(const std::string& solver) const {
    return solve_instance(*make_solver(solver).solver, instance_, {}, StartKind::two_step);
  }
  Verdict verdict(const Result& result) const { return judge(instance_, result, 1e-6).verdict; }
};

TEST_P(HardFrame, DefeatsOneAttempt) {
  const Result result = solve("best-first:patience=0,max_nodes=3000");
  EXPECT_NE(verdict(result), Verdict::solved);
  EXPECT_EQ(result.work.restarts, 0);
}

TEST_P(HardFrame, IsSolvedByALaterOne) {
  const Result result = solve("best-first");
  EXPECT_EQ(verdict(result), Verdict::solved) << result.message;
  EXPECT_GE(result.work.restarts, 1);
  EXPECT_LE(result.work.nodes, 4000);
}

INSTANTIATE_TEST_SUITE_P(Hoist, HardFrame,
                         testing::Values("hoist-05756.hdf5", "hoist-05884.hdf5", "hoist-05885.hdf5",
                                         "hoist-10ms-00439.hdf5"),
                         [](const auto& each) {
                           std::string name;
                           for (const char c : std::string(each.param))
                             if (std::isalnum(c)) name += c;
                           return name;
                         });

}  // namespace
}  // namespace lcp
