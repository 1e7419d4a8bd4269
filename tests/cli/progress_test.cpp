#include "harness/cli/progress.h"

#include <gtest/gtest.h>

namespace lcp {
namespace {

using std::chrono::seconds;

TEST(Progress, TellsTheTimeLeftFromTheTimeTaken) {
  const std::string line = progress_line({.done = 10, .total = 40, .at = "c/7"}, seconds(41));
  EXPECT_EQ(line, "[#######.......................] 10/40  time left 2:03  c/7");
}

TEST(Progress, PromisesNothingBeforeTheFirstPair) {
  const std::string line = progress_line({.done = 0, .total = 40, .at = ""}, seconds(1));
  EXPECT_EQ(line.find("left"), std::string::npos);
}

TEST(Progress, IsFullWhenThereIsNothingToDo) {
  EXPECT_EQ(progress_line({}, seconds(0)).find('.'), std::string::npos);
}

}  // namespace
}  // namespace lcp
