// `lcpbench simulate --picture` as its user meets it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/cli/program.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

class SimulatePicture : public testing::Test {
 protected:
  Ran run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"simulate", "squat", "--duration", "30ms"});
    return run_program(LCPBENCH, arguments, directory_.path());
  }
  void expect_complaint(const std::vector<std::string>& arguments, int status,
                        const std::vector<std::string>& words) {
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.status, status) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    for (const std::string& word : words)
      EXPECT_NE(ran.err.find(word), std::string::npos) << word << " in: " << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(std::filesystem::is_empty(directory_.path()));
  }
  std::string file(const std::string& name) const { return directory_.file(name); }
  bool exists(const std::string& name) const { return std::filesystem::exists(file(name)); }

 private:
  TemporaryDirectory directory_;
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
  expect_complaint({"--picture", "p.svg", "--at", "0,0.031"}, 2, {"0.031 s", "from 0 to 0.03 s"});
  expect_complaint({"--picture", "p.svg", "--at", "-1"}, 2, {"-1 s"});
  expect_complaint({"--picture", "p.svg", "--at", "0,soon"}, 2, {"--at soon", "numbers"});
  expect_complaint({"--picture", "p.svg", "--at", "nan"}, 2, {"nan"});
  expect_complaint({"--at", "0"}, 2, {"--at", "--picture"});
  expect_complaint({"--picture", "p.png"}, 2, {"--picture p.png", ".svg"});
}

TEST_F(SimulatePicture, APictureThatCannotBeWrittenIsStatusFourBeforeAnythingRuns) {
  expect_complaint({"--picture", "no/such/place.svg"}, 4, {"no/such/place.svg"});
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
