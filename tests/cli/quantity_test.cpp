#include "harness/cli/quantity.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lcp::cli {
namespace {

using namespace std::chrono_literals;

TEST(Quantity, ReadsDurations) {
  EXPECT_EQ(parse_duration("10s", ""), 10s);
  EXPECT_EQ(parse_duration("0.5ms", ""), 500us);
  EXPECT_EQ(parse_duration("2min", ""), 2min);
}

TEST(Quantity, ReadsBytes) {
  EXPECT_EQ(parse_bytes("2GiB", ""), std::int64_t{2} << 30);
  EXPECT_EQ(parse_bytes("1.5KiB", ""), 1536);
}

TEST(Quantity, RefusesWhatIsNoPositiveQuantity) {
  for (const char* text : {"", "s", "10", "10 s", "0s", "-1s", "nans", "infs", "1e300s", "10sec"})
    EXPECT_THROW(parse_duration(text, "--timeout"), std::invalid_argument) << text;
}

}  // namespace
}  // namespace lcp::cli
