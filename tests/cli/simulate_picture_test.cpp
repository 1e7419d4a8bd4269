// `lcpbench simulate --picture` as its user meets it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

class SimulatePicture : public ProgramTest {
 protected:
  SimulatePicture() : ProgramTest({"simulate", "squat", "--duration", "30ms"}) {}
  /// Nor is a file written.
  template <class... Words>
  void expect_refused(const std::vector<std::string>& arguments, int status,
                      const Words&... words) {
    expect_complaint(arguments, status, words...);
    EXPECT_TRUE(std::filesystem::is_empty(directory()));
  }
};

TEST_F(SimulatePicture, DrawsTheMomentsAskedFor) {
  const Ran ran = run({"--picture", "squat.svg", "--at", "0,0.01,0.02,0.03"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const std::string svg = read_text(file("squat.svg"));
  for (const char* time : {"0.000 s", "0.010 s", "0.020 s", "0.029 s"})
    EXPECT_NE(svg.find(time), std::string::npos) << time;
  EXPECT_TRUE(exists("squat.gp"));
  EXPECT_TRUE(exists("squat.dat"));
}

TEST_F(SimulatePicture, DrawsStartMiddleAndEndUnlessTold) {
  EXPECT_EQ(run({"--picture", "squat.svg"}).status, 0);
  const std::string svg = read_text(file("squat.svg"));
  for (const char* time : {"0.000 s", "0.015 s", "0.029 s"})
    EXPECT_NE(svg.find(time), std::string::npos) << time;
}

TEST_F(SimulatePicture, RefusesTimesThatAreNone) {
  expect_refused({"--picture", "p.svg", "--at", "0,0.031"}, 2, "0.031 s", "from 0 to 0.03 s");
  expect_refused({"--picture", "p.svg", "--at", "-1"}, 2, "-1 s");
  expect_refused({"--picture", "p.svg", "--at", "0,soon"}, 2, "--at soon", "numbers");
  expect_refused({"--picture", "p.svg", "--at", "nan"}, 2, "nan");
  expect_refused({"--at", "0"}, 2, "--at", "--picture");
  expect_refused({"--picture", "p.png"}, 2, "--picture p.png", ".svg");
}

TEST_F(SimulatePicture, APictureThatCannotBeWrittenIsStatusFourBeforeAnythingRuns) {
  expect_refused({"--picture", "no/such/place.svg"}, 4, "no/such/place.svg");
}

TEST_F(SimulatePicture, WithoutGnuplotTheSummaryStillComesAndThePictureIsStatusFour) {
  const Ran ran = run_program(
      "/bin/sh",
      {"-c", "PATH=/nowhere " LCPBENCH " simulate squat --duration 10ms --picture p.svg"},
      file("."));
  EXPECT_EQ(ran.status, 4);
  EXPECT_NE(ran.out.find("frames with contact"), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("gnuplot-nox"), std::string::npos) << ran.err;
  EXPECT_FALSE(exists("p.svg"));
}

}  // namespace
}  // namespace lcp
