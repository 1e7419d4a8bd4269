#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/cli/program_test.h"

namespace lcp {
namespace {

class ShrinkCli : public ProgramTest {
 protected:
  void SetUp() override {
    ASSERT_EQ(run({"generate", "squat-like", "--count", "3", "--out", "three.hdf5"}).status, 0);
  }
  Ran shrink(const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {
        "shrink", "three.hdf5#squat-like/0001", "--solver", "lemke", "--keep", "failure", "--out",
        out};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  /// Nor is a file written.
  void expect_refused(const std::vector<std::string>& arguments, int status,
                      const std::string& words) {
    expect_complaint(arguments, status, words);
    EXPECT_FALSE(exists("x.hdf5"));
  }
};

TEST_F(ShrinkCli, WritesASmallerInstanceThatStillFailsTheSameBytesEachTime) {
  const Ran one = shrink("one.hdf5"), two = shrink("two.hdf5");
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_NE(one.out.find("shrunk/lemke-"), std::string::npos) << one.out;
  EXPECT_NE(one.out.find("nothing more can be taken away"), std::string::npos) << one.out;
  EXPECT_EQ(one.out, two.out);
  EXPECT_EQ(read_text(file("one.hdf5")), read_text(file("two.hdf5")));

  EXPECT_NE(run({"info", "one.hdf5"}).out.find("parent"), std::string::npos);
  EXPECT_EQ(run({"solve", "one.hdf5", "--solver", "lemke"}).out.find("lemke: solved"),
            std::string::npos);
  EXPECT_NE(run({"solve", "one.hdf5", "--solver", "best-first"}).out.find("best-first: solved"),
            std::string::npos);
}

TEST_F(ShrinkCli, StopsAtItsBudget) {
  const Ran ran = shrink("some.hdf5", {"--max-solves", "8"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("stopped: more may go"), std::string::npos) << ran.out;
}

TEST_F(ShrinkCli, SaysInOneLineWhatItCannotDo) {
  const std::string frame = "three.hdf5#squat-like/0001";
  expect_refused({"shrink", frame, "--solver", "best-first", "--out", "x.hdf5"}, 2,
                 "nothing fails");
  expect_refused({"shrink", frame, "--solver", "nosuch", "--out", "x.hdf5"}, 2, "'nosuch'");
  expect_refused(
      {"shrink", frame, "--solver", "best-first-tableau", "--by-rounding", "--out", "x.hdf5"}, 2,
      "lexicographic-revised");
  expect_refused({"shrink", "three.hdf5", "--solver", "lemke", "--out", "x.hdf5"}, 2,
                 "holds 3 instances");
  expect_refused({"shrink", frame, "--solver", "lemke", "--keep", "most", "--out", "x.hdf5"}, 2,
                 "--keep");
  expect_refused({"shrink", frame, "--solver", "lemke", "--timeout", "10", "--out", "x.hdf5"}, 2,
                 "--timeout 10");
  expect_refused({"shrink", "nosuch.hdf5", "--solver", "lemke", "--out", "x.hdf5"}, 3,
                 "nosuch.hdf5");
  expect_refused({"shrink", frame, "--solver", "lemke", "--out", "nosuch/x.hdf5"}, 4, "nosuch");
  expect_refused({"shrink", frame, "--solver", "lemke", "--out", "x.txt"}, 2, ".hdf5");
}

}  // namespace
}  // namespace lcp
