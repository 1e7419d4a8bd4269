#include <gtest/gtest.h>

#include "tests/harness/studies/sufficient/one_axis.h"

namespace lcp {
namespace {

TEST(Sufficient, FrictionlessIsRejectedOnTapDance) {
  const Study study = made(plan_of("tap-dance:dt=0.002", 0.36, "friction", {"frictionless"}));
  EXPECT_FALSE(study.rows.front().passes);
  EXPECT_EQ(study.horizon, 0.36) << "the reference itself is told apart from nothing";
}

}  // namespace
}  // namespace lcp
