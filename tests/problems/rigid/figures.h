#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace lcp::cases {

/// Keeps a figure with the running test's result (--gtest_output=xml), and prints it where
/// LCPBENCH_PRINT_FIGURES is set.
inline double record(const std::string& what, double figure) {
  testing::Test::RecordProperty(what, fmt::format("{:.6g}", figure));
  if (std::getenv("LCPBENCH_PRINT_FIGURES")) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    fmt::print("{}.{}  {}: {:.6g}\n", test->test_suite_name(), test->name(), what, figure);
  }
  return figure;
}

}  // namespace lcp::cases
