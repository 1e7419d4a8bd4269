#include "harness/measure/environment.h"

#include <gtest/gtest.h>

namespace lcp {
namespace {

TEST(Environment, HasTheSameIdExactlyWhenItIsTheSame) {
  EXPECT_EQ(describe_environment(1), describe_environment(1));
  EXPECT_NE(describe_environment(1)["id"], describe_environment(2)["id"]);
}

TEST(Environment, HasAnIdOfTwelveHexadecimalDigits) {
  const std::string id = describe_environment(1)["id"];
  EXPECT_EQ(id.size(), 12u);
  EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(Environment, SaysWhatTimesAndLastBitsDependOn) {
  const nlohmann::json environment = describe_environment(3);
  for (const char* text :
       {"cpu", "governor", "kernel", "compiler", "flags", "build_type", "commit"})
    EXPECT_FALSE(environment.at(text).get<std::string>().empty()) << text;
  EXPECT_NE(environment["flags"].get<std::string>().find("-ffp-contract=off"), std::string::npos);
  EXPECT_GE(environment.at("cores").get<int>(), 1);
  EXPECT_EQ(environment.at("jobs"), 3);
  EXPECT_TRUE(environment.contains("dirty"));
  for (const auto& [library, version] : environment.at("libraries").items())
    EXPECT_FALSE(version.get<std::string>().empty()) << library;
}

}  // namespace
}  // namespace lcp
