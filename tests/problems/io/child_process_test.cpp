#include "problems/io/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "problems/io/errors.h"
#include "tests/problems/io/files.h"

namespace lcp {
namespace {

constexpr unsigned plenty = 60;  // s

std::string death_of(unsigned seconds, const std::function<std::string()>& work) {
  return files::message_of<UnreadableInput>([&] { try_in_child("reading x", seconds, work); });
}

TEST(TryInChild, ReturnsWhatTheWorkReturned) {
  const std::string long_text(1 << 20, 'x');  // a pipe holds 64 KiB
  EXPECT_EQ(try_in_child("reading x", plenty, [&] { return long_text; }), long_text);
}

TEST(TryInChild, LeavesThisProcessAsItWas) {
  int touched = 0;
  try_in_child("reading x", plenty, [&] {
    touched = 1;
    return std::string();
  });
  EXPECT_EQ(touched, 0);
}

TEST(TryInChild, PassesOnTheMessageOfAnException) {
  EXPECT_EQ(
      death_of(plenty, []() -> std::string { throw std::runtime_error("x: 3 rows, expected 4"); }),
      "x: 3 rows, expected 4");
}

TEST(TryInChild, NamesTheSignalOfACrash) {
  EXPECT_EQ(death_of(plenty, []() -> std::string { std::abort(); }),
            "reading x: crashed with signal 6 (Aborted)");
}

TEST(TryInChild, NamesTheStatusOfAnEarlyExit) {
  EXPECT_EQ(death_of(plenty, []() -> std::string { _exit(7); }), "reading x: exited with status 7");
}

TEST(TryInChild, StopsWorkThatHangs) {
  EXPECT_EQ(death_of(1, [] { return std::string(static_cast<std::size_t>(pause()), ' '); }),
            "reading x: still not done after 1 s");
}

}  // namespace
}  // namespace lcp
