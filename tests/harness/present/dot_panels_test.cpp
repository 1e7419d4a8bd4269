#include "harness/present/dot_panels.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <stdexcept>

#include "problems/io/text/read_text.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

class DotPanels : public testing::Test {
 protected:
  /// What is drawn: a value and a height per line, an empty line between series.
  std::string drawn(const DotPage& page) {
    draw_dots(directory_.file("dots.svg"), page);
    EXPECT_NE(text("dots.svg").find("</svg>"), std::string::npos);
    return text("dots.dat");
  }
  std::string text(const char* name) {
    return read_text(directory_.file(name), "a chart", 1 << 20);
  }
  TemporaryDirectory directory_;
};

TEST_F(DotPanels, HaveAMarkPerValue) {
  EXPECT_EQ(drawn({"t", {"a", "b"}, {{"p", {"x", "y"}, {{0, {1, 2}}, {1, {0, none}}}}}, ""}),
            "1 -0.085\n2 0.915\n\n\n0 0.085\n\n\n");
}

TEST_F(DotPanels, TakeALogarithmicAxisForPositiveValuesFarApart) {
  const auto is_logarithmic = [this](const std::vector<double>& values) {
    drawn({"t", {"a"}, {{"p", {"x", "y"}, {{0, values}}}}, ""});
    return text("dots.gp").find("\nset logscale x") != std::string::npos;
  };
  EXPECT_TRUE(is_logarithmic({1, 31}));
  EXPECT_FALSE(is_logarithmic({1, 29}));
  EXPECT_FALSE(is_logarithmic({0, 31})) << "0 has no place on it";
}

TEST_F(DotPanels, NameTheRowsOnceWhereNeighboursShareThem) {
  const DotPanel panel{"p", {"a row"}, {{0, {1}}}};
  drawn({"t", {"a"}, {panel, panel, {"q", {"another"}, {{0, {1}}}}}, ""});
  const std::string script = text("dots.gp");
  const std::size_t first = script.find("'a row'");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(script.find("'a row'", first + 1), std::string::npos);
  EXPECT_NE(script.find("'another'"), std::string::npos);
}

TEST_F(DotPanels, WithoutAValueAreEmpty) {
  draw_dots(directory_.file("dots.svg"), {"t", {"a"}, {{"p", {"x"}, {{0, {none}}}}}, ""});
  EXPECT_EQ(std::filesystem::file_size(directory_.file("dots.dat")), 0u);
}

TEST_F(DotPanels, RefuseSeriesOfAnotherLength) {
  EXPECT_THROW(drawn({"t", {"a"}, {{"p", {"x", "y"}, {{0, {1}}}}}, ""}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
