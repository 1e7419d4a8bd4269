#include "solvers/options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace lcp {
namespace {

enum class Colour { red, green };

struct Knobs {
  double width = 0.5;
  double length = NAN;
  Index steps = 3;
  Index most = 0;
  bool open = false;
  Colour colour = Colour::red;
  std::string driver = "none";

  OptionTable table() {
    return {real("width", width, 0, 1, ""),  real_or("length", length, 0, 1, "width", ""),
            count("steps", steps, 1, 9, ""), count_or("most", most, 1, 9, "auto", ""),
            flag("open", open, ""),          choice("colour", colour, ""),
            text("driver", driver, "")};
  }
  void set(const std::string& spelling) { apply(table(), parse_spelling(spelling), "knobs"); }
};

std::string message_of(const std::string& spelling) {
  Knobs knobs;
  try {
    knobs.set(spelling);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Options, AreSetByNameAndReadBack) {
  Knobs knobs;
  knobs.set("x:width=1e-3,length=0.25,steps=4,most=7,open=on,colour=green,driver=me");
  EXPECT_EQ(knobs.width, 1e-3);
  EXPECT_EQ(knobs.length, 0.25);
  EXPECT_EQ(knobs.steps, 4);
  EXPECT_EQ(knobs.most, 7);
  EXPECT_TRUE(knobs.open);
  EXPECT_EQ(knobs.colour, Colour::green);
  std::string read;
  for (const Option& option : knobs.table()) read += option.name + "=" + option.get() + " ";
  EXPECT_EQ(read, "width=0.001 length=0.25 steps=4 most=7 open=on colour=green driver=me ");
}

TEST(Options, AWordStandsForAValueDecidedLater) {
  Knobs knobs;
  EXPECT_EQ(knobs.table()[1].get(), "width");
  EXPECT_EQ(knobs.table()[3].get(), "auto");
  knobs.set("x:length=0.5,most=2");
  knobs.set("x:length=width,most=auto");
  EXPECT_TRUE(std::isnan(knobs.length));
  EXPECT_EQ(knobs.most, 0);
}

TEST(Options, RefuseWhatIsOutOfRangeAndSayWhatIsAllowed) {
  EXPECT_EQ(message_of("x:width=2"), "knobs: width=2: expected a real in [0, 1]");
  EXPECT_EQ(message_of("x:width=nan"), "knobs: width=nan: expected a real in [0, 1]");
  EXPECT_EQ(message_of("x:width=0.5x"), "knobs: width=0.5x: expected a real in [0, 1]");
  EXPECT_EQ(message_of("x:steps=0"), "knobs: steps=0: expected an integer in [1, 9]");
  EXPECT_EQ(message_of("x:steps=1.5"), "knobs: steps=1.5: expected an integer in [1, 9]");
  EXPECT_EQ(message_of("x:open=yes"), "knobs: open=yes: expected one of off, on");
  EXPECT_EQ(message_of("x:most=0"), "knobs: most=0: expected an integer in [1, 9]");
}

TEST(Options, RefuseUnknownKeysAndMalformedSettings) {
  EXPECT_EQ(message_of("x:height=1"),
            "knobs has no option 'height', it has: width, length, steps, most, open, colour, "
            "driver");
  EXPECT_EQ(message_of("x:width"), "'width' in 'x:width': expected key=value");
  EXPECT_EQ(message_of("x:width=1,"), "'' in 'x:width=1,': expected key=value");
  EXPECT_EQ(message_of("x:width=1,width=1"), "'width' is set twice in 'x:width=1,width=1'");
  EXPECT_EQ(message_of(":width=1"), "':width=1': expected name or name:key=value,key=value");
}

TEST(Options, ShortestNumbersReadBack) {
  for (const double value : {1e-8, 0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, 0.0})
    EXPECT_EQ(std::strtod(shortest(value).c_str(), nullptr), value);
}

}  // namespace
}  // namespace lcp
