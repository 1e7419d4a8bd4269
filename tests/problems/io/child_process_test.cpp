#include "problems/io/child_process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <stdexcept>

#include "problems/io/errors.h"
#include "tests/problems/io/files.h"

namespace lcp {
namespace {

constexpr unsigned plenty = 60;  // s

std::string death_of(unsigned seconds, const std::function<void()>& work) {
  return files::message_of<UnreadableInput>([&] { try_in_child("reading x", seconds, work); });
}

TEST(TryInChild, ReturnsWhenTheWorkIsDone) {
  EXPECT_NO_THROW(try_in_child("reading x", plenty, [] {}));
}

TEST(TryInChild, LeavesThisProcessAsItWas) {
  int touched = 0;
  try_in_child("reading x", plenty, [&] { touched = 1; });
  EXPECT_EQ(touched, 0);
}

TEST(TryInChild, PassesOnTheMessageOfAnException) {
  EXPECT_EQ(death_of(plenty, [] { throw std::runtime_error("x: 3 rows, expected 4"); }),
            "x: 3 rows, expected 4");
}

TEST(TryInChild, NamesTheSignalOfACrash) {
  EXPECT_EQ(death_of(plenty, [] { raise(SIGKILL); }), "reading x: crashed with signal 9 (Killed)");
}

TEST(TryInChild, NamesTheStatusOfAnEarlyExit) {
  EXPECT_EQ(death_of(plenty, [] { _exit(7); }), "reading x: ended with status 7");
}

TEST(TryInChild, StopsWorkThatHangs) {
  EXPECT_EQ(death_of(1, [] { pause(); }), "reading x: still not done after 1 s");
}

}  // namespace
}  // namespace lcp
