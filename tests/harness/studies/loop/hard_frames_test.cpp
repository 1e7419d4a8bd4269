// tests/data/hard-frames: frames of hoist on which one attempt of the search fails, or failed once; its
// README says why.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/judge/judge.h"
#include "harness/measure/solve.h"
#include "problems/io/load.h"

namespace lcp {
namespace {

class StoredFrame : public testing::TestWithParam<const char*> {
 protected:
  Instance instance_ = load_instances(fmt::format("{}/{}.hdf5", HARD_FRAMES, GetParam())).front();

  Result solve(const std::string& solver) const {
    return solve_instance(*make_solver(solver).solver, instance_, {}, StartKind::two_step);
  }
  Verdict verdict(const Result& result) const { return judge(instance_, result, 1e-6).verdict; }
};

class HardFrame : public StoredFrame {};

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

class OnceHardFrame : public StoredFrame {};

TEST_P(OnceHardFrame, IsSolved) {
  const Result result = solve("best-first");
  EXPECT_EQ(verdict(result), Verdict::solved) << result.message;
  EXPECT_LE(result.work.nodes, 4000);
}

std::string name_of(const testing::TestParamInfo<const char*>& frame) {
  std::string name = frame.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Hoist, HardFrame,
                         testing::Values("hoist-02780", "hoist-05651", "hoist-07213",
                                         "hoist-08503"),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Hoist, OnceHardFrame,
                         testing::Values("hoist-05756", "hoist-05884", "hoist-05885",
                                         "hoist-10ms-00439"),
                         name_of);

}  // namespace
}  // namespace lcp
